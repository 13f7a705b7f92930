#include "scene/describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "physics/reversal/mirrored_events.h"
#include "physics/units/gas_table.h"
#include "physics/vec.h"
#include "physics/ways_back.h"
#include "scene/scene.h"
#include "scene/yaml/scalar.h"
#include "util/overloaded.h"
#include "util/text.h"

namespace carom {
namespace {

std::string start_of(const Wording& wording, const Species& species) {
    if (const auto* speed = std::get_if<Speed>(&species.velocity)) {
        if (const auto* one = std::get_if<double>(&speed->value))
            return say(wording, "at speed {}", all_digits(wording, quantities::speed, *one));
        return say(wording, "at different speeds");
    }
    if (const auto* temperature = std::get_if<Temperature>(&species.velocity))
        return temperature->is_exact
                   ? say(wording, "at temperature {}",
                         all_digits(wording, quantities::temperature, temperature->value))
                   : say(wording, "with velocities sampled at temperature {}",
                         all_digits(wording, quantities::temperature, temperature->value));
    return std::holds_alternative<AtRest>(species.velocity) ? say(wording, "at rest")
                                                            : say(wording, "with given velocities");
}

std::string species_words(const Wording& wording, const Species& species, int dimension,
                          bool several) {
    const std::string noun = particles_counted(wording, species.count, dimension);
    const std::string start = start_of(wording, species);
    return several ? say(wording, "{} ({}, {})", noun, species.name, start)
                   : say(wording, "{}, {},", noun, start);
}

// The words for where the particles are, and for what happens to those that leave through a
// periodic side.
struct BoxWords {
    std::string where, passage;
};

BoxWords words_of_space(const Wording& wording, const Box& box) {
    const std::string width = all_digits(wording, quantities::length, box.size[0]),
                      height = all_digits(wording, quantities::length, box.size[1]),
                      depth = all_digits(wording, quantities::length, box.size[2]);
    std::vector<std::string> periodic;
    for (int axis = 0; axis < 3; ++axis)
        if (box.is_periodic(axis)) periodic.push_back(name_of_axis(axis));
    if (periodic.size() == 3)
        return {say(wording, "in a periodic box of {} by {} by {}", width, height, depth),
                say(wording, "What leaves on one side enters on the opposite side.")};
    if (!periodic.empty())
        return {say(wording, "in a box of {} by {} by {}, periodic along {},", width, height, depth,
                    listed(wording, periodic)),
                say(wording, "What leaves on a periodic side enters on the opposite side.")};
    if (!box.surfaces.sides_reflect())
        return {say(wording, "in a box of {} by {} by {}", width, height, depth), ""};
    return {say(wording, "in a box of {} by {} by {} with solid walls", width, height, depth), ""};
}

BoxWords words_of(const Wording& wording, const Box& box) {
    if (box.dimension == 3) return words_of_space(wording, box);
    const bool across = box.is_periodic(0), up = box.is_periodic(1);
    const bool walls_act = !box.surfaces.sides_reflect();
    const std::string width = all_digits(wording, quantities::length, box.size[0]),
                      height = all_digits(wording, quantities::length, box.size[1]);
    if (box.dimension == 1) {
        if (!across) return {say(wording, "on a wire of length {} between two walls", width), ""};
        return {say(wording, "on a wire of length {} whose ends are joined", width),
                say(wording,
                    "What leaves at the right end enters at the left, and the other way round.")};
    }
    if (walls_act && !across && !up)
        return {say(wording, "in a box of {} by {}", width, height), ""};
    if (across && up)
        return {say(wording, "in a periodic box of {} by {}", width, height),
                say(wording, "What leaves on one side enters on the opposite side.")};
    if (across)
        return {
            say(wording, "in a box of {} by {} with solid walls at the bottom and at the top,",
                width, height),
            say(wording, "What leaves on the left enters on the right, and the other way round.")};
    if (up)
        return {
            say(wording, "in a box of {} by {} with solid walls on the left and right,", width,
                height),
            say(wording, "What leaves at the top enters at the bottom, and the other way round.")};
    return {say(wording, "in a box of {} by {} with solid walls", width, height), ""};
}

// "particles slower than 2"; empty if it lets none through.
std::string passing_words(const Wording& wording, const Membrane::Speeds& speeds) {
    if (std::isinf(speeds.faster_than)) return "";
    const bool from = speeds.faster_than > 0.0, to = std::isfinite(speeds.slower_than);
    const auto number = [&](double speed) { return all_digits(wording, quantities::speed, speed); };
    if (from && to)
        return say(wording, "particles faster than {} and slower than {}",
                   number(speeds.faster_than), number(speeds.slower_than));
    if (from) return say(wording, "particles faster than {}", number(speeds.faster_than));
    return to ? say(wording, "particles slower than {}", number(speeds.slower_than))
              : say(wording, "particles");
}

std::string words_of(const Wording& wording, const Membrane& membrane, const Gas& gas, int axis) {
    std::vector<std::string> passes;
    for (const std::int32_t s : membrane.species)
        passes.push_back(gas.species.at(static_cast<std::size_t>(s)).name);
    const auto add = [&](const Membrane::Speeds& speeds, Phrase where) {
        const std::string who = passing_words(wording, speeds);
        if (!who.empty()) passes.push_back(say(wording, "{} {}", who, say(wording, where)));
    };
    if (membrane.species.empty()) {
        const auto [up, down] = ways_across(axis);
        add(membrane.upward, up);
        add(membrane.downward, down);
    }
    return say(wording, "lets {} through", listed(wording, passes));
}

std::string words_of(const Wording& wording, const Partition& partition, const std::string& subject,
                     const Gas& gas) {
    const std::string what = only_reflects(partition.behaviour)
                                 ? say(wording, "divides the box")
                                 : words_of(wording, partition.behaviour, gas, partition.axis);
    std::string text = say(wording, "{} at {} = {} {}", subject, name_of_axis(partition.axis),
                           all_digits(wording, quantities::position, partition.at), what);
    const auto gaps = static_cast<long long>(partition.gaps.size());
    if (gaps > 0)
        text += " " + counted(wording, gaps, Phrase{"and has {} gap"}, Phrase{"and has {} gaps"});
    if (partition.is_open) text += say(wording, "; it is open at the start");
    return text;
}

std::string words_of(Language language, const std::vector<Obstacle>& obstacles) {
    constexpr std::size_t most_named = 6;
    const auto count = static_cast<long long>(obstacles.size());
    const std::string text = counted(language, count, Phrase{"An obstacle stands in the box"},
                                     Phrase{"{} obstacles stand in the box"});
    if (obstacles.size() > most_named) return text;
    std::vector<std::string> names;
    for (const Obstacle& one : obstacles) names.push_back(one.name);
    return say(language, "{}: {}", text, listed(language, names));
}

std::string words_of_gravity(const Wording& wording, const Vec& g, int dimension) {
    const auto is_along = [&](int axis) {
        return g[(axis + 1) % 3] == 0.0 && g[(axis + 2) % 3] == 0.0;
    };
    const Quantity acceleration = quantities::speed / quantities::time;
    const auto number = [&](double along) { return all_digits(wording, acceleration, along); };
    if (is_along(0))
        return g[0] > 0.0
                   ? say(wording, "Gravity pulls to the right with acceleration {}", number(g[0]))
                   : say(wording, "Gravity pulls to the left with acceleration {}", number(-g[0]));
    if (is_along(1))
        return g[1] > 0.0 ? say(wording, "Gravity pulls up with acceleration {}", number(g[1]))
                          : say(wording, "Gravity pulls down with acceleration {}", number(-g[1]));
    if (is_along(2))
        return g[2] > 0.0
                   ? say(wording, "Gravity pulls to the front with acceleration {}", number(g[2]))
                   : say(wording, "Gravity pulls to the back with acceleration {}", number(-g[2]));
    if (dimension == 2)
        return say(wording, "Gravity pulls with acceleration ({}; {})",
                   plain_number(wording, acceleration, g[0]),
                   plain_number(wording, acceleration, g[1]));
    return say(wording, "Gravity pulls with acceleration ({}; {}; {})",
               plain_number(wording, acceleration, g[0]), plain_number(wording, acceleration, g[1]),
               plain_number(wording, acceleration, g[2]));
}

}  // namespace

std::string particles_counted(Language language, long long count, int dimension) {
    if (dimension == 1) return counted(language, count, Phrase{"{} bead"}, Phrase{"{} beads"});
    if (dimension == 2) return counted(language, count, Phrase{"{} disk"}, Phrase{"{} disks"});
    return counted(language, count, Phrase{"{} sphere"}, Phrase{"{} spheres"});
}

std::array<Phrase, 2> ways_across(int axis) {
    if (axis == 0) return {Phrase{"to the right"}, Phrase{"to the left"}};
    if (axis == 1) return {Phrase{"upwards"}, Phrase{"downwards"}};
    return {Phrase{"to the front"}, Phrase{"to the back"}};
}

std::string name_of_surface(Language language, std::int32_t surface, const Gas& gas) {
    constexpr std::array walls{Phrase{"The left wall"},  Phrase{"The right wall"},
                               Phrase{"The lower wall"}, Phrase{"The upper wall"},
                               Phrase{"The back wall"},  Phrase{"The front wall"}};
    constexpr std::array ends{Phrase{"The left end"}, Phrase{"The right end"}};
    const auto k = static_cast<std::size_t>(surface);
    if (gas.box.dimension == 1 && k < ends.size()) return say(language, ends.at(k));
    if (gas.box.surfaces.is_side(surface)) return say(language, walls.at(k));
    const std::string name = gas.box.surfaces.names().at(k);
    return gas.box.surfaces.partition(surface) != nullptr
               ? say(language, "The partition “{}”", name)
               : say(language, "The obstacle “{}”", name);
}

std::string words_of(const Wording& wording, const Behaviour& behaviour, const Gas& gas, int axis) {
    return std::visit(
        Overloaded{[&](const Reflecting&) { return say(wording, "is solid"); },
                   [&](const Bath& bath) {
                       return say(wording, "is a heat bath of temperature {}",
                                  all_digits(wording, quantities::temperature, bath.temperature));
                   },
                   [&](const Driven& driven) {
                       const std::string velocity =
                           plain_number(wording, quantities::velocity, driven.velocity);
                       return std::isinf(driven.until)
                                  ? say(wording, "moves at velocity {}", velocity)
                                  : say(wording, "moves at velocity {} until time {}", velocity,
                                        all_digits(wording, quantities::time, driven.until));
                   },
                   [&](const Piston& piston) {
                       const std::string mass = all_digits(wording, quantities::mass, piston.mass);
                       return piston.force == 0.0
                                  ? say(wording, "is a piston of mass {}", mass)
                                  : say(wording, "is a piston of mass {}, pushed by a force of {}",
                                        mass,
                                        plain_number(wording, quantities::force, piston.force));
                   },
                   [&](const Membrane& membrane) { return words_of(wording, membrane, gas, axis); },
                   [&](const Diffuse&) { return say(wording, "reflects diffusely"); }},
        behaviour);
}

std::string words_of(const Wording& wording, const Perturbation& nudge) {
    const auto length = [&](std::size_t axis) {
        return parse_number(nudge.by[axis]).value_or(0.0);
    };
    return say(
        wording, "Particle {} is moved by {}", nudge.particle,
        three_digits(wording, quantities::length, std::hypot(length(0), length(1), length(2))));
}

std::vector<std::string> words_of_surfaces(const Wording& wording, const Gas& gas) {
    const Surfaces& surfaces = gas.box.surfaces;
    std::vector<std::string> sentences;
    std::int32_t surface = 0;
    for (const Behaviour& side : surfaces.numbered_sides()) {
        if (!only_reflects(side))
            sentences.push_back(say(wording, "{} {}", name_of_surface(wording, surface, gas),
                                    words_of(wording, side, gas, surfaces.axis_of(surface))));
        ++surface;
    }
    for (const Partition& one : surfaces.partitions)
        sentences.push_back(words_of(wording, one, name_of_surface(wording, surface++, gas), gas));
    if (!surfaces.obstacles.empty()) sentences.push_back(words_of(wording, surfaces.obstacles));
    if (surfaces.has_gravity())
        sentences.push_back(words_of_gravity(wording, surfaces.gravity, gas.box.dimension));
    return sentences;
}

namespace {

std::string change_words(const Wording& wording, const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[&](const Reflecting&) { return say(wording, "becomes an ordinary wall"); },
                   [&](const Bath& bath) {
                       return say(wording, "becomes a heat bath of temperature {}",
                                  all_digits(wording, quantities::temperature, bath.temperature));
                   },
                   [&](const Driven& driven) {
                       return say(wording, "moves at velocity {}",
                                  plain_number(wording, quantities::velocity, driven.velocity));
                   },
                   [&](const Piston& piston) {
                       return say(wording, "becomes a piston of mass {}",
                                  all_digits(wording, quantities::mass, piston.mass));
                   },
                   [&](const Membrane&) { return say(wording, "becomes a membrane"); },
                   [&](const Diffuse&) { return say(wording, "reflects diffusely from now on"); }},
        behaviour);
}

std::string heat_words(const Wording& wording, const Heat& heat, const Gas& gas) {
    const std::string whom =
        heat.species
            ? say(wording, "“{}”", gas.species[static_cast<std::size_t>(*heat.species)].name)
            : say(wording, "The gas");
    if (const auto* to = std::get_if<Temperature>(&heat.amount))
        return say(wording, "{} is brought to temperature {}", whom,
                   all_digits(wording, quantities::temperature, to->value));
    const double energy = std::get<double>(heat.amount);
    const std::string amount = plain_number(wording, quantities::energy, std::abs(energy));
    return energy < 0.0 ? say(wording, "{} loses the energy {}", whom, amount)
                        : say(wording, "{} receives the energy {}", whom, amount);
}

}  // namespace

std::string words_of_surface_event(const Wording& wording, const RunEvent& event, const Gas& gas) {
    const auto with = [&](std::int32_t surface, const std::string& what) {
        return say(wording, "{} {}", name_of_surface(wording, surface, gas), what);
    };
    return std::visit(
        Overloaded{
            [](const ReverseVelocities&) { return std::string(); },
            [](const Perturbation&) { return std::string(); },
            [&](const SetOpen& action) {
                return with(action.surface,
                            action.is_open ? say(wording, "opens") : say(wording, "closes"));
            },
            [&](const MoveSurface& action) {
                return with(action.surface, action.velocity == 0.0
                                                ? say(wording, "stands still from now on")
                                                : say(wording, "moves at velocity {}",
                                                      plain_number(wording, quantities::velocity,
                                                                   action.velocity)));
            },
            [&](const HoldPiston& action) { return with(action.surface, say(wording, "is held")); },
            [&](const ReleasePiston& action) {
                return with(action.surface, say(wording, "is released"));
            },
            [&](const ChangeSurface& action) {
                return with(action.surface, change_words(wording, action.behaviour));
            },
            [&](const Heat& action) { return heat_words(wording, action, gas); }},
        event.action);
}

namespace {

std::string words_of(const Wording& wording, const MirroredEvent& mirrored, const Run& run,
                     const Gas& gas) {
    const RunEvent& event = run.events.at(mirrored.event);
    if (!mirrored.is_undone) return words_of_surface_event(wording, event, gas);
    if (const auto given = given_behaviour(event))
        return say(wording, "{} behaves again as it did before",
                   name_of_surface(wording, given->first, gas));
    if (const std::optional<RunEvent> opposite = opposite_of(event))
        return words_of_surface_event(wording, *opposite, gas);
    return heats(event)
               ? say(wording,
                     "The gas loses the energy that it was given, or gets back what it lost")
               : "";
}

// Returns an empty text if the gas returns the way it came.
std::string words_of(const Wording& wording, const WayBack& way, const Run& run) {
    if (!way.event || way.end >= run.until) return "";
    const RunEvent& event = run.events.at(*way.event);
    if (event.at >= way.begin) return say(wording, "The gas no longer retraces its path");
    return say(wording,
               "The gas no longer retraces its path, as what happened at time {} is not undone",
               all_digits(wording, quantities::time, event.at));
}

}  // namespace

std::vector<Happening> happenings(const Wording& wording, const Run& run, const Gas& gas) {
    std::vector<Happening> all;
    for (const RunEvent& event : run.events)
        all.push_back({event.at,
                       say(wording, "time {}", all_digits(wording, quantities::time, event.at)),
                       words_of_surface_event(wording, event, gas)});
    for (const MirroredEvent& mirrored : mirrored_events(run))
        all.push_back({mirrored.at,
                       say(wording, "time {}, on the way back",
                           all_digits(wording, quantities::time, mirrored.at)),
                       words_of(wording, mirrored, run, gas)});
    for (const WayBack& way : ways_back(run.events))
        all.push_back({way.end,
                       say(wording, "time {}", plain_number(wording, quantities::time, way.end)),
                       words_of(wording, way, run)});
    std::erase_if(all, [](const Happening& one) { return one.words.empty(); });
    return all;
}

std::string words_of_events(const Wording& wording, const Run& run, const Gas& gas) {
    constexpr std::size_t most_told = 3, most_of_surfaces = 8;
    std::vector<std::string> times, sentences, nudges;
    for (const double time : reversal_times(run))
        times.push_back(all_digits(wording, quantities::time, time));
    if (!times.empty())
        sentences.push_back(
            say(wording, "At time {} all velocities are reversed.", listed(wording, times)));
    for (const RunEvent& event : run.events)
        if (const auto* nudge = perturbation_of(event))
            nudges.push_back(say(wording, "{} at time {}.", words_of(wording, *nudge),
                                 all_digits(wording, quantities::time, event.at)));
    if (nudges.size() > most_told)
        nudges = {say(wording, "A particle is moved by a small amount {} times.", nudges.size())};
    sentences.insert(sentences.end(), nudges.begin(), nudges.end());
    const std::vector<Happening> changes = happenings(wording, run, gas);
    if (changes.size() > most_of_surfaces)
        sentences.push_back(say(wording,
                                "A wall, a partition or the energy of the gas is changed {} times.",
                                changes.size()));
    else
        for (const Happening& one : changes)
            sentences.push_back(say(wording, "At {}: {}.", one.when, one.words));
    return fmt::format("{}", fmt::join(sentences, " "));
}

std::string words_of_molecules(Language language, const std::vector<const NamedGas*>& gases) {
    std::vector<std::string> names;
    for (const NamedGas* gas : gases) {
        if (gas == nullptr || gas->is_monatomic) continue;
        std::string name = say(language, gas->name);
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    if (names.empty()) return "";
    return say(language, "The molecules ({}) are spheres here, which neither rotate nor vibrate.",
               listed(language, names));
}

std::string describe(const Scene& scene) {
    const Wording wording = wording_of(scene);
    const Gas& gas = scene.gas;
    std::vector<std::string> groups;
    for (const Species& species : gas.species)
        groups.push_back(
            species_words(wording, species, gas.box.dimension, gas.species.size() > 1));
    const bool alone = gas.species.size() == 1 && gas.species[0].count == 1;
    const auto [where, passage] = words_of(wording, gas.box);
    const std::string all_groups = listed(wording, groups);
    std::vector<std::string> sentences{
        alone ? say(wording, "{} starts {} and collides elastically.", all_groups, where)
              : say(wording, "{} start {} and collide elastically.", all_groups, where)};
    if (const std::string molecules = words_of_molecules(wording, scene.named_gases);
        !molecules.empty())
        sentences.push_back(molecules);
    if (!passage.empty()) sentences.push_back(passage);
    constexpr std::size_t most_told = 10;
    const std::vector<std::string> surfaces = words_of_surfaces(wording, gas);
    for (std::size_t k = 0; k < std::min(most_told, surfaces.size()); ++k)
        sentences.push_back(surfaces[k] + ".");
    if (surfaces.size() > most_told)
        sentences.push_back(
            say(wording, "There are {} more walls and partitions.", surfaces.size() - most_told));
    const std::string events = words_of_events(wording, scene.run, gas);
    if (!events.empty()) sentences.push_back(events);
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace carom
