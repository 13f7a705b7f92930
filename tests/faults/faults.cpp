#include "faults/faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <functional>
#include <mutex>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "e2e/program.h"
#include "support/files.h"
#include "support/process.h"

namespace carom::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene = R"(title: Two disks
box: {size: [8, 6]}
gas: [{count: 2, radius: 0.5, speed: 1}]
run: {until: 1}
film: {seconds: 0.4, fps: 15, panels: [temperature]}
figures: [{name: series, kind: temperature}, {name: gas, kind: gas}]
)";

Files files_in(const fs::path& folder) {
    Files files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (!entry.is_directory())
            files[entry.path().lexically_relative(folder).string()] = contents(entry.path());
    return files;
}

// The files without measured times, and without the fingerprint of a plan, which depends on them.
Files comparable(Files files) {
    static const std::regex times(R"-("(total|events_per_second|seconds)": ?[0-9.e+-]+)-");
    static const std::regex fingerprints(R"-("fingerprint": ?"[0-9a-f]+")-");
    for (auto& [name, bytes] : files) {
        if (!name.ends_with(".json")) continue;
        bytes = std::regex_replace(bytes, times, "\"$1\"");
        if (name.ends_with("plan.json")) bytes = std::regex_replace(bytes, fingerprints, "");
    }
    return files;
}

void write_files(const TemporaryFolder& folder, const Files& files) {
    for (const auto& [name, bytes] : files) folder.write(name, bytes);
}

Outcome call(const Work& work, const std::string& variables, const fs::path& folder,
             const std::string& by = "") {
    return shell(fmt::format("ulimit -c 0; {} {} '{}' {}", variables, by, program, work.arguments),
                 folder);
}

bool is_temporary(const std::string& name) { return has(name, ".carom-"); }

// The folder of figures is filled one file at a time, and this file lists its current contents.
bool is_list_of_figures(const std::string& name) { return name == "figures/figures.json"; }

struct Changes {
    std::vector<std::string> names;  ///< of files that are new or have changed
    std::string problem;             ///< a file that is incomplete or gone; empty: none
};

Changes changes(const Files& before, const Files& whole, const Files& now) {
    Changes found;
    for (const auto& [name, bytes] : now) {
        const auto earlier = before.find(name);
        if (earlier != before.end() && earlier->second == bytes) continue;
        const auto finished = whole.find(name);
        if ((finished == whole.end() || finished->second != bytes) && !is_list_of_figures(name))
            found.problem = name + " is neither the earlier nor the finished file";
        found.names.push_back(name);
    }
    for (const auto& [name, bytes] : before)
        if (!now.contains(name)) found.problem = name + " is gone";
    return found;
}

// Faults of resources that libraries used by carom need too; these may be unable to continue.
bool is_of_resources(const Fault& fault) {
    return fault.call == "map" || fault.call == "memory" || fault.call == "thread";
}

// GLib ends the process if it cannot start a thread. A folder of frames or a plan then keeps its
// temporary name until the next run removes it.
bool is_end_of_glib(const std::string& err) { return has(err, "the libraries that set text"); }

// libgcrypt, which is loaded with the libraries of FFmpeg, aborts if it cannot open or read one
// file.
bool is_end_of_libgcrypt(const std::string& err) {
    return has(err, "FATAL: error reading `/proc/sys/crypto/fips_enabled' in libgcrypt");
}

std::string problem_of_message(const Fault& fault, const std::string& err, const Files& after) {
    std::istringstream lines(err);
    std::vector<std::string> messages;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("carom: ") || has(line, ": error: ")) messages.push_back(line);
    if (messages.size() != 1) return std::to_string(messages.size()) + " messages";
    const std::string& message = messages.front();
    // FreeType does not report the reason.
    if (is_of_resources(fault) || has(message, "cannot read the font /")) return "";
    if (!has(message, std::strerror(fault.error))) return "the message names no reason";
    const bool names_path = has(message, "/") || std::ranges::any_of(after, [&](const auto& file) {
                                return has(message, fs::path(file.first).begin()->string());
                            });
    return names_path ? "" : "the message names no path";
}

// All faults but interrupted calls may pass, so that the exit code is 75; libraries may hide the
// reason of those of resources, and FreeType that of every fault. Input that cannot be read may be
// reported as invalid.
bool may_end_with(const Fault& fault, const std::string& err, int code) {
    if (code == 2) return fault.call == "open" || fault.call == "read";
    const bool hides_reason = is_of_resources(fault) || has(err, "cannot read the font /");
    if (hides_reason || fault.error == EINTR) return code == 1 || code == 75;
    return code == 75;
}

// Checks the files that exist after the command has failed.
std::string problem_of_files(const Fault& fault, const std::string& err, const Files& before,
                             const Files& after, const Files& now) {
    const Changes found = changes(before, after, now);
    if (!found.problem.empty()) return found.problem;
    if (is_of_resources(fault) && (now == after || is_end_of_glib(err))) return "";
    for (const std::string& name : found.names) {
        if (name.ends_with(".chunk")) continue;  // does not count as made until its manifest exists
        const bool is_named = has(err, fs::path(name).filename().string()) ||
                              has(err, "figures that were finished stay") ||
                              (is_of_resources(fault) && has(err, "nothing more was written"));
        if (!is_named) return name + " is there, and the message does not name it";
    }
    return "";
}

std::string problem(const Fault& fault, const Outcome& outcome, const Files& before,
                    const Files& after, Files now) {
    if (is_of_resources(fault) && is_end_of_glib(outcome.err))
        std::erase_if(now, [](const auto& file) { return is_temporary(file.first); });
    for (const auto& [name, bytes] : now)
        if (is_temporary(name)) return name + " remains";
    if (outcome.exit_code == 0) return now == after ? "" : "other outputs with exit code 0";
    const bool is_aborted = outcome.exit_code == 134 && is_end_of_libgcrypt(outcome.err);
    if (!is_aborted && !may_end_with(fault, outcome.err, outcome.exit_code))
        return "a wrong exit code";
    const std::string found = problem_of_files(fault, outcome.err, before, after, now);
    if (is_aborted) return found;
    return found.empty() ? problem_of_message(fault, outcome.err, after) : found;
}

std::vector<std::string> all_texts(std::size_t count,
                                   const std::function<std::string(std::size_t)>& text) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::vector<std::string> texts;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            const std::string found = text(i);
            const std::lock_guard lock(mutex);
            if (!found.empty()) texts.push_back(found);
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(work);
    threads.clear();
    return texts;
}

}  // namespace

const std::vector<Work>& all_work() {
    static const std::string small = " --size 128x96 --quality draft --quiet";
    static const std::string film = "render scene.yaml --words --threads 1 -o film.mp4" + small;
    static const std::string frames = "render scene.yaml --threads 1 -o frames/" + small;
    static const std::string samples =
        "run scene.yaml --csv samples.csv --json samples.json --quiet";
    static const std::string still = "still scene.yaml --size 128x96 -o still.png --quiet";
    static const std::string figures = "figures scene.yaml -o figures --threads 1 --quiet";
    static const std::string plan = "plan scene.yaml -o plan" + small;
    static const std::string chunk = "render plan --chunk 1 --threads 1 --quiet";
    static const std::string page =
        "render scene.yaml --page html --threads 1 -o film.html" + small;
    static const std::vector<Work> all{
        {"render", "$carom " + film + " --seed 3", film},
        {"render of frames", "", frames},
        {"run", "$carom " + samples + " --seed 3", samples},
        {"still", "$carom " + still + " --seed 3", still},
        {"figures", "$carom " + figures + " --seed 3", figures},
        {"plan", "", plan},
        {"render of a chunk", "$carom " + plan, chunk},
        {"join", "$carom " + film + " --seed 3 && $carom " + plan + " && $carom " + chunk,
         "join plan -o film.mp4 --words --poster --quiet"},
        {"render of a page", "$carom " + page + " --seed 3", page},
        {"render of slides", "", "render scene.yaml --slides slides --threads 1" + small},
        {"new", "", "new mine --quiet"},
    };
    return all;
}

const std::vector<Fault>& all_faults() {
    static const std::vector<Fault> all{
        {"write", ENOSPC}, {"write", EIO},     {"write", EINTR},     {"write", 0},
        {"open", EMFILE},  {"open", EINTR},    {"open", EIO},        {"name", ENOSPC},
        {"name", EIO},     {"sync", EIO},      {"sync", EINTR},      {"close", EIO},
        {"close", EINTR},  {"mkdir", ENOSPC},  {"truncate", ENOSPC}, {"truncate", EINTR},
        {"read", EIO},     {"read", EINTR},    {"seek", EIO},        {"status", EIO},
        {"map", ENOMEM},   {"thread", EAGAIN},
    };
    return all;
}

Trial::Trial(const Work& work) : work_(work) {
    const TemporaryFolder folder, notes;
    folder.write("scene.yaml", scene);
    const auto succeeds = [](const Outcome& outcome) {
        if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
    };
    if (!work.before.empty())
        succeeds(shell(fmt::format("carom='{}'; {}", program, work.before), folder.path()));
    before_ = files_in(folder.path());
    const fs::path counts = notes.path() / "counts";
    const auto start = std::chrono::steady_clock::now();
    succeeds(
        call(work,
             fmt::format("FAULT_COUNTS='{}' LD_PRELOAD='{}'", counts.string(), CAROM_FAILING_CALLS),
             folder.path()));
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    after_ = comparable(files_in(folder.path()));
    std::istringstream lines(contents(counts));
    std::string name;
    for (long number = 0; lines >> name >> number;) calls_[name] = number;
}

std::string Trial::with_fault(const Fault& fault, long number) const {
    const TemporaryFolder folder;
    write_files(folder, before_);
    const Outcome outcome =
        call(work_,
             fmt::format("FAULT_CALL={} FAULT_NUMBER={} FAULT_ERROR={} LD_PRELOAD='{}'", fault.call,
                         number, fault.error, CAROM_FAILING_CALLS),
             folder.path());
    const std::string found =
        problem(fault, outcome, comparable(before_), after_, comparable(files_in(folder.path())));
    if (found.empty()) return "";
    return fmt::format("{}, {} number {} with \"{}\": {}; exit code {}\n{}", work_.name, fault.call,
                       number, fault.error == 0 ? "half" : std::strerror(fault.error), found,
                       outcome.exit_code, outcome.err);
}

std::string Trial::killed_after(double seconds) const {
    const TemporaryFolder folder;
    write_files(folder, before_);
    // With --foreground, timeout waits until the killed process has ended, which holds its locks
    // until then.
    call(work_, "", folder.path(), fmt::format("timeout --foreground -s KILL {:.4f}", seconds));
    Files now = comparable(files_in(folder.path()));
    std::erase_if(now, [](const auto& file) { return is_temporary(file.first); });
    std::string found = changes(comparable(before_), after_, now).problem;
    if (found.empty() && now != after_) {
        const Outcome next = call(work_, "", folder.path());
        if (next.exit_code != 0)
            found = "the next run fails: " + next.err;
        else if (comparable(files_in(folder.path())) != after_)
            found = "the next run leaves other files";
    }
    return found.empty() ? ""
                         : fmt::format("{}, killed after {:.4f} s: {}", work_.name, seconds, found);
}

std::vector<std::string> wrong_in(const std::vector<Run>& runs) {
    return all_texts(runs.size(), [&](std::size_t i) {
        return runs[i].trial->with_fault(runs[i].fault, runs[i].number);
    });
}

std::vector<std::string> wrong_in_killed(const std::vector<Trial>& trials, int count) {
    std::mt19937_64 random(1);
    std::vector<double> fractions;
    for (int i = 0; i < count; ++i)
        fractions.push_back(std::uniform_real_distribution(0.0, 1.2)(random));
    return all_texts(fractions.size(), [&](std::size_t i) {
        const Trial& trial = trials[i % trials.size()];
        return trial.killed_after(fractions[i] * trial.seconds());
    });
}

}  // namespace carom::test
