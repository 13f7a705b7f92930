// The folder of a plan: work divided into chunks that several processes, also on several machines,
// do in any order. This module owns plan.json, the other files of the plan and the manifests of
// chunks; it does not know what a chunk does.
//
// plan.json is written last and lists the fingerprints of all other files of the plan. The process
// that does a chunk writes the output under a temporary name and renames it, then does the same
// with the manifest: no locks are needed, and two processes may work on one chunk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runs/json.h"
#include "util/files/stored_file.h"
#include "util/interrupt.h"
#include "util/pending/temporary.h"

namespace carom {

/// A part of the work.
struct PlannedChunk {
    int number = 0;                   ///< from 1
    std::int64_t first = 0, end = 0;  ///< its frames or runs are [first, end), counted from 0
    double seconds = 0.0;             ///< expected, on one core
    std::int64_t memory_bytes = 0;    ///< upper estimate, with one thread
    std::int64_t memory_bytes_per_thread = 0;  ///< upper estimate for each further thread
    std::string start = {};  ///< file with the state that it begins from; empty: none

    std::int64_t count() const { return end - first; }
};

/// The kind of work that is planned.
enum class PlanKind { film, sweep };

/// The header of a plan, as written in plan.json.
struct PlanHeader {
    PlanKind kind = PlanKind::film;
    Json request = {};  ///< all that the plan was made from: scene, options, build facts ("build")
    Json facts = {};    ///< further information for readers, by kind ("film", "sweep")
};

/// Texts by file name, as JSON and back. The bytes of the names need not be UTF-8.
Json texts_to_json(const std::map<std::string, std::string>& texts);
std::map<std::string, std::string> texts_from(const Json& json);

/// Writes a plan, first into a hidden folder inside the plan's folder. Until commit() an earlier
/// plan in that folder stays, with its chunks.
class PlanWriter {
  public:
    /// Creates the folder if it is missing. Throws UsageError if it holds anything else than a
    /// plan, SystemError if it cannot be written.
    explicit PlanWriter(std::filesystem::path folder);
    ~PlanWriter();  ///< without commit(): leaves everything as it was
    PlanWriter(const PlanWriter&) = delete;
    PlanWriter& operator=(const PlanWriter&) = delete;

    /// Adds a file of the plan, by its name in the folder ("starts/0001.start").
    void write(const std::string& name, std::string_view bytes);

    void commit(const PlanHeader& header, const std::vector<PlannedChunk>& chunks);

  private:
    void replace_earlier();

    std::filesystem::path folder_;
    TemporaryFile draft_;
    MustCleanUp hidden_;           ///< the draft
    Json files_ = Json::object();  ///< fingerprints by name
    bool is_new_ = false;          ///< the folder
    bool is_committed_ = false;
};

/// Reads a plan that was written, and keeps account of its chunks.
class PlanFolder {
  public:
    /// Throws UsageError if the folder holds no plan, or if the plan was changed after it was
    /// written or has another format version; SystemError if it cannot be read.
    explicit PlanFolder(std::filesystem::path folder);

    const std::filesystem::path& path() const { return folder_; }
    PlanKind kind() const;
    const Json& request() const { return contents_.at("request"); }

    /// Returns read(contents of plan.json). Throws UsageError if `read` throws Json::exception
    /// because the contents do not have the expected form.
    template <class Read>
    auto read_contents(const Read& read) const {
        try {
            return read(contents_);
        } catch (const Json::exception& error) {
            refuse(cause_of(error));
        }
    }

    const std::vector<PlannedChunk>& chunks() const { return chunks_; }

    /// Fingerprints of the other files of the plan, by their names.
    const Json& files() const { return contents_.at("files"); }

    /// From now on outputs that would replace a file of the plan or of its chunks are refused.
    void keep_files() const;

    /// Identifies the plan: a fingerprint of plan.json.
    std::string fingerprint() const;

    /// Throws UsageError if the plan is of the other kind; `command` is the command of the user,
    /// for the message.
    void require(PlanKind kind, const std::string& command) const;

    /// The chunk of this number. Throws UsageError if there is none.
    const PlannedChunk& chunk(int number) const;

    /// A file of the plan. Throws SystemError where it is missing or was changed.
    std::string read(const std::string& name) const;

    /// The file of the output of a chunk, which need not exist yet.
    StoredFile output(const PlannedChunk& chunk) const;

    /// Whether the output of a chunk exists, is complete and belongs to this plan.
    bool is_done(const PlannedChunk& chunk) const;

    /// The numbers of the chunks that are not done.
    std::vector<int> missing() const;

    /// Writes the manifest of a chunk whose output exists. `build` are the build facts of this
    /// process.
    void finish(const PlannedChunk& chunk, const Json& build, double seconds) const;

    /// Throws UsageError if chunks are missing, SystemError if an output does not match its
    /// manifest or, unless `allow_mixed`, was made by another build than the plan.
    void require_all_done(bool allow_mixed) const;

    /// Throws UsageError, naming both, if `build` differs from the build facts of the plan.
    void require_same_build(const Json& build) const;

  private:
    [[noreturn]] void refuse(const std::string& cause) const;
    StoredFile manifest(const PlannedChunk& chunk) const;
    Json read_manifest(const PlannedChunk& chunk) const;

    std::filesystem::path folder_;
    std::string text_;
    Json contents_;
    std::vector<PlannedChunk> chunks_;
};

/// Whether a path is a folder that holds a plan.
bool is_plan(const std::filesystem::path& path);

/// Whether a folder holds a plan made from the same request, with all of its files unchanged.
bool is_planned(const std::filesystem::path& folder, const Json& request);

}  // namespace carom
