// What the scene language is read by and depends on nothing but the kinds of panel: tables of keys
// and notations. Each is put together from thousands of small parts, which takes several times as
// long as to read a scene by it; so it is made once, and kept to the end of the program.
#pragma once

#include <map>
#include <mutex>
#include <utility>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"

namespace carom {

/// Values for lists of kinds. They are not destroyed at the end of the program, as their thousands
/// of small parts would be for nothing. May be used by several threads.
template <typename Value>
class MadeOnce {
  public:
    /// The value for `kinds`: what `make()` gives, which is called at the first time.
    template <typename Make>
    const Value& of(PanelKinds kinds, const Make& make) {
        const std::lock_guard lock(mutex_);
        auto found = values_.find(kinds.data());
        if (found == values_.end()) found = values_.emplace(kinds.data(), make()).first;
        return found->second;
    }

  private:
    std::mutex mutex_;
    std::map<const PanelKind*, Value>& values_ = *new std::map<const PanelKind*, Value>;
};

}  // namespace carom
