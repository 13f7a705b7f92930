// A reorder buffer: values become ready in any order and are passed on in the order of their
// numbers.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

namespace carom {

template <typename Value>
class InOrder {
  public:
    /// The number of the value to be passed on next.
    std::size_t next() const { return next_; }

    /// Stores value number `index`, then calls take() with each stored value that is next in order.
    /// If take() throws, its value is lost and no later one will ever be passed on.
    template <typename Take>
    void add(std::size_t index, Value value, Take&& take) {
        waiting_.emplace(index, std::move(value));
        for (auto due = waiting_.extract(next_); !due.empty(); due = waiting_.extract(next_)) {
            take(std::move(due.mapped()));
            ++next_;
        }
    }

  private:
    std::map<std::size_t, Value> waiting_;
    std::size_t next_ = 0;
};

}  // namespace carom
