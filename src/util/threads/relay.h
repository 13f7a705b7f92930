// Passes values in order from the thread that produces them to another that consumes them, so that
// both work at the same time.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "util/threads/on_threads.h"

namespace carom {

template <class Value>
class Relay {
  public:
    /// Calls `take` with one value after another on a thread of its own; at most `most` values wait
    /// for it. Throws SystemError if the thread cannot be started.
    explicit Relay(std::function<void(Value)> take, std::size_t most = 2)
        : take_(std::move(take)), most_(most) {
        try {
            thread_ = std::thread([this] { work(); });
        } catch (const std::system_error& error) {
            throw_no_threads(1, error.what());
        }
    }
    ~Relay() { end(); }
    Relay(const Relay&) = delete;
    Relay& operator=(const Relay&) = delete;

    /// Queues a value; waits while the queue is full. Rethrows an exception that `take` has thrown.
    void send(Value value) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return error_ || waiting_.size() < most_; });
        if (error_) std::rethrow_exception(error_);
        waiting_.push_back(std::move(value));
        changed_.notify_all();
    }

    /// Waits until `take` has returned for all values sent. Rethrows an exception that it has
    /// thrown.
    void settle() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return error_ || (waiting_.empty() && !is_taking_); });
        if (error_) std::rethrow_exception(error_);
    }

    /// Does the same, and ends the thread.
    void finish() {
        end();
        if (error_) std::rethrow_exception(error_);
    }

  private:
    void end() {
        {
            const std::scoped_lock lock(mutex_);
            ended_ = true;
        }
        changed_.notify_all();
        if (thread_.joinable()) thread_.join();
    }

    void work() {
        try {
            while (true) {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
                if (waiting_.empty()) return;
                Value value = std::move(waiting_.front());
                waiting_.pop_front();
                is_taking_ = true;
                changed_.notify_all();
                lock.unlock();
                take_(std::move(value));
                lock.lock();
                is_taking_ = false;
                changed_.notify_all();
            }
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            error_ = std::current_exception();
            changed_.notify_all();
        }
    }

    std::function<void(Value)> take_;
    std::size_t most_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Value> waiting_;
    bool is_taking_ = false;
    bool ended_ = false;
    std::exception_ptr error_;
    std::thread thread_;
};

}  // namespace carom
