// A panel of a film or a figure: what panels of all kinds have, and the options of its own kind as
// one value whose type only that kind knows.
#pragma once

#include <any>
#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "util/diagnostics.h"

namespace carom {

/// Particles that a panel treats as one group: a species, one particle, or all particles if neither
/// is given.
struct Chosen {
    std::optional<std::size_t> species = {};
    std::optional<std::int64_t> particle = {};
};

/// The span of time over which a panel takes its values.
struct Over {
    enum class Since { now, start, window } since = Since::now;
    double window = 0.0;  ///< simulated time before the present
};

/// One axis, two of the three in space, or all of them together: both in a plane, all three in
/// space.
enum class Component { x, y, z, xy, xz, yz, both };

/// The simulated time in which something is shown.
struct TimeSpan {
    double from = 0.0;
    std::optional<double> until = {};  ///< none: the end of the run
};

/// The options of a panel's kind: a value of the type that the kind has for them, or nothing, which
/// stands for a new value of that type. Another type than that of the kind is a programmer's error.
class Options {
  public:
    Options() = default;

    template <class T>
    static Options of(T value) {
        Options options;
        options.value_ = std::move(value);
        return options;
    }

    template <class T>
    const T& as() const {
        static const T unchanged{};
        const T* value = find<T>();
        assert((value != nullptr || !value_.has_value()) && "options of another kind");
        return value != nullptr ? *value : unchanged;
    }

    /// The same, to be changed.
    template <class T>
    T& change() {
        if (!value_.has_value()) value_ = T{};
        assert(find<T>() != nullptr && "options of another kind");
        return *std::any_cast<T>(&value_);
    }

    /// The value if it is of this type; otherwise, and if there is none, null.
    template <class T>
    const T* find() const {
        return std::any_cast<T>(&value_);
    }

  private:
    std::any value_;
};

/// What a scene says of a panel. What has no meaning for its kind keeps the default.
struct PanelSpec {
    std::string kind;
    std::optional<std::string> title = {};                  ///< none: by kind
    std::optional<std::string> x_title = {}, y_title = {};  ///< of its axes; none: by kind
    std::vector<Chosen> of = {};              ///< drawn together; empty: all particles
    std::optional<Over> over = {};            ///< none: by kind
    std::optional<Component> component = {};  ///< none: by kind
    bool theory = true;                       ///< whether theory is drawn, where there is one
    int seeds = 1;                            ///< of a figure: the runs whose mean it shows
    std::optional<std::string> joined = {};   ///< of a figure: a finished, joined sweep (folder or
                                              ///< summary) whose runs it shows
    bool test = false;              ///< of a figure: whether the bars are tested against theory
    std::optional<double> at = {};  ///< of a figure: the time that it shows; none in films
    bool at_ends = false;           ///< of a figure of several runs: each at its own end
    TimeSpan show = {};             ///< in a film: when it is shown
    Diagnostic place = {};          ///< in the file, with an empty message, for errors found later
    Options options = {};           ///< of its kind
};

/// The axis along which a panel shows one component: 0 for x, also if it names none, 1 for y, 2 for
/// z.
inline int axis_of(const PanelSpec& panel) {
    if (panel.component == Component::z) return 2;
    return panel.component == Component::y ? 1 : 0;
}

/// The axes of a component in a box of this dimension.
inline std::vector<int> axes_of(Component component, int dimension) {
    switch (component) {
        case Component::x:
            return {0};
        case Component::y:
            return {1};
        case Component::z:
            return {2};
        case Component::xy:
            return {0, 1};
        case Component::xz:
            return {0, 2};
        case Component::yz:
            return {1, 2};
        case Component::both:
            break;
    }
    std::vector<int> all;
    for (int axis = 0; axis < dimension; ++axis) all.push_back(axis);
    return all;
}

/// A panel with options of its kind, which is of the type T.
template <class T>
PanelSpec panel_of(std::string kind, T options) {
    return {.kind = std::move(kind), .options = Options::of(std::move(options))};
}

}  // namespace carom
