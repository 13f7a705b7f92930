// The runs of the scenes of the library, sampled at equal times, and quantities measured in them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "physics/advance_result.h"
#include "physics/particles.h"
#include "scene/scene.h"

namespace carom::test {

/// The state of a run at one time, and what has happened since time 0.
struct Moment {
    Sample sample;
    CollisionCounts counts;
    ImpulseTotals impulses;
    std::vector<SurfaceState> surfaces;
};

/// A whole run of a scene with all its collisions.
struct Course {
    std::string name;  ///< of the scene
    Scene scene;
    Particles particles;
    std::vector<Moment> moments;  ///< 401, from time 0 to the end
    std::vector<Collision> collisions;
    std::vector<int> hits;               ///< of particles with obstacles, at each moment
    double log10_return_distance = 0.0;  ///< at the end of a reversed run

    /// The moment nearest to `time`.
    const Moment& at(double time) const;
};

/// The run of the scene with this name and other values (KEY.PATH=VALUE). Each is made once.
const Course& course(const std::string& name, const std::vector<std::string>& changes = {});

/// The run that the film of the scene shows beside its own.
const Course& course_beside(const std::string& name);

/// The particles that a quantity is taken of.
struct Which {
    std::function<bool(const Course&, const Moment&, Eigen::Index)> holds;
};
Which all();
Which species(const std::string& name);
Which number(Eigen::Index particle);
Which within(double x0, double y0, double x1, double y1);
Which left_of(double x);
Which right_of(double x);
Which above(double y);
Which below(double y);
Which faster_than(double speed);
Which operator&&(const Which& a, const Which& b);

/// A quantity at one time.
struct Reading {
    std::function<double(const Course&, const Moment&)> of;
};
Reading count(const Which& which);
Reading temperature(const Which& which = all());  ///< kinetic energy by degree of freedom, twice
Reading mean_energy(const Which& which = all());
Reading mean_speed(const Which& which = all());
Reading fastest();
Reading mean_place(int axis, const Which& which = all());
Reading spread_of_places(int axis, const Which& which = all());  ///< standard deviation
Reading mean_velocity(int axis, const Which& which = all());
Reading collisions_each();              ///< of particles with particles, for each particle
Reading all_collisions();               ///< with walls included
Reading wall_impulse();                 ///< on all four sides since time 0
Reading wall_hits();                    ///< since time 0
Reading place_of_surface(int surface);  ///< of one that moves
Reading heat_of_surface(int surface);   ///< given to the gas since time 0
Reading ratio(const Reading& a, const Reading& b);

/// A number measured in a run.
struct Measure {
    std::function<double(const Course&)> of;
};
Measure at(double time, const Reading& reading);
Measure growth(double from, double to, const Reading& reading);  ///< by unit of time
Measure mean(double from, double to, const Reading& reading);
Measure deviation(double from, double to, const Reading& reading);  ///< standard deviation
Measure highest(double from, double to, const Reading& reading);
Measure lowest(double from, double to, const Reading& reading);
Measure operator/(const Measure& a, const Measure& b);
Measure operator-(const Measure& a, const Measure& b);
Measure operator*(double factor, const Measure& a);

/// The same number in another run.
Measure with(const std::vector<std::string>& changes, const Measure& measure);
Measure beside(const Measure& measure);

/// The p-value of the energies at `time`, in the motion along these axes or, if there are none,
/// along all, against the distribution that equilibrium has: a gamma distribution with half as many
/// degrees of freedom as axes, in two dimensions the exponential one.
Measure equilibrium_chance(double time, const std::vector<int>& axes = {});

/// Mean squared displacement in a time of `lag`, over all times and particles.
Measure squared_displacement(double lag, const Which& which = all());

/// Mean squared displacement of all particles since time 0.
Measure squared_displacement_until(double time);

/// Root mean square distance of all particles between two times.
Measure distance_between(double earlier, double later);

/// Distance of particle 0 from its place in the run beside.
Measure distance_from_beside(double time);

}  // namespace carom::test
