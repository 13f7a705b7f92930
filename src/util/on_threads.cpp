#include "util/on_threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

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
        for (std::size_t i = 1; i < std::min(count, most); ++i) helpers.emplace_back(help);
        help();
    }
    if (!errors.empty()) std::rethrow_exception(errors.begin()->second);
}

}  // namespace carom
