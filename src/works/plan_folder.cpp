#include "works/plan_folder.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"
#include "util/files/links.h"
#include "util/files/new_file.h"
#include "util/files/one_use_paths.h"
#include "util/files/utf8_names.h"
#include "util/fingerprint.h"
#include "util/text.h"
#include "works/build_facts.h"
#include "works/plan_files.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr int format_version = 1;
constexpr std::int64_t most_bytes_of_file = std::int64_t{64} << 30;

const char* name_of(PlanKind kind) { return kind == PlanKind::film ? "film" : "sweep"; }
const char* unit_of(PlanKind kind) { return kind == PlanKind::film ? "frame" : "run"; }
const char* chunk_ending(PlanKind kind) { return kind == PlanKind::film ? ".chunk" : ".runs"; }

[[noreturn]] void fail(const char* what, const fs::path& path, int error) {
    throw_system_error(fmt::format("cannot {} {}: {}", what, path.string(),
                                   std::generic_category().message(error)),
                       error);
}

std::span<const std::uint8_t> as_bytes(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string stem_of(int chunk) { return fmt::format("chunks/{:04}", chunk); }

// Gives the first and the last frame or run (inclusive), numbered from 0 as in panels and files.
Json to_json(const PlannedChunk& chunk, PlanKind kind) {
    const std::string unit = unit_of(kind);
    Json json{{"chunk", chunk.number},
              {"first_" + unit, chunk.first},
              {"last_" + unit, chunk.end - 1},
              {"output", stem_of(chunk.number) + chunk_ending(kind)},
              {"manifest", stem_of(chunk.number) + ".json"},
              {"seconds", chunk.seconds},
              {"memory_bytes", chunk.memory_bytes},
              {"memory_bytes_per_thread", chunk.memory_bytes_per_thread}};
    if (!chunk.start.empty()) json["start"] = chunk.start;
    return json;
}

std::string start_of(int chunk) { return fmt::format("starts/{:04}.start", chunk); }

// Throws Json::exception if the JSON does not describe a chunk.
PlannedChunk chunk_of(const Json& json, PlanKind kind) {
    const std::string unit = unit_of(kind);
    return {.number = whole_in<int>(json.at("chunk")),
            .first = whole_in<std::int64_t>(json.at("first_" + unit)),
            .end = std::int64_t{whole_in<std::int32_t>(json.at("last_" + unit))} + 1,
            .seconds = json.at("seconds"),
            .memory_bytes = whole_in<std::int64_t>(json.at("memory_bytes")),
            .memory_bytes_per_thread = whole_in<std::int64_t>(json.at("memory_bytes_per_thread")),
            .start = json.value("start", "")};
}

// File names are made from the numbers of chunks, so that number and start file must be as
// expected.
bool is_chunk(const PlannedChunk& its, int number) {
    return its.number == number && its.first >= 0 && its.first < its.end &&
           (its.start.empty() || its.start == start_of(number));
}

// The chunks of a plan; nothing if any part of the contents is invalid. Throws Json::exception if a
// part is missing or has the wrong type.
std::optional<std::vector<PlannedChunk>> chunks_in(const Json& contents, PlanKind kind) {
    const Json &request = contents.at("request"), &files = contents.at("files");
    if (!request.is_object() || !request.at("build").is_object() || !files.is_object())
        return std::nullopt;
    if (contents.at("chunks").empty()) return std::nullopt;
    std::vector<PlannedChunk> chunks;
    for (const Json& chunk : contents.at("chunks")) {
        chunks.push_back(chunk_of(chunk, kind));
        const std::size_t count = chunks.size();
        if (!is_chunk(chunks.back(), static_cast<int>(count)) ||
            (count > 1 && chunks.back().first != chunks[count - 2].end))
            return std::nullopt;
    }
    return chunks;
}

// The fingerprint of plan.json without its own "fingerprint" entry.
std::string fingerprint_of(Json contents) {
    contents.erase("fingerprint");
    return fingerprint(text_of(contents));
}

// Renames of files and folders, all of which are undone unless keep() is called.
class Moves {
  public:
    Moves() = default;
    ~Moves() {
        std::error_code error;
        for (auto move = done_.rbegin(); move != done_.rend(); ++move)
            fs::rename(move->second, move->first, error);
    }
    Moves(const Moves&) = delete;
    Moves& operator=(const Moves&) = delete;

    // Does nothing if `from` does not exist.
    void move(const fs::path& from, const fs::path& to) {
        if (!is_taken(from)) return;
        std::error_code error;
        done_.emplace_back(from, to);
        fs::rename(from, to, error);
        if (!error) return;
        done_.pop_back();
        fail("replace", to, error.value());
    }
    void keep() { done_.clear(); }

  private:
    std::vector<std::pair<fs::path, fs::path>> done_;
};

// The first few of a list of numbers, and how many more there are.
std::string shortened(std::vector<std::string> numbers) {
    constexpr std::size_t most = 12;
    if (numbers.size() <= most) return fmt::format("{}", fmt::join(numbers, ", "));
    const std::size_t rest = numbers.size() - most;
    numbers.resize(most);
    return fmt::format("{} and {} more", fmt::join(numbers, ", "), rest);
}

}  // namespace

Json texts_to_json(const std::map<std::string, std::string>& texts) {
    Json json = Json::object();
    for (const auto& [name, text] : texts) json[utf8_of_name(name)] = text;
    return json;
}

std::map<std::string, std::string> texts_from(const Json& json) {
    std::map<std::string, std::string> texts;
    for (const auto& [name, text] : json.items())
        texts[name_of_utf8(name)] = text.get<std::string>();
    return texts;
}

PlanWriter::PlanWriter(fs::path folder) : folder_(std::move(folder)) {
    refuse_other_files(folder_);
    std::error_code error;
    is_new_ = !fs::exists(folder_, error);
    fs::create_directories(folder_, error);
    if (error) fail("create the folder", folder_, error.value());
    draft_ = temporary_folder(folder_ / "plan");
    if (draft_.descriptor >= 0) return;
    const int cause = errno;
    if (is_new_) fs::remove(folder_, error);
    fail("write", folder_, cause);
}

PlanWriter::~PlanWriter() {
    discard(draft_);
    std::error_code error;
    if (is_new_ && !is_committed_) fs::remove(folder_, error);
}

void PlanWriter::write(const std::string& name, std::string_view bytes) {
    std::error_code error;
    const fs::path path = draft_.name / name;
    fs::create_directories(path.parent_path(), error);
    if (error) fail("create the folder", (folder_ / name).parent_path(), error.value());
    write_new_file(path, as_bytes(bytes), folder_ / name);
    files_[name] = fingerprint(bytes);
}

// plan.json is moved away first and put in place last: in between the folder does not count as a
// plan.
void PlanWriter::replace_earlier() {
    const MustCleanUp together;
    Moves moves;
    const fs::path earlier = draft_.name / "earlier";
    std::error_code error;
    fs::create_directory(earlier, error);
    if (error) fail("write", folder_, error.value());
    for (const std::string_view name : names_in_plan) moves.move(folder_ / name, earlier / name);
    for (auto name = names_in_plan.rbegin(); name != names_in_plan.rend(); ++name)
        moves.move(draft_.name / *name, folder_ / *name);
    moves.keep();
    note_output();
}

void PlanWriter::commit(const PlanHeader& header, const std::vector<PlannedChunk>& chunks) {
    Json contents{{"format", format_of_plans},
                  {"format_version", format_version},
                  {"kind", name_of(header.kind)},
                  {"request", header.request}};
    for (const auto& [name, value] : header.facts.items()) contents[name] = value;
    contents["files"] = files_;
    contents["chunks"] = Json::array();
    for (const PlannedChunk& chunk : chunks)
        contents["chunks"].push_back(to_json(chunk, header.kind));
    contents["fingerprint"] = fingerprint_of(contents);
    write_new_file(draft_.name / "plan.json", as_bytes(text_of(contents, 2) + "\n"),
                   folder_ / "plan.json");
    throw_if_interrupted();
    replace_earlier();
    is_committed_ = true;
}

PlanFolder::PlanFolder(fs::path folder) : folder_(std::move(folder)) {
    if (!is_plan(folder_))
        throw UsageError(
            fmt::format("{} holds no plan (plan.json); make one with carom plan SCENE -o {}",
                        folder_.string(), folder_.string()));
    contents_ = json_in(read_file(StoredFile{folder_, "plan.json"}, most_json_bytes));
    if (!is_from_carom(contents_, "plan.json"))
        throw UsageError(
            fmt::format("{}: this is not a plan of carom; name the folder of one, or plan into "
                        "another",
                        (folder_ / "plan.json").string()));
    refuse_scenes_in(folder_);
    if (const Json version = contents_.value("format_version", Json()); version != format_version)
        refuse(fmt::format("its format has version {}, and this program reads version {}",
                           text_of(version), format_version));
    if (contents_.value("fingerprint", Json()) != fingerprint_of(contents_))
        refuse("it was changed after it was written");
    auto chunks = read_contents([&](const Json& contents) { return chunks_in(contents, kind()); });
    if (!chunks) refuse("its parts do not fit together");
    chunks_ = std::move(*chunks);
}

void PlanFolder::refuse(const std::string& cause) const {
    throw UsageError(fmt::format("{}: {}; plan again", (folder_ / "plan.json").string(), cause));
}

PlanKind PlanFolder::kind() const {
    return contents_.value("kind", Json()) == name_of(PlanKind::film) ? PlanKind::film
                                                                      : PlanKind::sweep;
}

void PlanFolder::keep_files() const {
    keep_source(folder_ / "plan.json");
    for (const auto& [name, content] : files().items()) keep_source(folder_ / name);
    for (const PlannedChunk& chunk : chunks_)
        for (const StoredFile& file : {output(chunk), manifest(chunk)}) keep_source(file.path());
}

std::string PlanFolder::fingerprint() const { return contents_.at("fingerprint"); }

void PlanFolder::require(PlanKind wanted, const std::string& command) const {
    if (kind() != wanted)
        throw UsageError(fmt::format("{} is the plan of a {}, and carom {} works on that of a {}",
                                     folder_.string(), name_of(kind()), command, name_of(wanted)));
}

const PlannedChunk& PlanFolder::chunk(int number) const {
    if (number < 1 || number > static_cast<int>(chunks_.size()))
        throw UsageError(fmt::format("--chunk {}: the chunks of {} have the numbers 1 to {}",
                                     number, folder_.string(), chunks_.size()));
    return chunks_[static_cast<std::size_t>(number) - 1];
}

std::string PlanFolder::read(const std::string& name) const {
    std::string bytes = read_file(StoredFile{folder_, name}, most_bytes_of_file);
    if (files().value(name, Json()) != carom::fingerprint(bytes))
        throw SystemError(fmt::format("cannot read {}: it was changed after it was written",
                                      (folder_ / name).string()));
    return bytes;
}

StoredFile PlanFolder::output(const PlannedChunk& chunk) const {
    return {folder_, stem_of(chunk.number) + chunk_ending(kind())};
}

StoredFile PlanFolder::manifest(const PlannedChunk& chunk) const {
    return {folder_, stem_of(chunk.number) + ".json"};
}

// Null if there is no manifest, or if the file is not a JSON object.
Json PlanFolder::read_manifest(const PlannedChunk& chunk) const {
    const StoredFile file = manifest(chunk);
    const InputFile found(file);
    if (found.is_missing() || found.is_other_kind()) return {};
    Json json = json_in(read_file(file, most_json_bytes));
    return json.is_object() ? json : Json();
}

bool PlanFolder::is_done(const PlannedChunk& chunk) const {
    const Json json = read_manifest(chunk);
    if (json.is_null() || json.value("plan", Json()) != fingerprint() ||
        json.value("chunk", Json()) != chunk.number)
        return false;
    const auto found = fingerprint_of_file(output(chunk));
    return found && json.value("fingerprint", Json()) == *found;
}

std::vector<int> PlanFolder::missing() const {
    std::vector<int> numbers;
    for (const PlannedChunk& chunk : chunks_)
        if (!is_done(chunk)) numbers.push_back(chunk.number);
    return numbers;
}

void PlanFolder::finish(const PlannedChunk& chunk, const Json& build, double seconds) const {
    const auto content = fingerprint_of_file(output(chunk));
    if (!content)
        throw TemporaryError(fmt::format("cannot read back {}: it is no ordinary file",
                                         output(chunk).path().string()));
    const Json json{{"chunk", chunk.number},
                    {"plan", fingerprint()},
                    {"fingerprint", *content},
                    {"seconds", seconds},
                    {"build", build}};
    write_file(manifest(chunk), text_of(json, 2) + "\n");
}

void PlanFolder::require_all_done(bool allow_mixed) const {
    std::vector<std::string> missing, changed;
    for (const PlannedChunk& chunk : chunks_) {
        const Json json = read_manifest(chunk);
        if (json.is_null()) {
            missing.push_back(std::to_string(chunk.number));
        } else if (!is_done(chunk)) {
            changed.push_back(std::to_string(chunk.number));
        } else if (!allow_mixed) {
            const std::string other =
                difference(request().at("build"), json.value("build", Json::object()), "the plan",
                           fmt::format("chunk {}", chunk.number));
            if (!other.empty())
                throw SystemError(fmt::format(
                    "{}: {}; make the chunk again on a machine like that of the plan, or "
                    "join with --allow-mixed",
                    folder_.string(), other));
        }
    }
    const char* verb = kind() == PlanKind::film ? "render" : "run";
    if (!missing.empty())
        throw UsageError(
            fmt::format("{}: {} of {} chunks are missing ({}); make them with carom "
                        "{} {} --chunk K",
                        folder_.string(), missing.size(), chunks_.size(), shortened(missing), verb,
                        folder_.string()));
    if (!changed.empty())
        throw SystemError(
            fmt::format("{}: the output of chunk {} is of another plan, cut short or changed; make "
                        "it again with carom {} {} --chunk K",
                        folder_.string(), shortened(changed), verb, folder_.string()));
}

void PlanFolder::require_same_build(const Json& build) const {
    const std::string other = difference(request().at("build"), build, "the plan", "this program");
    if (!other.empty())
        throw UsageError(fmt::format(
            "{}: {}; the chunks of a plan are made by one build of carom with one set of "
            "libraries: plan again with this one, or use --allow-mixed",
            folder_.string(), other));
}

bool is_plan(const fs::path& path) {
    const InputFile file(StoredFile{path, "plan.json"});
    if (file.may_pass()) file.require_open();
    return file.is_open();
}

bool is_planned(const fs::path& folder, const Json& request) {
    if (!is_plan(folder)) return false;
    try {
        const PlanFolder plan(folder);
        if (plan.request() != request) return false;
        for (const auto& [name, content] : plan.files().items())
            if (content != Json(fingerprint_of_file(StoredFile{folder, name}).value_or("")))
                return false;
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

}  // namespace carom
