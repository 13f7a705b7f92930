// Gases under many conditions, for tests of what theory knows of each.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "physics/gas.h"
#include "physics/theory/law.h"

namespace carom::test {

/// A gas at its start, and what is asked of it.
struct GasState {
    Gas gas;
    std::vector<RunEvent> events = {};
    Particles particles = {};
    Sample start = {};
    Asked asked = {};

    BoxedGas boxed() const { return {gas.box, events, particles, start}; }
    double value_of(LawOf quantity) const { return law(boxed(), quantity, asked).value; }
};

/// Some disks, or spheres, of radius 0.3 at a temperature of 1.
Species disks(std::int64_t count, double mass = 1.0);

/// How a gas differs from twenty disks between four walls or, in space, twenty spheres between six.
struct Condition {
    std::string name;
    std::function<void(GasState&)> change;
    bool is_line = false;
    bool is_placed = true;
    bool is_space = false;
};

std::vector<Condition> conditions();
GasState state_of(const Condition& condition);

/// The state under the condition of this name. Throws std::out_of_range if there is none.
GasState state_named(const std::string& name);

}  // namespace carom::test
