#include "physics/theory/error_growth.h"

#include <cmath>

namespace carom {

double bits_lost_per_collision(int dimension, double packing) {
    if (!(packing > 0.0)) return 0.0;
    return dimension == 2 ? 3.85 * std::log2(1.0 + 0.115 / packing)
                          : 3.3 * std::log2(1.0 + 0.075 / packing);
}

}  // namespace carom
