// Values that are ready in any order and handed on in the order of their numbers.
#pragma once

#include <cstddef>
#include <map>
#include <utility>

namespace carom {

template <typename Value>
class InOrder {
  public:
    /// The number of the value whose turn it is.
    std::size_t next() const { return next_; }

    /// Keeps value number `index`, and hands on to take() all whose turn has come. When take()
    /// throws, its value is gone and no later one will ever be handed on.
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
