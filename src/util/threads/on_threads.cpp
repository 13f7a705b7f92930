#include "util/threads/on_threads.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <exception>
#include <latch>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "util/diagnostics.h"

namespace carom {

void on_threads(int threads, std::size_t count, const std::function<void(std::size_t)>& work) {
    std::map<std::size_t, std::exception_ptr> errors;
    std::mutex mutex;
    std::atomic<bool> failed = false;
    std::atomic<std::size_t> next = 0;
    const auto help = [&] {
        while (!failed) {
            const std::size_t i = next++;
            if (i >= count) return;
            try {
                work(i);
            } catch (...) {
                failed = true;
                const std::lock_guard lock(mutex);
                errors[i] = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> helpers;
        const auto most = static_cast<std::size_t>(std::max(1, threads));
        try {
            for (std::size_t i = 1; i < std::min(count, most); ++i) helpers.emplace_back(help);
        } catch (const std::system_error& error) {
            failed = true;
            throw_no_threads(threads, error.what());
        }
        help();
    }
    if (!errors.empty()) std::rethrow_exception(errors.begin()->second);
}

void require_threads(int threads, const std::function<void()>& work) {
    std::mutex mutex;
    std::exception_ptr error;
    std::latch all_started(1);
    {
        std::vector<std::jthread> started;
        const auto begin = [&] {
            all_started.wait();
            try {
                work();
            } catch (...) {
                const std::lock_guard lock(mutex);
                if (!error) error = std::current_exception();
            }
        };
        try {
            for (int i = 0; i < threads; ++i) started.emplace_back(begin);
            all_started.count_down();
        } catch (const std::system_error& failure) {
            all_started.count_down();
            throw_no_threads(threads, failure.what());
        }
    }
    if (error) std::rethrow_exception(error);
}

void require_memory(std::size_t bytes, const std::string& what, int threads) {
    void* const begin = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin == MAP_FAILED)
        throw SystemError(fmt::format(
            "not enough memory: {} needs {:.0f} MB that this process is not granted "
            "({}); raise the limit (ulimit -v){}",
            what, 1e-6 * static_cast<double>(bytes), std::generic_category().message(errno),
            threads > 1 ? ", or use fewer threads (--threads)" : ""));
    munmap(begin, bytes);
}

void throw_no_threads(int threads, const std::string& reason) {
    throw SystemError(fmt::format(
        "cannot start {} thread{}: {}; use fewer (--threads), or raise the limit (ulimit -u)",
        threads, threads == 1 ? "" : "s", reason));
}

}  // namespace carom
