// Several lists as one.
#pragma once

#include <initializer_list>
#include <vector>

namespace carom {

/// The items of all lists, in order.
template <class Item>
std::vector<Item> joined(std::initializer_list<std::vector<Item>> lists) {
    std::vector<Item> all;
    for (const std::vector<Item>& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace carom
