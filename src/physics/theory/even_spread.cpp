#include "physics/theory/even_spread.h"

#include <cmath>

namespace carom {

double entropy_of_even_spread(double count, double cells) {
    const double share = 1.0 / cells;
    if (share == 1.0) return 0.0;
    double sum = 0.0;
    for (double n = 1.0; n <= count; n += 1.0) {
        const double chance = std::exp(std::lgamma(count + 1.0) - std::lgamma(n + 1.0) -
                                       std::lgamma(count - n + 1.0) + n * std::log(share) +
                                       (count - n) * std::log1p(-share));
        sum -= chance * n / count * std::log(n / count);
    }
    return sum / share;
}

}  // namespace carom
