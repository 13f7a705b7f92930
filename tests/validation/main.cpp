// Measures quantities of gases that are known from theory or the literature, and writes the page of
// validation.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <mutex>
#include <stdexcept>
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

/// A quick run has too few samples for the close test; it fails only if a known value is grossly
/// missed.
bool is_outside(const Row& row, double bound, bool is_quick) {
    if (!is_quick) return std::abs(row.z) > bound;
    const double off = std::abs(row.measured.mean - row.truth->value);
    return std::abs(row.z) > 3.0 && off > 0.05 * std::abs(row.truth->value);
}

/// Carries out all runs of all studies on several threads; the results do not depend on their
/// number.
class Validation {
  public:
    Validation(std::vector<Study> studies, const Options& options) : options_(options) {
        for (Study& study : studies) {
            if (options.is_quick) study.runs = std::min(study.runs, 4);
            for (int run = 0; run < study.runs; ++run) tasks_.push_back({all_.size(), run});
            rows_ += study.truths.size();
            left_.push_back(study.runs);
            Measured measured{std::move(study), {}, {}};
            measured.values.resize(static_cast<std::size_t>(measured.study.runs));
            measured.seconds.resize(measured.values.size());
            all_.push_back(std::move(measured));
        }
        bound_ = bound_of(rows_);
    }

    void measure() {
        {
            std::vector<std::jthread> threads;
            for (unsigned k = 1; k < options_.threads; ++k)
                threads.emplace_back([this] { work(); });
            work();
        }
        if (failure_) std::rethrow_exception(failure_);
    }

    const std::vector<Measured>& all() const { return all_; }
    std::size_t rows() const { return rows_; }
    double bound() const { return bound_; }
    int outside() const { return outside_; }

  private:
    struct Task {
        std::size_t study;
        int run;
    };

    void work() {
        for (std::size_t k = next_++; k < tasks_.size() && !has_failed_; k = next_++) {
            Measured& one = all_[tasks_[k].study];
            const auto run = static_cast<std::size_t>(tasks_[k].run);
            try {
                const double begun = seconds_of_thread();
                one.values[run] = one.study.measure({run + 1, options_.effort});
                one.seconds[run] = seconds_of_thread() - begun;
                const std::lock_guard lock(mutex_);
                if (--left_[tasks_[k].study] == 0) report(one);
            } catch (...) {
                if (!has_failed_.exchange(true)) failure_ = std::current_exception();
            }
        }
    }

    /// Prints what a study has measured when its last run has ended.
    void report(Measured& one) {
        one.find_rows();
        for (const Row& row : one.rows) {
            const bool is_out = is_outside(row, bound_, options_.is_quick);
            outside_ += is_out ? 1 : 0;
            std::printf("%s %6.2f  %s: %s, here %s  (%.1f s)\n", is_out ? "OUTSIDE" : "       ",
                        row.z, row.truth->what.c_str(), known_of(*row.truth, row).c_str(),
                        measured_of(row).c_str(), one.all_seconds());
        }
        std::fflush(stdout);
    }

    Options options_;
    std::vector<Measured> all_;
    std::vector<Task> tasks_;
    std::vector<int> left_;  ///< unfinished runs of each study
    std::size_t rows_ = 0;
    double bound_ = 0.0;
    int outside_ = 0;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> has_failed_ = false;
    std::exception_ptr failure_;
    std::mutex mutex_;
};

int run(const Options& options) {
    const auto begun = std::chrono::steady_clock::now();
    std::vector<Study> studies = all_studies();
    if (!options.only.empty())
        std::erase_if(studies, [&](const Study& study) {
            return (study.field + study.truths[0].what).find(options.only) == std::string::npos;
        });
    Validation validation(std::move(studies), options);
    validation.measure();
    Effort effort{validation.bound(), 0.0, 0.0, options.threads};
    for (const Measured& one : validation.all()) effort.processor_seconds += one.all_seconds();
    effort.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (!options.page.empty()) write_page(options.page, options.figures, validation.all(), effort);
    std::printf(
        "%zu rows, %d outside of |z| < %.2f, in %.0f s on %u threads, %.0f s of processor time\n",
        validation.rows(), validation.outside(), effort.bound, effort.seconds, effort.threads,
        effort.processor_seconds);
    return validation.outside() > 0 ? 1 : 0;
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
