#include "captions/course.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <unsupported/Eigen/SpecialFunctions>

#include "panels/precision.h"
#include "support/goodness_of_fit.h"
#include "support/library.h"
#include "support/resources.h"

namespace carom::test {

namespace {

constexpr int steps = 400;

Course run_of(const std::string& name, const Scene& scene) {
    StartedScene started = start_scene(scene);
    Simulation& simulation = started.simulation;
    Course course{name, started.scene, simulation.particles(), {}, {}, {}, 0.0};
    const double until = scene.run.until;
    simulation.record_collisions(true);
    simulation.measure_return({until});
    int hits = 0;
    for (int i = 0; i <= steps; ++i) {
        const AdvanceResult result = simulation.advance_to(until * i / steps);
        for (const Collision& c : result.collisions) {
            course.collisions.push_back(c);
            hits +=
                static_cast<int>(c.second.is_surface() &&
                                 c.second.surface() >= simulation.box().surfaces.first_obstacle());
        }
        course.hits.push_back(hits);
        if (result.return_distance)
            course.log10_return_distance = result.return_distance->log10_largest;
        course.moments.push_back(
            {simulation.sample(), result.counts, result.impulses, result.surfaces});
    }
    return course;
}

// Calls `add` with the index of each particle that is meant.
template <class Add>
void each(const Course& course, const Moment& moment, const Which& which, const Add& add) {
    for (Eigen::Index i = 0; i < course.particles.count(); ++i)
        if (which.holds(course, moment, i)) add(i);
}

Reading mean_over(const Which& which,
                  const std::function<Eigen::ArrayXd(const Course&, const Moment&)>& values) {
    return {[=](const Course& course, const Moment& moment) {
        const Eigen::ArrayXd all_values = values(course, moment);
        double sum = 0.0, number_of_them = 0.0;
        each(course, moment, which, [&](Eigen::Index i) {
            sum += all_values[i];
            number_of_them += 1.0;
        });
        return sum / number_of_them;
    }};
}

Eigen::ArrayXd energies(const Course& course, const Moment& moment) {
    return kinetic_energies(course.particles, moment.sample);
}

Which place_where(int axis, const std::function<bool(double)>& holds) {
    return {[=](const Course&, const Moment& moment, Eigen::Index i) {
        return holds(moment.sample.position(i, axis));
    }};
}

std::vector<double> values_between(const Course& course, double from, double to,
                                   const Reading& reading) {
    std::vector<double> values;
    for (const Moment& moment : course.moments)
        if (moment.sample.time >= from - 1e-9 && moment.sample.time <= to + 1e-9)
            values.push_back(reading.of(course, moment));
    if (values.empty()) throw std::invalid_argument("no moment in this span of time");
    return values;
}

// All places, continued through periodic sides: from one moment to the next no particle comes as
// far as half of the box.
std::vector<Eigen::ArrayXXd> places_through_sides(const Course& course) {
    std::vector<Eigen::ArrayXXd> places{course.moments.front().sample.position};
    const Box& box = course.scene.gas.box;
    for (std::size_t k = 1; k < course.moments.size(); ++k) {
        Eigen::ArrayXXd step =
            course.moments[k].sample.position - course.moments[k - 1].sample.position;
        for (Eigen::Index a = 0; a < step.cols(); ++a)
            if (box.walls[static_cast<std::size_t>(a)] == Wall::periodic)
                step.col(a) -= box.size[a] * (step.col(a) / box.size[a]).round();
        places.push_back(places.back() + step);
    }
    return places;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

const Moment& Course::at(double time) const {
    if (time > scene.run.until) throw std::invalid_argument("the run ends earlier");
    const double step = scene.run.until / steps;
    return moments.at(static_cast<std::size_t>(std::lround(time / step)));
}

const Course& course(const std::string& name, const Overrides& changes) {
    static std::map<std::pair<std::string, Overrides>, Course> courses;
    const auto key = std::pair(name, changes);
    const auto found = courses.find(key);
    if (found != courses.end()) return found->second;
    const Scene scene = load_scene(library_file(name), resources(), changes);
    return courses.emplace(key, run_of(name, scene)).first->second;
}

const Course& course_beside(const std::string& name) {
    static std::map<std::string, Course> courses;
    const auto found = courses.find(name);
    if (found != courses.end()) return found->second;
    const std::vector<ComparedRun>& others = course(name).scene.film.runs.others;
    if (others.empty()) throw std::invalid_argument(name + " shows no run beside its own");
    return courses.emplace(name, run_of(name, *others.front().scene)).first->second;
}

Which all() {
    return {[](const Course&, const Moment&, Eigen::Index) { return true; }};
}

Which species(const std::string& name) {
    return {[=](const Course& course, const Moment&, Eigen::Index i) {
        return course.scene.gas.species.at(static_cast<std::size_t>(course.particles.species[i]))
                   .name == name;
    }};
}

Which number(Eigen::Index particle) {
    return {[=](const Course&, const Moment&, Eigen::Index i) { return i == particle; }};
}

Which within(double x0, double y0, double x1, double y1) {
    return right_of(x0) && left_of(x1) && above(y0) && below(y1);
}

Which left_of(double x) {
    return place_where(0, [=](double place) { return place < x; });
}
Which right_of(double x) {
    return place_where(0, [=](double place) { return place > x; });
}
Which above(double y) {
    return place_where(1, [=](double place) { return place > y; });
}
Which below(double y) {
    return place_where(1, [=](double place) { return place < y; });
}

Which faster_than(double speed) {
    return {[=](const Course&, const Moment& moment, Eigen::Index i) {
        return moment.sample.velocity.row(i).square().sum() > speed * speed;
    }};
}

Which operator&&(const Which& a, const Which& b) {
    return {[=](const Course& course, const Moment& moment, Eigen::Index i) {
        return a.holds(course, moment, i) && b.holds(course, moment, i);
    }};
}

Reading count(const Which& which) {
    return {[=](const Course& course, const Moment& moment) {
        double number_of_them = 0.0;
        each(course, moment, which, [&](Eigen::Index) { number_of_them += 1.0; });
        return number_of_them;
    }};
}

Reading temperature(const Which& which) {
    return {[=](const Course& course, const Moment& moment) {
        return 2.0 / static_cast<double>(moment.sample.velocity.cols()) *
               mean_energy(which).of(course, moment);
    }};
}

Reading mean_energy(const Which& which) { return mean_over(which, energies); }

Reading mean_speed(const Which& which) {
    return mean_over(which,
                     [](const Course&, const Moment& moment) { return speeds(moment.sample); });
}

Reading fastest() {
    return {[](const Course&, const Moment& moment) { return speeds(moment.sample).maxCoeff(); }};
}

Reading mean_place(int axis, const Which& which) {
    return mean_over(which, [=](const Course&, const Moment& moment) {
        return moment.sample.position.col(axis);
    });
}

Reading spread_of_places(int axis, const Which& which) {
    return {[=](const Course& course, const Moment& moment) {
        const double middle = mean_place(axis, which).of(course, moment);
        const Reading square = mean_over(which, [=](const Course&, const Moment& shown) {
            return (shown.sample.position.col(axis) - middle).square();
        });
        return std::sqrt(square.of(course, moment));
    }};
}

Reading mean_velocity(int axis, const Which& which) {
    return mean_over(which, [=](const Course&, const Moment& moment) {
        return moment.sample.velocity.col(axis);
    });
}

Reading collisions_each() {
    return {[](const Course& course, const Moment& moment) {
        return 2.0 * static_cast<double>(moment.counts.particle) /
               static_cast<double>(course.particles.count());
    }};
}

Reading all_collisions() {
    return {[](const Course&, const Moment& moment) {
        return static_cast<double>(moment.counts.particle + moment.counts.wall);
    }};
}

Reading wall_impulse() {
    return {[](const Course&, const Moment& moment) {
        double sum = 0.0;
        for (const double impulse : moment.impulses.wall) sum += impulse;
        return sum;
    }};
}

Reading wall_hits() {
    return {[](const Course&, const Moment& moment) {
        return static_cast<double>(moment.counts.wall);
    }};
}

Reading place_of_surface(int surface) {
    return {[=](const Course&, const Moment& moment) {
        return moment.surfaces.at(static_cast<std::size_t>(surface)).motion.value().place;
    }};
}

Reading heat_of_surface(int surface) {
    return {[=](const Course&, const Moment& moment) {
        return moment.surfaces.at(static_cast<std::size_t>(surface)).heat;
    }};
}

Reading ratio(const Reading& a, const Reading& b) {
    return {[=](const Course& course, const Moment& moment) {
        return a.of(course, moment) / b.of(course, moment);
    }};
}

Measure at(double time, const Reading& reading) {
    return {[=](const Course& course) { return reading.of(course, course.at(time)); }};
}

Measure growth(double from, double to, const Reading& reading) {
    return {[=](const Course& course) {
        const Moment &start = course.at(from), &end = course.at(to);
        return (reading.of(course, end) - reading.of(course, start)) /
               (end.sample.time - start.sample.time);
    }};
}

Measure mean(double from, double to, const Reading& reading) {
    return {
        [=](const Course& course) { return mean_of(values_between(course, from, to, reading)); }};
}

Measure deviation(double from, double to, const Reading& reading) {
    return {[=](const Course& course) {
        std::vector<double> values = values_between(course, from, to, reading);
        const double middle = mean_of(values);
        for (double& value : values) value = (value - middle) * (value - middle);
        return std::sqrt(mean_of(values));
    }};
}

Measure highest(double from, double to, const Reading& reading) {
    return {[=](const Course& course) {
        return std::ranges::max(values_between(course, from, to, reading));
    }};
}

Measure lowest(double from, double to, const Reading& reading) {
    return {[=](const Course& course) {
        return std::ranges::min(values_between(course, from, to, reading));
    }};
}

Measure operator/(const Measure& a, const Measure& b) {
    return {[=](const Course& course) { return a.of(course) / b.of(course); }};
}
Measure operator-(const Measure& a, const Measure& b) {
    return {[=](const Course& course) { return a.of(course) - b.of(course); }};
}
Measure operator*(double factor, const Measure& a) {
    return {[=](const Course& course) { return factor * a.of(course); }};
}

Measure with(const Overrides& changes, const Measure& measure) {
    return {[=](const Course& own) { return measure.of(course(own.name, changes)); }};
}

Measure beside(const Measure& measure) {
    return {[=](const Course& own) { return measure.of(course_beside(own.name)); }};
}

Measure equilibrium_chance(double time, const std::vector<int>& axes) {
    return {[=](const Course& course) {
        const Eigen::ArrayXXd& velocity = course.at(time).sample.velocity;
        std::vector<int> along = axes;
        if (along.empty())
            for (int axis = 0; axis < course.scene.gas.box.dimension; ++axis) along.push_back(axis);
        const Eigen::ArrayXd energy =
            velocity(Eigen::all, along).square().rowwise().sum() / course.particles.inverse_mass;
        const double mean_of_all = energy.mean(), half = 0.5 * static_cast<double>(along.size());
        return chance({energy.begin(), energy.end()}, [=](double value) {
            return Eigen::numext::igamma(half, half * value / mean_of_all);
        });
    }};
}

Measure squared_displacement(double lag, const Which& which) {
    return {[=](const Course& course) {
        const std::vector<Eigen::ArrayXXd> places = places_through_sides(course);
        const auto shift =
            static_cast<std::size_t>(std::lround(lag * steps / course.scene.run.until));
        double sum = 0.0, terms = 0.0;
        for (std::size_t k = 0; k + shift < places.size(); ++k)
            each(course, course.moments[k], which, [&](Eigen::Index i) {
                sum += (places[k + shift].row(i) - places[k].row(i)).square().sum();
                terms += 1.0;
            });
        return sum / terms;
    }};
}

Measure squared_displacement_until(double time) {
    return {[=](const Course& course) {
        const std::vector<Eigen::ArrayXXd> places = places_through_sides(course);
        const auto last =
            static_cast<std::size_t>(std::lround(time * steps / course.scene.run.until));
        return (places.at(last) - places.front()).square().rowwise().sum().mean();
    }};
}

Measure distance_between(double earlier, double later) {
    return {[=](const Course& course) {
        return std::sqrt((course.at(later).sample.position - course.at(earlier).sample.position)
                             .square()
                             .rowwise()
                             .sum()
                             .mean());
    }};
}

Measure distance_from_beside(double time) {
    return {[=](const Course& own) {
        const Course& other = course_beside(own.name);
        return std::sqrt(
            (own.at(time).sample.position.row(0) - other.at(time).sample.position.row(0))
                .square()
                .sum());
    }};
}

}  // namespace carom::test
