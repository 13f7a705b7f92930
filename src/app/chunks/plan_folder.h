// The folder of a plan: work that is divided into chunks, which other processes on other machines
// do in any order. Owns plan.json, the files beside it and the manifests of chunks; does not know
// what a chunk does.
//
// plan.json is written last and lists the fingerprints of all other files of the plan. A chunk
// writes its output under a temporary name and renames it, then its manifest: no locks are needed,
// and two processes may work on one chunk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runs/json.h"
#include "util/interrupt.h"
#include "util/pending/temporary.h"

namespace carom {

/// A part of the work.
struct PlannedChunk {
    int number = 0;                            ///< from 1
    std::int64_t first = 0, end = 0;           ///< of its frames or runs, counted from 0
    double seconds = 0.0;                      ///< expected, on one core
    std::int64_t memory_bytes = 0;             ///< expected at most, with one thread
    std::int64_t memory_bytes_per_thread = 0;  ///< of each further thread
    std::string start = {};                    ///< file that it begins from; empty: none

    std::int64_t count() const { return end - first; }
};

/// What a plan is of.
enum class PlanKind { film, sweep };

/// The header of a plan, as it stands in plan.json.
struct PlanHeader {
    PlanKind kind = PlanKind::film;
    Json request = {};  ///< all that the plan was made from: scene, options, build facts ("build")
    Json facts = {};    ///< what else readers want to know, by kind ("film", "sweep")
};

/// Texts by the names of files, whose bytes need not be UTF-8; and back.
Json texts_to_json(const std::map<std::string, std::string>& texts);
std::map<std::string, std::string> texts_from(const Json& json);

/// Writes a plan, in a hidden folder in its own. Until commit() an earlier one stays, with its
/// chunks.
class PlanWriter {
  public:
    /// Creates the folder if it is missing. Throws UsageError where it holds something else than a
    /// plan, SystemError.
    explicit PlanWriter(std::filesystem::path folder);
    ~PlanWriter();  ///< uncommitted: leaves all as it was
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

/// A plan that was written.
class PlanFolder {
  public:
    /// Throws UsageError where the folder holds no plan, or one that was changed since it was
    /// written, or of another version; SystemError where it cannot be read.
    explicit PlanFolder(std::filesystem::path folder);

    const std::filesystem::path& path() const { return folder_; }
    PlanKind kind() const;
    const Json& request() const { return contents_.at("request"); }

    /// What `read` makes of the contents of plan.json. Throws UsageError where they are not as it
    /// reads them.
    template <class Read>
    auto read_contents(const Read& read) const {
        try {
            return read(contents_);
        } catch (const Json::exception& error) {
            refuse(error.what());
        }
    }

    const std::vector<PlannedChunk>& chunks() const { return chunks_; }

    /// Fingerprints of the other files of the plan, by their names.
    const Json& files() const { return contents_.at("files"); }

    /// No output takes the place of a file of the plan or of its chunks from now on.
    void keep_files() const;

    /// Identifies the plan: a fingerprint of plan.json.
    std::string fingerprint() const;

    /// Throws UsageError if it is a plan of the other kind; `command` is what was asked for.
    void require(PlanKind kind, const std::string& command) const;

    /// The chunk of this number. Throws UsageError if there is none.
    const PlannedChunk& chunk(int number) const;

    /// A file of the plan. Throws SystemError where it is missing or was changed.
    std::string read(const std::string& name) const;

    /// Where the output of a chunk is, or will be.
    std::filesystem::path output(const PlannedChunk& chunk) const;

    /// Whether a chunk's output is there, whole, of this plan.
    bool is_done(const PlannedChunk& chunk) const;

    /// The numbers of those that are not.
    std::vector<int> missing() const;

    /// Writes the manifest of a chunk whose output is there. `build` is that of this process.
    void finish(const PlannedChunk& chunk, const Json& build, double seconds) const;

    /// Throws UsageError where chunks are missing, SystemError where an output is not what its
    /// manifest says, or was made by another build than the plan, unless `allow_mixed`.
    void require_all_done(bool allow_mixed) const;

    /// Throws UsageError where `build` is not that of the plan, with both.
    void require_same_build(const Json& build) const;

  private:
    [[noreturn]] void refuse(const std::string& cause) const;
    std::filesystem::path manifest(const PlannedChunk& chunk) const;
    Json read_manifest(const PlannedChunk& chunk) const;

    std::filesystem::path folder_;
    std::string text_;
    Json contents_;
    std::vector<PlannedChunk> chunks_;
};

/// Whether a path is a folder that holds a plan.
bool is_plan(const std::filesystem::path& path);

/// Whether a folder holds a plan that was made from the same request, and all of its files.
bool is_planned(const std::filesystem::path& folder, const Json& request);

}  // namespace carom
