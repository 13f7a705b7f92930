// The error message of the placement of particles when they do not fit.
#pragma once

#include <string>

#include "physics/placement/placement.h"

namespace carom::test {

/// The message of the placement error; empty if the particles fit.
inline std::string placement_error(const Gas& gas) {
    try {
        place(gas);
    } catch (const PlacementError& error) {
        return error.what();
    }
    return "";
}

}  // namespace carom::test
