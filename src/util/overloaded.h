// A set of functions that std::visit chooses from by the type of the alternative. Without a generic
// one among them, a new alternative does not compile until it has one of its own.
#pragma once

namespace carom {

template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace carom
