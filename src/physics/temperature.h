// The temperature that particles are given, at the start or by heating, as a plain value.
#pragma once

namespace carom {

struct Temperature {
    double value;           ///< each component is normally distributed with variance T/m
    bool is_exact = false;  ///< rescaled so that thermal_motion() of the species gives exactly this
                            ///< value
};

}  // namespace carom
