// What placement says when it finds no room.
#pragma once

#include <string>

#include "physics/placement/placement.h"

namespace carom::test {

/// The words of the error, none when there is room.
inline std::string placement_error(const Gas& gas) {
    try {
        place(gas);
    } catch (const PlacementError& error) {
        return error.what();
    }
    return "";
}

}  // namespace carom::test
