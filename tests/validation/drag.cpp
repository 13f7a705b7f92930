// Validation of the drag on a large disk in a gas of points: Epstein's law, in two dimensions.
#include <cmath>
#include <numbers>
#include <vector>

#include "physics/simulation.h"
#include "util/random.h"
#include "validation/study.h"

namespace carom::validation {

namespace {

using std::numbers::pi;
constexpr const char* drag_field = "Brownian drag";
constexpr double size = 40.0, radius = 5.0;
constexpr int count = 8000;
constexpr double density = count / (size * size - pi * radius * radius);
constexpr double last = 6.0;  // before a point meets the disk again through the periodic box

/// Epstein's friction coefficient for slow disks: 2 sqrt(2 pi) n R sqrt(m T).
const double epstein = 2.0 * std::sqrt(2.0 * pi) * density * radius;

/// The force on the disk at any velocity, from points of mass 1 at T = 1 that come from all
/// directions.
double drag(double velocity) {
    constexpr int steps = 2000;
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
        const double angle = 2.0 * pi * (k + 0.5) / steps, u = velocity * std::cos(angle);
        const double below = 0.5 * std::erfc(-u / std::numbers::sqrt2);
        const double normal = std::exp(-0.5 * u * u) / std::sqrt(2.0 * pi);
        sum += 2.0 * density * ((1.0 + u * u) * below + u * normal) * std::cos(angle);
    }
    return radius * sum * 2.0 * pi / steps;
}

/// The velocity of a disk of mass `mass` after `time`, started at the x-velocity `start`.
double velocity_after(double time, double start, double mass, std::uint64_t seed) {
    Random random(seed, "points around a disk");
    Particles particles{Eigen::ArrayXd::Zero(count + 1), Eigen::ArrayXd::Ones(count + 1),
                        Eigen::ArrayXi::Zero(count + 1)};
    Sample sample{0.0, Eigen::ArrayXXd::Zero(count + 1, 2), Eigen::ArrayXXd::Zero(count + 1, 2)};
    particles.radius[0] = radius;
    particles.inverse_mass[0] = 1.0 / mass;
    sample.position.row(0) = 0.5 * size;
    sample.velocity(0, 0) = start;
    for (Eigen::Index i = 1; i <= count; ++i) {
        double x = 0.0, y = 0.0;
        do {
            x = random.uniform(0.0, size);
            y = random.uniform(0.0, size);
        } while (std::hypot(x - 0.5 * size, y - 0.5 * size) <= radius);
        sample.position(i, 0) = x;
        sample.position(i, 1) = y;
        for (int a = 0; a < 2; ++a) sample.velocity(i, a) = random.normal();
    }
    const Box box{.dimension = 2, .size = {size, size}, .walls = {Wall::periodic, Wall::periodic}};
    Simulation simulation(box, std::move(particles), sample, {});
    simulation.advance_to(time);
    return simulation.sample().velocity(0, 0);
}

/// The mean of this velocity over several starts.
double mean_velocity(double start, double mass, const RunOf& run) {
    const int starts = std::max(2, static_cast<int>(10 * run.effort));
    double sum = 0.0;
    for (int k = 0; k < starts; ++k)
        sum += velocity_after(last, start, mass, 1000 * run.seed + static_cast<std::uint64_t>(k)) /
               starts;
    return sum;
}

/// A disk so heavy that it keeps its velocity.
Study at_constant_velocity(double velocity) {
    constexpr double mass = 1e7;
    Study study;
    study.field = drag_field;
    study.runs = 24;
    study.truths = {
        {"drag on a disk of radius 5 at velocity " + std::string(velocity < 1.0 ? "0.3" : "2") +
             " in points, over Epstein’s 2√(2π) *nR*√(*mT*) *v*",
         drag(velocity) / (epstein * velocity), 0.0, 0.0,
         "exact: free molecular flow, specular; P. S. Epstein, Phys. Rev. 23, 710 (1924), "
         "in a plane"}};
    study.measure = [=](const RunOf& run) {
        const double lost = velocity - mean_velocity(velocity, mass, run);
        return std::vector<double>{mass * lost / (last * epstein * velocity)};
    };
    return study;
}

/// The mean of v / v0 of a disk that is slowed by the drag and fluctuates under the impacts of the
/// points: integrates F(v) to third order in v, with the velocity variance due to the impacts.
double slowed(double start, double mass, double time) {
    const double rate = epstein / (mass + 1.0);
    double v = start, t = 0.0;
    constexpr double step = 1e-3;
    for (; t < time - 0.5 * step; t += step) {
        const auto slope = [&](double now, double at) {
            const double variance = (1.0 - std::exp(-2.0 * rate * at)) / mass;
            return -rate * (now + (now * now * now + 4.0 * now * variance) / 8.0);
        };
        const double middle = v + 0.5 * step * slope(v, t);
        v += step * slope(middle, t + 0.5 * step);
    }
    return v / start;
}

Study brownian() {
    constexpr double mass = 1000.0, start = 0.4;
    Study study;
    study.field = drag_field;
    study.runs = 40;
    study.how =
        "8000 points of mass 1 at *T* = 1 in a periodic box of side 40 meet a disk of radius 5; "
        "runs end at time 6, before points come round to it again. The known values follow from "
        "the integral of the momentum that points bring to each place of the edge; one of finite "
        "mass *M* is slowed by *M*/(*M* + *m*) times as much.";
    study.truths = {
        {"mean velocity of a disk of mass 1000 after a time of 6, over that of its start, 0.4",
         slowed(start, mass, last), 0.0, 0.0,
         "exact: the same drag, to third order in the velocity"}};
    study.measure = [=](const RunOf& run) {
        return std::vector<double>{mean_velocity(start, mass, run) / start};
    };
    return study;
}

}  // namespace

std::vector<Study> drags() {
    return {at_constant_velocity(0.3), at_constant_velocity(2.0), brownian()};
}

}  // namespace carom::validation
