#include "stats/means/mean_error.h"

#include <cmath>
#include <limits>

namespace carom {

MeanError mean_error(const std::vector<double>& values) {
    double count = 0.0, sum = 0.0, squares = 0.0;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        count += 1.0;
        sum += value;
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    if (count == 0.0) return {nan, nan};
    const double mean = sum / count;
    for (const double value : values)
        if (std::isfinite(value)) squares += (value - mean) * (value - mean);
    return {mean, count > 1.0 ? std::sqrt(squares / (count - 1.0) / count) : nan};
}

namespace {

constexpr double nan_of_pieces = std::numeric_limits<double>::quiet_NaN();

// The contribution of each piece to the deviation of a mean; their sum is 0.
Eigen::ArrayXd deviations(const PieceSums& pieces, Eigen::Index cell) {
    const Eigen::ArrayXd sum = pieces.sum.col(cell), weight = pieces.weight.col(cell);
    constexpr double rounding = 1e-12;
    const double mean = sum.sum() / weight.sum();
    const Eigen::ArrayXd all = (sum - mean * weight) / weight.mean();
    if (!(all.abs() > rounding * std::abs(mean)).any()) return Eigen::ArrayXd::Zero(all.size());
    return all;
}

bool are_independent(const PieceSums& pieces) {
    const auto count = static_cast<double>(pieces.sum.rows());
    return std::abs(correlation_of_neighbours(pieces)) <= 1.0 / std::sqrt(count - 1.0);
}

}  // namespace

PieceSums PieceSums::in_pairs() const {
    const Eigen::Index pairs = sum.rows() / 2;
    PieceSums all{Eigen::ArrayXXd(pairs, sum.cols()), Eigen::ArrayXXd(pairs, sum.cols())};
    for (Eigen::Index k = 0; k < pairs; ++k) {
        all.sum.row(k) = sum.row(2 * k) + sum.row(2 * k + 1);
        all.weight.row(k) = weight.row(2 * k) + weight.row(2 * k + 1);
    }
    return all;
}

double correlation_of_neighbours(const PieceSums& pieces) {
    const Eigen::Index count = pieces.sum.rows();
    double sum = 0.0, cells = 0.0;
    for (Eigen::Index cell = 0; cell < pieces.sum.cols(); ++cell) {
        const Eigen::ArrayXd off = deviations(pieces, cell);
        const double squares = off.square().sum();
        if (!(squares > 0.0)) continue;  // also without any weight
        sum += (off.head(count - 1) * off.tail(count - 1)).sum() / squares;
        cells += 1.0;
    }
    return cells == 0.0 ? nan_of_pieces : sum / cells + 1.0 / static_cast<double>(count);
}

std::optional<Eigen::ArrayXd> standard_errors(const PieceSums& pieces) {
    const PieceSums pairs = pieces.in_pairs();
    if (!are_independent(pieces) || !are_independent(pairs)) return {};
    const auto count = static_cast<double>(pairs.sum.rows());
    Eigen::ArrayXd errors(pairs.sum.cols());
    for (Eigen::Index cell = 0; cell < errors.size(); ++cell) {
        const bool is_known =
            (pairs.weight.col(cell) > 0.0).all() && (pairs.sum.col(cell) != 0.0).all();
        errors[cell] =
            is_known ? std::sqrt(deviations(pairs, cell).square().sum() / (count * (count - 1.0)))
                     : nan_of_pieces;
    }
    return errors;
}

double error_of_time_average(const std::vector<double>& times,
                             const std::vector<double>& integrals) {
    const auto integral_until = [&](double time) {
        const auto after = std::ranges::lower_bound(times, time);
        const auto k = std::min(times.size() - 1, static_cast<std::size_t>(after - times.begin()));
        if (k == 0 || times[k] <= time) return integrals[k];
        const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
        return integrals[k - 1] + share * (integrals[k] - integrals[k - 1]);
    };
    for (const Eigen::Index pieces : {40, 20}) {
        if (times.size() < 2 * static_cast<std::size_t>(pieces)) continue;
        const double length = (times.back() - times.front()) / static_cast<double>(pieces);
        if (!(length > 0.0)) break;
        PieceSums sums{Eigen::ArrayXXd(pieces, 1), Eigen::ArrayXXd::Constant(pieces, 1, length)};
        double before = integrals.front();
        for (Eigen::Index k = 0; k < pieces; ++k) {
            const double until =
                integral_until(times.front() + static_cast<double>(k + 1) * length);
            sums.sum(k, 0) = until - before;
            before = until;
        }
        if (const auto errors = standard_errors(sums)) return (*errors)[0];
    }
    return nan_of_pieces;
}

}  // namespace carom
