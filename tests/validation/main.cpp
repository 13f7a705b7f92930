// Measures what theory and others know of gases, and writes the page of validation.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "validation/page.h"
#include "validation/study.h"

using namespace carom::validation;

namespace {

struct Options {
    unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    double effort = 1.0;
    bool is_quick = false;
    std::string only, page, figures;
};

Options options_of(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool has_value = i + 1 < words.size();
        if (words[i] == "--quick") {
            options.is_quick = true;
            options.effort = 0.01;
        } else if (words[i] == "--threads" && has_value) {
            options.threads = static_cast<unsigned>(std::max(1, std::stoi(words[++i])));
        } else if (words[i] == "--only" && has_value) {
            options.only = words[++i];
        } else if (words[i] == "--page" && has_value) {
            options.page = words[++i];
        } else if (words[i] == "--figures" && has_value) {
            options.figures = words[++i];
        } else {
            throw std::invalid_argument(
                "validation [--quick] [--threads N] [--only WORDS] [--page FILE --figures JSON]");
        }
    }
    return options;
}

double seconds_of_thread() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Task {
    std::size_t study;
    int run;
};

/// All runs of all studies, on threads; the same numbers on any number of them.
std::vector<Measured> measure(std::vector<Study> studies, const Options& options) {
    std::vector<Measured> all;
    std::vector<Task> tasks;
    for (Study& study : studies) {
        if (options.is_quick) study.runs = std::min(study.runs, 5);
        for (int run = 0; run < study.runs; ++run) tasks.push_back({all.size(), run});
        Measured measured{std::move(study), {}, {}};
        measured.values.resize(static_cast<std::size_t>(measured.study.runs));
        measured.seconds.resize(measured.values.size());
        all.push_back(std::move(measured));
    }
    std::atomic<std::size_t> next = 0;
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> has_failed = false;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t k = next++; k < tasks.size() && !has_failed; k = next++) {
            Measured& one = all[tasks[k].study];
            const auto run = static_cast<std::size_t>(tasks[k].run);
            try {
                const double begun = seconds_of_thread();
                one.values[run] = one.study.measure({run + 1, options.effort});
                one.seconds[run] = seconds_of_thread() - begun;
                const std::size_t now = ++done;
                if (!options.is_quick && now * 10 / tasks.size() != (now - 1) * 10 / tasks.size())
                    std::fprintf(stderr, "carom: %zu of %zu runs\n", now, tasks.size());
            } catch (...) {
                if (!has_failed.exchange(true)) failure = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned k = 1; k < options.threads; ++k) threads.emplace_back(work);
        work();
    }
    if (failure) std::rethrow_exception(failure);
    return all;
}

/// A quick run is far too short for a close look: it fails where a truth is grossly missed.
bool is_outside(const Row& row, double bound, bool is_quick) {
    if (std::abs(row.z) <= bound) return false;
    return !is_quick ||
           std::abs(row.measured.mean - row.truth->value) > 0.05 * std::abs(row.truth->value);
}

int run(const Options& options) {
    const auto begun = std::chrono::steady_clock::now();
    std::vector<Study> studies = all_studies();
    if (!options.only.empty())
        std::erase_if(studies, [&](const Study& study) {
            return (study.field + study.truths[0].what).find(options.only) == std::string::npos;
        });
    std::vector<Measured> measured = measure(std::move(studies), options);
    std::size_t rows = 0;
    for (Measured& one : measured) {
        one.find_rows();
        rows += one.rows.size();
    }
    const double bound = bound_of(rows);
    int outside = 0;
    for (const Measured& one : measured)
        for (const Row& row : one.rows) {
            const bool is_out = is_outside(row, bound, options.is_quick);
            outside += is_out ? 1 : 0;
            std::printf("%s %6.2f  %s: %s, here %s  (%.1f s)\n", is_out ? "OUTSIDE" : "       ",
                        row.z, row.truth->what.c_str(), known_of(*row.truth, row).c_str(),
                        measured_of(row).c_str(), one.all_seconds());
        }
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (!options.page.empty()) write_page(options.page, options.figures, measured, bound, seconds);
    std::printf("%zu rows, %d outside of |z| < %.2f, in %.0f s on %u threads\n", rows, outside,
                bound, seconds, options.threads);
    return outside > 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** words) {
    try {
        return run(options_of({words + 1, words + count}));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "validation: %s\n", error.what());
        return 2;
    }
}
