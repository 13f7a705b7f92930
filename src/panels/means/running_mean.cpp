#include "panels/means/running_mean.h"

#include <cmath>

namespace carom {

std::vector<double> RunningMean::operator()(double time, const std::vector<double>& now,
                                            bool is_sample) {
    if (over_.since == Over::Since::now) return now;
    Sums sums{time, now, std::vector<double>(now.size()), std::vector<double>(now.size())};
    if (!sums_.empty()) {
        const Sums& last = sums_.last();
        for (std::size_t k = 0; k < now.size(); ++k) {
            const double middle = 0.5 * (last.now[k] + now[k]);
            const double step = std::isfinite(middle) ? time - last.time : 0.0;
            sums.integral[k] = last.integral[k] + (step > 0.0 ? step * middle : 0.0);
            sums.known_for[k] = last.known_for[k] + step;
        }
    }
    sums_.add(std::move(sums), is_sample);
    if (sums_.empty()) return now;  // before the first sample
    const Sums &from = sums_.from(), &to = sums_.to();
    std::vector<double> means = now;
    for (std::size_t k = 0; k < now.size(); ++k)
        if (const double span = to.known_for[k] - from.known_for[k]; span > 0.0)
            means[k] = (to.integral[k] - from.integral[k]) / span;
    return means;
}

}  // namespace carom
