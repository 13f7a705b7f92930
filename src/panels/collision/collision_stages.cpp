#include "panels/collision/collision_stages.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double apart = 1.6;          // distance of centres before and after, over that at contact
constexpr double longest_arrow = 1.0;  // relative to the distance at contact
constexpr double words_above = 1.65, words_below = 1.4;  // units, of each stage
constexpr double least_of_row = 7.2;        // units, the width of two numbers side by side
constexpr double least_with_numbers = 6.5;  // units, the height of a stage

double height_of_numbers(const Rect& stage, double unit) {
    if (!has_numbers(stage, unit)) return 0.2;
    return words_below + (has_rows_of_numbers(stage, unit) ? height_of_row : 0.0);
}
constexpr double lift_of_arrows = 0.75;  // units, from one row of arrows to the next

// The time from contact until the centres have the distance that is shown; at most `longest`, the
// duration of the flight.
double time_apart(const Vec& between, const Vec& moving, double longest) {
    const double a = square(moving), b = std::abs(dot(between, moving));
    const double c = square(between) * (1.0 - apart * apart);
    return std::clamp((-b + std::sqrt(b * b - a * c)) / a, 0.0, longest);
}

// Half of the extent of the stages along each axis, in units of the scene.
Vec half_extent(const std::array<CollisionPose, 3>& all, const CollisionCause& cause, double time) {
    Vec half = abs(time * cause.drift);
    for (const CollisionPose& pose : all)
        for (std::size_t k = 0; k < 2; ++k) {
            const double radius = cause.radius[k];
            half = upper(half, abs(pose.center[k]) + Vec(radius, radius));
            half = upper(half, abs(pose.center[k] + time * pose.arrow[k]));
        }
    return half;
}

// The areas of the three stages: one above another if `high`, otherwise side by side.
std::array<Rect, 3> places(const Rect& area, double unit, bool high) {
    const double gap = unit;
    std::array<Rect, 3> rects;
    for (std::size_t i = 0; i < 3; ++i) {
        const double n = static_cast<double>(i);
        const double width = high ? area.width : (area.width - 2.0 * gap) / 3.0;
        const double height = high ? (area.height - 2.0 * gap) / 3.0 : area.height;
        rects[i] = {area.x + (high ? 0.0 : n * (width + gap)),
                    area.y + (high ? n * (height + gap) : 0.0), width, height};
    }
    return rects;
}

}  // namespace

CollisionCause cause_of(const PairCollision& met, const Particles& particles) {
    CollisionCause cause{
        .place = met.place,
        .before = met.before,
        .after = met.after,
        .radius = {particles.radius[met.particle[0]], particles.radius[met.particle[1]]},
        .weight = {},
        .drift = {},
        .back = 0.0,
        .on = 0.0};
    const Vec moving = met.before[1] - met.before[0];
    double longest_back = met.time - met.since, longest_on = met.until - met.time;
    if (cause.radius[0] + cause.radius[1] == 0.0) {  // point particles are drawn with a radius
        cause.radius = {0.5, 0.5};
        cause.place[1] = cause.place[0] - moving / length(moving);
        longest_back = longest_on = std::numeric_limits<double>::infinity();
    }
    const double first = particles.inverse_mass[met.particle[0]],
                 second = particles.inverse_mass[met.particle[1]];
    cause.weight = {second / (first + second), first / (first + second)};
    cause.drift = cause.weight[0] * met.before[0] + cause.weight[1] * met.before[1];
    const Vec between = cause.place[1] - cause.place[0];
    cause.back = time_apart(between, moving, longest_back);
    cause.on = time_apart(between, met.after[1] - met.after[0], longest_on);
    return cause;
}

std::array<CollisionPose, 3> poses(const CollisionCause& cause) {
    std::array<CollisionPose, 3> all;
    const Vec middle = cause.weight[0] * cause.place[0] + cause.weight[1] * cause.place[1];
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec at_contact = cause.place[k] - middle;
        all[0].center[k] = at_contact - cause.back * (cause.before[k] - cause.drift);
        all[1].center[k] = at_contact;
        all[2].center[k] = at_contact + cause.on * (cause.after[k] - cause.drift);
        all[0].arrow[k] = cause.before[k];
        all[1].arrow[k] = cause.after[k] - cause.before[k];
        all[2].arrow[k] = cause.after[k];
    }
    return all;
}

bool has_rows_of_numbers(const Rect& stage, double unit) {
    return stage.width < least_of_row * unit;
}

bool has_numbers(const Rect& stage, double unit) {
    return stage.height >= least_with_numbers * unit;
}

CollisionStages collision_stages(const PairCollision& pair, const Particles& particles,
                                 const Rect& area, double unit, int dimension) {
    const CollisionCause cause = cause_of(pair, particles);
    const std::array<CollisionPose, 3> all = poses(cause);
    double fastest = length(cause.drift);
    for (const CollisionPose& pose : all)
        for (const Vec& arrow : pose.arrow) fastest = std::max(fastest, length(arrow));
    const double sigma = cause.radius[0] + cause.radius[1];
    const double time = longest_arrow * sigma / fastest;
    const Vec half = half_extent(all, cause, time);
    const double margin = 0.15 * unit;
    const auto height_for_disks = [&](const Rect& rect) {
        return rect.height - (words_above + height_of_numbers(rect, unit)) * unit;
    };
    const auto scale_in = [&](const std::array<Rect, 3>& rects) {
        const double high = height_for_disks(rects[0]);
        double most = (0.5 * rects[0].width - margin) / half[0];
        if (dimension == 2) most = std::min(most, (0.5 * high - margin) / half[1]);
        return std::min(most,
                        std::max(unit, 0.3 * high) / std::max(cause.radius[0], cause.radius[1]));
    };
    const auto beside = places(area, unit, false), above = places(area, unit, true);
    const std::array<Rect, 3> rects = scale_in(above) > scale_in(beside) ? above : beside;
    const double high = height_for_disks(rects[0]), scale = scale_in(rects);

    CollisionStages stages;
    stages.radius = {scale * cause.radius[0], scale * cause.radius[1]};
    stages.reach = scale * time;
    const double largest = std::max(stages.radius[0], stages.radius[1]);
    for (std::size_t i = 0; i < 3; ++i) {
        CollisionStage& stage = stages.stage[i];
        stage.area = rects[i];
        stage.mass_center = {rects[i].x + rects[i].width / 2,
                             rects[i].y + words_above * unit + high / 2};
        const auto pixels = [&](const Vec& v) {
            return Point{stage.mass_center.x + scale * v[0], stage.mass_center.y - scale * v[1]};
        };
        const auto arrow = [&](const Vec& from, const Vec& along, int row) {
            const double lift = row == 0 || dimension == 2
                                    ? 0.0
                                    : (row > 0 ? 1 : -1) * largest + row * lift_of_arrows * unit;
            const Point start = pixels(from), end = pixels(from + time * along);
            return StageArrow{{start.x, start.y - lift}, {end.x, end.y - lift}};
        };
        for (std::size_t k = 0; k < 2; ++k) {
            stage.center[k] = pixels(all[i].center[k]);
            stage.velocity[k] = arrow(all[i].center[k], all[i].arrow[k], k == 0 ? 1 : 2);
        }
        stage.mass_center_velocity = arrow(Vec(), cause.drift, -1);
    }
    return stages;
}

}  // namespace carom
