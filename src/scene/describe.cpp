#include "scene/describe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "physics/reversal/mirrored_events.h"
#include "physics/vec.h"
#include "physics/ways_back.h"
#include "scene/scene.h"
#include "scene/yaml/scalar.h"
#include "util/overloaded.h"
#include "util/text.h"

namespace carom {
namespace {

std::string start_of(Language language, const Species& species) {
    if (const auto* speed = std::get_if<Speed>(&species.velocity)) {
        if (const auto* one = std::get_if<double>(&speed->value))
            return say(language, "at speed {}", *one);
        return say(language, "at different speeds");
    }
    if (const auto* temperature = std::get_if<Temperature>(&species.velocity))
        return temperature->is_exact
                   ? say(language, "at temperature {}", temperature->value)
                   : say(language, "with velocities sampled at temperature {}", temperature->value);
    return std::holds_alternative<AtRest>(species.velocity)
               ? say(language, "at rest")
               : say(language, "with given velocities");
}

std::string species_words(Language language, const Species& species, int dimension, bool several) {
    const std::string noun = particles_counted(language, species.count, dimension);
    const std::string start = start_of(language, species);
    return several ? say(language, "{} ({}, {})", noun, species.name, start)
                   : say(language, "{}, {},", noun, start);
}

// The words for where the particles are, and for what happens to those that leave through a
// periodic side.
struct BoxWords {
    std::string where, passage;
};

BoxWords words_of_space(Language language, const Box& box) {
    const double width = box.size[0], height = box.size[1], depth = box.size[2];
    std::vector<std::string> periodic;
    for (int axis = 0; axis < 3; ++axis)
        if (box.is_periodic(axis)) periodic.push_back(name_of_axis(axis));
    if (periodic.size() == 3)
        return {say(language, "in a periodic box of {} by {} by {}", width, height, depth),
                say(language, "What leaves on one side enters on the opposite side.")};
    if (!periodic.empty())
        return {say(language, "in a box of {} by {} by {}, periodic along {},", width, height,
                    depth, listed(language, periodic)),
                say(language, "What leaves on a periodic side enters on the opposite side.")};
    if (!box.surfaces.sides_reflect())
        return {say(language, "in a box of {} by {} by {}", width, height, depth), ""};
    return {say(language, "in a box of {} by {} by {} with solid walls", width, height, depth), ""};
}

BoxWords words_of(Language language, const Box& box) {
    if (box.dimension == 3) return words_of_space(language, box);
    const bool across = box.is_periodic(0), up = box.is_periodic(1);
    const bool walls_act = !box.surfaces.sides_reflect();
    const double width = box.size[0], height = box.size[1];
    if (box.dimension == 1) {
        if (!across) return {say(language, "on a wire of length {} between two walls", width), ""};
        return {say(language, "on a wire of length {} whose ends are joined", width),
                say(language,
                    "What leaves at the right end enters at the left, and the other way round.")};
    }
    if (walls_act && !across && !up)
        return {say(language, "in a box of {} by {}", width, height), ""};
    if (across && up)
        return {say(language, "in a periodic box of {} by {}", width, height),
                say(language, "What leaves on one side enters on the opposite side.")};
    if (across)
        return {
            say(language, "in a box of {} by {} with solid walls at the bottom and at the top,",
                width, height),
            say(language, "What leaves on the left enters on the right, and the other way round.")};
    if (up)
        return {
            say(language, "in a box of {} by {} with solid walls on the left and right,", width,
                height),
            say(language, "What leaves at the top enters at the bottom, and the other way round.")};
    return {say(language, "in a box of {} by {} with solid walls", width, height), ""};
}

// "particles slower than 2"; empty if it lets none through.
std::string passing_words(Language language, const Membrane::Speeds& speeds) {
    if (std::isinf(speeds.faster_than)) return "";
    const bool from = speeds.faster_than > 0.0, to = std::isfinite(speeds.slower_than);
    if (from && to)
        return say(language, "particles faster than {} and slower than {}", speeds.faster_than,
                   speeds.slower_than);
    if (from) return say(language, "particles faster than {}", speeds.faster_than);
    return to ? say(language, "particles slower than {}", speeds.slower_than)
              : say(language, "particles");
}

std::string words_of(Language language, const Membrane& membrane, const Gas& gas, int axis) {
    std::vector<std::string> passes;
    for (const std::int32_t s : membrane.species)
        passes.push_back(gas.species.at(static_cast<std::size_t>(s)).name);
    const auto add = [&](const Membrane::Speeds& speeds, Phrase where) {
        const std::string who = passing_words(language, speeds);
        if (!who.empty()) passes.push_back(say(language, "{} {}", who, say(language, where)));
    };
    if (membrane.species.empty()) {
        const auto [up, down] = ways_across(axis);
        add(membrane.upward, up);
        add(membrane.downward, down);
    }
    return say(language, "lets {} through", listed(language, passes));
}

std::string words_of(Language language, const Partition& partition, const std::string& subject,
                     const Gas& gas) {
    const std::string what = only_reflects(partition.behaviour)
                                 ? say(language, "divides the box")
                                 : words_of(language, partition.behaviour, gas, partition.axis);
    std::string text = say(language, "{} at {} = {} {}", subject, name_of_axis(partition.axis),
                           partition.at, what);
    const auto gaps = static_cast<long long>(partition.gaps.size());
    if (gaps > 0)
        text += " " + counted(language, gaps, Phrase{"and has {} gap"}, Phrase{"and has {} gaps"});
    if (partition.is_open) text += say(language, "; it is open at the start");
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

std::string words_of_gravity(Language language, const Vec& g, int dimension) {
    const auto is_along = [&](int axis) {
        return g[(axis + 1) % 3] == 0.0 && g[(axis + 2) % 3] == 0.0;
    };
    if (is_along(0))
        return g[0] > 0.0 ? say(language, "Gravity pulls to the right with acceleration {}", g[0])
                          : say(language, "Gravity pulls to the left with acceleration {}", -g[0]);
    if (is_along(1))
        return g[1] > 0.0 ? say(language, "Gravity pulls up with acceleration {}", g[1])
                          : say(language, "Gravity pulls down with acceleration {}", -g[1]);
    if (is_along(2))
        return g[2] > 0.0 ? say(language, "Gravity pulls to the front with acceleration {}", g[2])
                          : say(language, "Gravity pulls to the back with acceleration {}", -g[2]);
    if (dimension == 2)
        return say(language, "Gravity pulls with acceleration ({}; {})",
                   plain_number(language, g[0]), plain_number(language, g[1]));
    return say(language, "Gravity pulls with acceleration ({}; {}; {})",
               plain_number(language, g[0]), plain_number(language, g[1]),
               plain_number(language, g[2]));
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

std::string words_of(Language language, const Behaviour& behaviour, const Gas& gas, int axis) {
    return std::visit(
        Overloaded{
            [&](const Reflecting&) { return say(language, "is solid"); },
            [&](const Bath& bath) {
                return say(language, "is a heat bath of temperature {}", bath.temperature);
            },
            [&](const Driven& driven) {
                const std::string velocity = plain_number(language, driven.velocity);
                return std::isinf(driven.until)
                           ? say(language, "moves at velocity {}", velocity)
                           : say(language, "moves at velocity {} until time {}", velocity,
                                 driven.until);
            },
            [&](const Piston& piston) {
                return piston.force == 0.0
                           ? say(language, "is a piston of mass {}", piston.mass)
                           : say(language, "is a piston of mass {}, pushed by a force of {}",
                                 piston.mass, plain_number(language, piston.force));
            },
            [&](const Membrane& membrane) { return words_of(language, membrane, gas, axis); },
            [&](const Diffuse&) { return say(language, "reflects diffusely"); }},
        behaviour);
}

std::string words_of(Language language, const Perturbation& nudge) {
    const auto length = [&](std::size_t axis) {
        return parse_number(nudge.by[axis]).value_or(0.0);
    };
    return say(language, "Particle {} is moved by {}", nudge.particle,
               three_digits(language, std::hypot(length(0), length(1), length(2))));
}

std::vector<std::string> words_of_surfaces(Language language, const Gas& gas) {
    const Surfaces& surfaces = gas.box.surfaces;
    std::vector<std::string> sentences;
    std::int32_t surface = 0;
    for (const Behaviour& side : surfaces.numbered_sides()) {
        if (!only_reflects(side))
            sentences.push_back(say(language, "{} {}", name_of_surface(language, surface, gas),
                                    words_of(language, side, gas, surfaces.axis_of(surface))));
        ++surface;
    }
    for (const Partition& one : surfaces.partitions)
        sentences.push_back(
            words_of(language, one, name_of_surface(language, surface++, gas), gas));
    if (!surfaces.obstacles.empty()) sentences.push_back(words_of(language, surfaces.obstacles));
    if (surfaces.has_gravity())
        sentences.push_back(words_of_gravity(language, surfaces.gravity, gas.box.dimension));
    return sentences;
}

namespace {

std::string change_words(Language language, const Behaviour& behaviour) {
    return std::visit(
        Overloaded{[&](const Reflecting&) { return say(language, "becomes an ordinary wall"); },
                   [&](const Bath& bath) {
                       return say(language, "becomes a heat bath of temperature {}",
                                  bath.temperature);
                   },
                   [&](const Driven& driven) {
                       return say(language, "moves at velocity {}",
                                  plain_number(language, driven.velocity));
                   },
                   [&](const Piston& piston) {
                       return say(language, "becomes a piston of mass {}", piston.mass);
                   },
                   [&](const Membrane&) { return say(language, "becomes a membrane"); },
                   [&](const Diffuse&) { return say(language, "reflects diffusely from now on"); }},
        behaviour);
}

std::string heat_words(Language language, const Heat& heat, const Gas& gas) {
    const std::string whom =
        heat.species
            ? say(language, "“{}”", gas.species[static_cast<std::size_t>(*heat.species)].name)
            : say(language, "The gas");
    if (const auto* to = std::get_if<Temperature>(&heat.amount))
        return say(language, "{} is brought to temperature {}", whom, to->value);
    const double energy = std::get<double>(heat.amount);
    const std::string amount = plain_number(language, std::abs(energy));
    return energy < 0.0 ? say(language, "{} loses the energy {}", whom, amount)
                        : say(language, "{} receives the energy {}", whom, amount);
}

}  // namespace

std::string words_of_surface_event(Language language, const RunEvent& event, const Gas& gas) {
    const auto with = [&](std::int32_t surface, const std::string& what) {
        return say(language, "{} {}", name_of_surface(language, surface, gas), what);
    };
    return std::visit(
        Overloaded{[](const ReverseVelocities&) { return std::string(); },
                   [](const Perturbation&) { return std::string(); },
                   [&](const SetOpen& action) {
                       return with(action.surface, action.is_open ? say(language, "opens")
                                                                  : say(language, "closes"));
                   },
                   [&](const MoveSurface& action) {
                       return with(action.surface,
                                   action.velocity == 0.0
                                       ? say(language, "stands still from now on")
                                       : say(language, "moves at velocity {}",
                                             plain_number(language, action.velocity)));
                   },
                   [&](const HoldPiston& action) {
                       return with(action.surface, say(language, "is held"));
                   },
                   [&](const ReleasePiston& action) {
                       return with(action.surface, say(language, "is released"));
                   },
                   [&](const ChangeSurface& action) {
                       return with(action.surface, change_words(language, action.behaviour));
                   },
                   [&](const Heat& action) { return heat_words(language, action, gas); }},
        event.action);
}

namespace {

std::string words_of(Language language, const MirroredEvent& mirrored, const Run& run,
                     const Gas& gas) {
    const RunEvent& event = run.events.at(mirrored.event);
    if (!mirrored.is_undone) return words_of_surface_event(language, event, gas);
    if (const auto given = given_behaviour(event))
        return say(language, "{} behaves again as it did before",
                   name_of_surface(language, given->first, gas));
    if (const std::optional<RunEvent> opposite = opposite_of(event))
        return words_of_surface_event(language, *opposite, gas);
    return heats(event)
               ? say(language,
                     "The gas loses the energy that it was given, or gets back what it lost")
               : "";
}

// Returns an empty text if the gas returns the way it came.
std::string words_of(Language language, const WayBack& way, const Run& run) {
    if (!way.event || way.end >= run.until) return "";
    const RunEvent& event = run.events.at(*way.event);
    if (event.at >= way.begin) return say(language, "The gas no longer retraces its path");
    return say(language,
               "The gas no longer retraces its path, as what happened at time {} is not undone",
               event.at);
}

}  // namespace

std::vector<Happening> happenings(Language language, const Run& run, const Gas& gas) {
    std::vector<Happening> all;
    for (const RunEvent& event : run.events)
        all.push_back({event.at, say(language, "time {}", event.at),
                       words_of_surface_event(language, event, gas)});
    for (const MirroredEvent& mirrored : mirrored_events(run))
        all.push_back({mirrored.at, say(language, "time {}, on the way back", mirrored.at),
                       words_of(language, mirrored, run, gas)});
    for (const WayBack& way : ways_back(run.events))
        all.push_back({way.end, say(language, "time {}", plain_number(language, way.end)),
                       words_of(language, way, run)});
    std::erase_if(all, [](const Happening& one) { return one.words.empty(); });
    return all;
}

std::string words_of_events(Language language, const Run& run, const Gas& gas) {
    constexpr std::size_t most_told = 3, most_of_surfaces = 8;
    std::vector<std::string> times, sentences, nudges;
    for (const double time : reversal_times(run))
        times.push_back(localised(language, fmt::format("{}", time)));
    if (!times.empty())
        sentences.push_back(
            say(language, "At time {} all velocities are reversed.", listed(language, times)));
    for (const RunEvent& event : run.events)
        if (const auto* nudge = perturbation_of(event))
            nudges.push_back(say(language, "{} at time {}.", words_of(language, *nudge), event.at));
    if (nudges.size() > most_told)
        nudges = {say(language, "A particle is moved by a small amount {} times.", nudges.size())};
    sentences.insert(sentences.end(), nudges.begin(), nudges.end());
    const std::vector<Happening> changes = happenings(language, run, gas);
    if (changes.size() > most_of_surfaces)
        sentences.push_back(say(language,
                                "A wall, a partition or the energy of the gas is changed {} times.",
                                changes.size()));
    else
        for (const Happening& one : changes)
            sentences.push_back(say(language, "At {}: {}.", one.when, one.words));
    return fmt::format("{}", fmt::join(sentences, " "));
}

std::string describe(const Scene& scene) {
    const Language language = scene.film.language;
    const Gas& gas = scene.gas;
    std::vector<std::string> groups;
    for (const Species& species : gas.species)
        groups.push_back(
            species_words(language, species, gas.box.dimension, gas.species.size() > 1));
    const bool alone = gas.species.size() == 1 && gas.species[0].count == 1;
    const auto [where, passage] = words_of(language, gas.box);
    const std::string all_groups = listed(language, groups);
    std::vector<std::string> sentences{
        alone ? say(language, "{} starts {} and collides elastically.", all_groups, where)
              : say(language, "{} start {} and collide elastically.", all_groups, where)};
    if (!passage.empty()) sentences.push_back(passage);
    constexpr std::size_t most_told = 10;
    const std::vector<std::string> surfaces = words_of_surfaces(language, gas);
    for (std::size_t k = 0; k < std::min(most_told, surfaces.size()); ++k)
        sentences.push_back(surfaces[k] + ".");
    if (surfaces.size() > most_told)
        sentences.push_back(
            say(language, "There are {} more walls and partitions.", surfaces.size() - most_told));
    const std::string events = words_of_events(language, scene.run, gas);
    if (!events.empty()) sentences.push_back(events);
    return fmt::format("{}", fmt::join(sentences, " "));
}

}  // namespace carom
