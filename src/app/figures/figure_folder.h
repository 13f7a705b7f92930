// A folder of figures, with a record of which files carom wrote, from what, and whether they have
// changed since. A file that carom did not write is never replaced unless the user asks for it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figures/figure_words.h"
#include "media/film_writer.h"
#include "util/files/atomic_file.h"
#include "util/files/stored_file.h"

namespace carom {

/// A file as carom wrote it.
struct WrittenFile {
    std::string figure;   ///< name of its figure; empty: it belongs to the whole folder
    std::string inputs;   ///< fingerprint of everything that it was made from
    std::string content;  ///< fingerprint of its bytes; empty: not written yet
    std::string coming =
        {};  ///< fingerprint of the bytes that were about to be written; empty: none
};

/// A file to be written.
struct NewFile {
    std::string file;
    std::vector<std::uint8_t> bytes;
    std::string figure, inputs;  ///< as in WrittenFile
};

/// The texts of a figure, stored so that captions need no new run of the physics.
struct WrittenWords {
    std::string inputs;
    FigureWords words;
};

/// The contents of figures.json.
struct Manifest {
    std::string of;  ///< the scene or set whose figures these are
    std::map<std::string, WrittenFile> files;
    std::map<std::string, WrittenWords> figures;
};

/// Its usual name.
inline constexpr const char* figures_manifest = "figures.json";

class FigureFolder {
  public:
    /// Reads the record of the folder, which need not exist, from the file `manifest` in it. Throws
    /// UsageError if the folder holds files made from another scene, set or folder, or if that file
    /// is not a manifest of carom.
    FigureFolder(std::filesystem::path path, std::string of,
                 std::string manifest = figures_manifest);

    const Manifest& manifest() const { return manifest_; }

    /// Whether a file was made from these inputs and has not been changed since.
    bool is_current(const std::string& file, const std::string& inputs) const;

    /// Those of `files` that exist and were not written by carom, or were changed since.
    std::vector<std::string> foreign(std::span<const std::string> files) const;

    /// Writes files, each complete or not at all; a file that has these bytes already is not
    /// touched. The new fingerprints are recorded in the manifest first, so that files are
    /// recognised wherever the work is interrupted.
    void write(std::span<const NewFile> files);

    /// Writes a film that is finished to a file, and records it in the same way.
    void write(const FilmWriter& film, const std::string& file, const std::string& inputs);

    /// Gives files that are written in `files`, an AtomicFolder of this path, their names,
    /// together. `contents`: the fingerprint of each. The manifest is one of them in a new folder.
    void write(AtomicFolder& files, const std::map<std::string, std::string>& contents);

    void remember(const std::string& figure, WrittenWords words);

    /// Removes the files that carom wrote and that are not among `kept`, and adds them to
    /// `removed`. Returns those that others have changed, or that are outside the folder: they are
    /// left in place, but no longer recorded.
    std::vector<std::string> remove_all_but(const std::set<std::string>& kept,
                                            std::vector<std::string>& removed);

    /// Writes the manifest if its contents have changed; does not create it if there is nothing to
    /// record.
    void save();

  private:
    StoredFile stored(const std::string& file) const { return {path_, file}; }
    void announce(const std::string& file, const std::string& figure, const std::string& content);

    std::filesystem::path path_;
    std::string manifest_name_;
    std::string saved_;
    Manifest manifest_;
};

}  // namespace carom
