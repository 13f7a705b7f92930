#include "physics/theory/error_growth.h"

#include <cmath>

namespace carom {

double bits_lost_per_collision(double packing) {
    return packing > 0.0 ? 3.85 * std::log2(1.0 + 0.115 / packing) : 0.0;
}

}  // namespace carom
