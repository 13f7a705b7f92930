// How a gas warms up or cools down where theory has an adiabat of it.
#pragma once

#include <doctest/doctest.h>

#include <cmath>

#include "support/gas_states.h"

namespace carom::test {

/// The logarithm of the temperature over that at the start, of an adiabat when the last side of the
/// box has made it as long as this.
inline double heating_at(GasState s, double length, EquationOfState equation) {
    s.asked.surface = s.gas.box.surfaces.side_count - 1;
    s.asked.lengths = {length};
    s.asked.equation = equation;
    const Law found = law(s.boxed(), LawOf::adiabat, s.asked);
    CHECK(found.curve[0] > 0.0);
    return std::log(found.temperatures[0] / s.value_of(LawOf::temperature));
}

}  // namespace carom::test
