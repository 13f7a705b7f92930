// A folder of figures: which of its files carom wrote, whether they are what it wrote, and from
// what. Nothing that carom did not write is ever replaced unasked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// A file as carom wrote it.
struct WrittenFile {
    std::string figure;   ///< whose; empty: of the whole folder
    std::string inputs;   ///< fingerprint of all that it was made from
    std::string content;  ///< fingerprint of its bytes; empty: it was not there yet
    std::string coming =
        {};  ///< of those that were about to replace them; empty: nothing was on its way
};

/// A file to be written.
struct NewFile {
    std::string file;
    std::vector<std::uint8_t> bytes;
    std::string figure, inputs;  ///< as of a WrittenFile
};

/// What a figure says, kept so that captions need no run of the physics.
struct WrittenWords {
    std::string inputs;
    std::string caption, alt;
};

/// What figures.json holds.
struct Manifest {
    std::string of;  ///< the scene or set whose figures these are
    std::map<std::string, WrittenFile> files;
    std::map<std::string, WrittenWords> figures;
};

/// Its usual name.
inline constexpr const char* figures_manifest = "figures.json";

class FigureFolder {
  public:
    /// Reads what is known of the folder, which need not exist, from the file `manifest` in it.
    /// Throws UsageError when it holds what was made of another scene, set or folder, or when that
    /// file is not carom's.
    FigureFolder(std::filesystem::path path, std::string of,
                 std::string manifest = figures_manifest);

    const Manifest& manifest() const { return manifest_; }

    /// Whether a file was made from these inputs and is what it was then.
    bool is_current(const std::string& file, const std::string& inputs) const;

    /// Those of `files` that are there and were not written by carom, or changed since.
    std::vector<std::string> foreign(std::span<const std::string> files) const;

    /// Writes files, each whole or not at all, unless these very bytes are there. figures.json
    /// says first what they will be: wherever the work is cut off, the folder knows its files.
    void write(std::span<const NewFile> files);

    /// Takes a file of `from` that others have written into the folder, in the same way.
    void take_in(const std::filesystem::path& from, const std::string& file,
                 const std::string& figure, const std::string& inputs);

    void remember(const std::string& figure, WrittenWords words);

    /// Removes the files that carom wrote and that are not among `kept`, and tells them. Gives
    /// those that others have changed, or that lie outside of the folder: they are left, and no
    /// longer known.
    std::vector<std::string> remove_all_but(const std::set<std::string>& kept,
                                            std::vector<std::string>& removed);

    /// Writes figures.json, if it says anything new; not where there was none and no file is known.
    void save();

  private:
    void announce(const std::string& file, const std::string& figure, const std::string& content);

    std::filesystem::path path_;
    std::string manifest_name_;
    std::string saved_;
    Manifest manifest_;
};

}  // namespace carom
