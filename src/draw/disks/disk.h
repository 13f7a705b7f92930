// A disk in a picture, as taken by the painters that draw many disks.
#pragma once

#include <cstdint>

namespace carom {

struct Disk {
    float x = 0, y = 0, radius = 0;  ///< pixels
    std::uint32_t color = 0;         ///< 0xRRGGBB, opaque
};

}  // namespace carom
