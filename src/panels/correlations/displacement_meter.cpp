#include "panels/correlations/displacement_meter.h"

#include <algorithm>
#include <cmath>

#include "stats/displacements.h"

namespace carom {
namespace {

constexpr double most_parts = 20.0;

bool is_few(const std::vector<Eigen::Index>& list) { return list.size() < fewest_scattered; }

std::vector<std::vector<Eigen::Index>> few_of(std::vector<std::vector<Eigen::Index>> lists) {
    std::erase_if(lists, [](const auto& list) { return !is_few(list); });
    return lists;
}

Eigen::Index groups_in(const std::vector<Eigen::Index>& list) {
    constexpr std::size_t most = 20;
    return is_few(list) ? 1 : static_cast<Eigen::Index>(std::min(list.size(), most));
}

std::vector<std::vector<Eigen::Index>> groups_of(
    const std::vector<std::vector<Eigen::Index>>& lists) {
    std::vector<std::vector<Eigen::Index>> groups;
    for (const std::vector<Eigen::Index>& list : lists) {
        const std::size_t first = groups.size();
        const auto count = static_cast<std::size_t>(groups_in(list));
        groups.resize(first + count);
        for (std::size_t i = 0; i < list.size(); ++i)
            groups[first + i * count / list.size()].push_back(list[i]);
    }
    return groups;
}

}  // namespace

DisplacementMeter::DisplacementMeter(const PanelContext& context,
                                     const std::vector<std::vector<Eigen::Index>>& lists,
                                     double from, double lags, double fit_from)
    : LagMeter(context, LagAverages::Of::displacements, groups_of(lists), from, lags),
      lists_(lists),
      groups_(groups_of(lists)),
      speeds_(context.box(), LagAverages::Of::velocities, lists, from, lags, 2,
              velocity_changes(context.run())),
      collisions_(context.box(), context.particles, from, INFINITY),
      from_(from),
      fit_from_(fit_from),
      lags_(lags),
      time_(-INFINITY),
      dimension_(context.box().dimension) {
    const bool has_few = std::ranges::any_of(lists, is_few);
    const double parts = std::floor((context.run().until - from) / (2.0 * lags));
    for (double part = 0.0; has_few && part < std::min(parts, most_parts); part += 1.0)
        parts_.push_back(LagAverages(context.box(), LagAverages::Of::displacements, few_of(lists),
                                     from + 2.0 * lags * part, lags, lag_count,
                                     velocity_changes(context.run())));
}

void DisplacementMeter::see(const FrameInput& input) {
    LagMeter::see(input);
    speeds_.see(input.sample, input.advanced.collisions);
    collisions_.see(input);
    // A part also sees the frame in which it ends; until it begins, only where particles are.
    for (std::size_t k = 0; k < parts_.size(); ++k)
        if (time_ < end_of_part(k)) parts_[k].see(input.sample, input.advanced.collisions);
    time_ = input.tick.time;
}

Measured DisplacementMeter::measured() const {
    Measured now;
    const Eigen::ArrayXXd means = averages_.averages(), squares = speeds_.averages();
    const std::vector<Eigen::ArrayXXd> of_parts = means_of_parts();
    Eigen::Index group = 0, few = 0;
    for (std::size_t k = 0; k < lists_.size(); ++k) {
        Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(lag_count);
        std::vector<Eigen::ArrayXd> pieces;
        const auto size = static_cast<double>(lists_[k].size());
        for (const Eigen::Index end = group + groups_in(lists_[k]); group < end; ++group) {
            pieces.push_back(means.row(group));
            mean +=
                pieces.back() * (double(groups_[static_cast<std::size_t>(group)].size()) / size);
        }
        if (is_few(lists_[k])) {
            pieces.clear();
            for (const Eigen::ArrayXXd& part : of_parts) pieces.push_back(part.row(few));
            ++few;
        }
        now.y.emplace_back(mean.begin(), mean.end());
        std::vector<MeanError> numbers = numbers_from(mean, pieces);
        numbers[of_square_speed].mean = squares(static_cast<Eigen::Index>(k), 0);
        const double share = fit_from_ / std::max(fit_from_, time_ - from_);
        numbers[of_collisions].mean = collisions_.mean(lists_[k]) * share;
        now.numbers.push_back(std::move(numbers));
    }
    return now;
}

void DisplacementMeter::archive(Archive& archive) {
    LagMeter::archive(archive);
    archive(speeds_, time_);
    collisions_.archive(archive);
    for (LagAverages& part : parts_) archive(part);
}

double DisplacementMeter::end_of_part(std::size_t part) const {
    return from_ + 2.0 * lags_ * static_cast<double>(part + 1);
}

// Of the parts that have ended.
std::vector<Eigen::ArrayXXd> DisplacementMeter::means_of_parts() const {
    constexpr double rounding = 1e-9;
    std::vector<Eigen::ArrayXXd> all;
    for (std::size_t k = 0; k < parts_.size(); ++k)
        if (time_ >= end_of_part(k) * (1.0 - rounding)) all.push_back(parts_[k].averages());
    return all;
}

// The diffusion coefficient that lags between two give.
double DisplacementMeter::coefficient(const Eigen::ArrayXd& squares, double from,
                                      double until) const {
    std::vector<double> x, y;
    for (int k = 0; k < lag_count; ++k) {
        const double lag = lags_ * k / (lag_count - 1);
        if (lag < from || lag > until || !std::isfinite(squares[k])) continue;
        x.push_back(lag);
        y.push_back(squares[k]);
    }
    return x.size() < 2 ? NAN : fit_line(x, y).slope / (2.0 * dimension_);
}

// Only D and its bend have errors.
std::vector<MeanError> DisplacementMeter::numbers_from(
    const Eigen::ArrayXd& mean, const std::vector<Eigen::ArrayXd>& pieces) const {
    const double middle = 0.5 * (fit_from_ + lags_);
    const auto bend = [&](const Eigen::ArrayXd& squares) {
        return coefficient(squares, middle, lags_) - coefficient(squares, fit_from_, middle);
    };
    std::vector<double> coefficients, bends;
    for (const Eigen::ArrayXd& piece : pieces) {
        coefficients.push_back(coefficient(piece, fit_from_, lags_));
        bends.push_back(bend(piece));
    }
    std::vector<MeanError> numbers(numbers_count, {NAN, NAN});
    numbers[of_diffusion] = {coefficient(mean, fit_from_, lags_), mean_error(coefficients).error};
    numbers[of_bend] = {bend(mean), mean_error(bends).error};
    numbers[of_pieces].mean = std::max(1.0, static_cast<double>(pieces.size()));
    return numbers;
}

}  // namespace carom
