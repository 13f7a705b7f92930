// Tables of keys and notations, which depend on nothing but the kinds of panel. Each is put
// together from thousands of small parts, which takes several times as long as reading a scene with
// it. It is therefore made once and kept until the program ends.
#pragma once

#include <map>
#include <mutex>
#include <utility>

#include "scene/keys/binding.h"
#include "scene/panel_kind.h"

namespace carom {

/// One value for each list of kinds of panel. The values are never destroyed: destroying their
/// thousands of small parts at the end of the program would be wasted time. Thread-safe.
template <typename Value>
class MadeOnce {
  public:
    /// Returns the value for `kinds`; the first call for these kinds makes it by `make()`.
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
