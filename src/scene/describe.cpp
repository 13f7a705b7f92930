#include "scene/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "physics/reversal/mirrored_events.h"
#include "physics/ways_back.h"
#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {
namespace {

std::string start_of(const Species& species) {
    if (const auto* speed = std::get_if<Speed>(&species.velocity)) {
        if (const auto* one = std::get_if<double>(&speed->value))
            return fmt::format("at speed {}", *one);
        return "at different speeds";
    }
    if (const auto* temperature = std::get_if<Temperature>(&species.velocity))
        return (temperature->is_exact ? "at temperature "
                                      : "with velocities sampled at temperature ") +
               fmt::format("{}", temperature->value);
    return std::holds_alternative<AtRest>(species.velocity) ? "at rest" : "with given velocities";
}

std::string species_words(const Species& species, int dimension, bool several) {
    const std::string noun =
        std::string(dimension == 1 ? "bead" : "disk") + (species.count == 1 ? "" : "s");
    return several
               ? fmt::format("{} {} ({}, {})", species.count, noun, species.name, start_of(species))
               : fmt::format("{} {}, {},", species.count, noun, start_of(species));
}

// Where the particles are, and what becomes of those that leave through a periodic side.
struct BoxWords {
    std::string where, passage;
};

BoxWords words_of(const Box& box) {
    const bool across = box.is_periodic(0), up = box.is_periodic(1);
    const bool walls_act = std::ranges::any_of(box.surfaces.sides, [](const Behaviour& side) {
        return !std::holds_alternative<Reflecting>(side);
    });
    if (box.dimension == 1) {
        const std::string wire = fmt::format("on a wire of length {}", box.size[0]);
        if (!across) return {wire + " between two walls", ""};
        return {wire + " whose ends are joined",
                " What leaves at the right end enters at the left, and the other way round."};
    }
    if (walls_act && !across && !up)
        return {fmt::format("in a box of {} by {}", box.size[0], box.size[1]), ""};
    const std::string size = fmt::format("box of {} by {}", box.size[0], box.size[1]);
    if (across && up)
        return {"in a periodic " + size, " What leaves on one side enters on the opposite side."};
    if (across)
        return {fmt::format("in a {} with solid walls below and above,", size),
                " What leaves on the left enters on the right, and the other way round."};
    if (up)
        return {fmt::format("in a {} with solid walls on the left and right,", size),
                " What leaves at the top enters at the bottom, and the other way round."};
    return {fmt::format("in a {} with solid walls", size), ""};
}

std::string words_of(const Membrane& membrane, const Gas& gas, int axis) {
    std::vector<std::string> passes;
    for (const std::int32_t s : membrane.species)
        passes.push_back(gas.species.at(static_cast<std::size_t>(s)).name);
    if (!passes.empty()) return fmt::format("lets {} through", listed(passes));
    const auto add = [&](const Membrane::Speeds& speeds, const char* where) {
        if (std::isinf(speeds.faster_than)) return;
        std::string which;
        if (speeds.faster_than > 0.0) which = fmt::format(" faster than {}", speeds.faster_than);
        if (std::isfinite(speeds.slower_than))
            which +=
                fmt::format("{} slower than {}", which.empty() ? "" : " and", speeds.slower_than);
        passes.push_back(fmt::format("particles{} {}", which, where));
    };
    add(membrane.upward, axis == 0 ? "to the right" : "upwards");
    add(membrane.downward, axis == 0 ? "to the left" : "downwards");
    return fmt::format("lets {} through", listed(passes));
}

std::string words_of(const Partition& partition, const std::string& subject, const Gas& gas) {
    std::string text =
        fmt::format("{} at {} = {} ", subject, partition.axis == 0 ? "x" : "y", partition.at);
    text += std::holds_alternative<Reflecting>(partition.behaviour)
                ? "divides the box"
                : words_of(partition.behaviour, gas, partition.axis);
    const auto gaps = static_cast<long long>(partition.gaps.size());
    if (gaps > 0) text += " and has " + counted(gaps, "gap");
    if (partition.is_open) text += "; it is open at the start";
    return text;
}

std::string words_of(const std::vector<Obstacle>& obstacles) {
    constexpr std::size_t most_named = 6;
    if (obstacles.size() > most_named)
        return fmt::format("{} obstacles stand in the box", obstacles.size());
    std::vector<std::string> names;
    for (const Obstacle& one : obstacles) names.push_back(one.name);
    return fmt::format("{} in the box: {}",
                       obstacles.size() == 1 ? "An obstacle stands" : "Obstacles stand",
                       listed(names));
}

std::string words_of_gravity(const Eigen::Array2d& g, int dimension) {
    const double size = std::hypot(g[0], g[1]);
    if (dimension == 1 || g[1] == 0.0)
        return fmt::format("pulls to the {} with acceleration {}", g[0] > 0.0 ? "right" : "left",
                           size);
    if (g[0] == 0.0)
        return fmt::format("pulls {} with acceleration {}", g[1] > 0.0 ? "up" : "down", size);
    return fmt::format("pulls with acceleration ({}, {})", plain_number(g[0]), plain_number(g[1]));
}

}  // namespace

std::string name_of_surface(std::int32_t surface, const Gas& gas) {
    constexpr std::array walls{"left", "right", "lower", "upper"};
    const auto k = static_cast<std::size_t>(surface);
    if (k < walls.size())
        return fmt::format("The {} {}", walls[k], gas.box.dimension == 1 ? "end" : "wall");
    const char* kind = gas.box.surfaces.partition(surface) != nullptr ? "partition" : "obstacle";
    return fmt::format("The {} “{}”", kind, gas.box.surfaces.names().at(k));
}

std::string words_of(const Behaviour& behaviour, const Gas& gas, int axis) {
    if (const auto* bath = std::get_if<Bath>(&behaviour))
        return fmt::format("is a heat bath of temperature {}", bath->temperature);
    if (const auto* driven = std::get_if<Driven>(&behaviour))
        return fmt::format(
            "moves at velocity {}{}", plain_number(driven->velocity),
            std::isinf(driven->until) ? "" : fmt::format(" until time {}", driven->until));
    if (const auto* piston = std::get_if<Piston>(&behaviour))
        return fmt::format(
            "is a piston of mass {}{}", piston->mass,
            piston->force == 0.0 ? "" : ", pushed by a force of " + plain_number(piston->force));
    if (const auto* membrane = std::get_if<Membrane>(&behaviour))
        return words_of(*membrane, gas, axis);
    return "is solid";
}

std::string words_of(const Perturbation& nudge) {
    const auto length = [&](std::size_t axis) {
        return parse_number(nudge.by[axis]).value_or(0.0);
    };
    return fmt::format("Particle {} is moved by {}", nudge.particle,
                       three_digits(std::hypot(length(0), length(1))));
}

std::vector<std::string> words_of_surfaces(const Gas& gas) {
    const Surfaces& surfaces = gas.box.surfaces;
    std::vector<std::string> sentences;
    std::int32_t surface = 0;
    for (const Behaviour& side : surfaces.sides) {
        if (!std::holds_alternative<Reflecting>(side))
            sentences.push_back(name_of_surface(surface, gas) + " " +
                                words_of(side, gas, surfaces.axis_of(surface)));
        ++surface;
    }
    for (const Partition& one : surfaces.partitions)
        sentences.push_back(words_of(one, name_of_surface(surface++, gas), gas));
    if (!surfaces.obstacles.empty()) sentences.push_back(words_of(surfaces.obstacles));
    if ((surfaces.gravity != 0.0).any())
        sentences.push_back("Gravity " + words_of_gravity(surfaces.gravity, gas.box.dimension));
    return sentences;
}

namespace {

std::string change_words(const Behaviour& behaviour) {
    if (const auto* bath = std::get_if<Bath>(&behaviour))
        return "becomes a heat bath of temperature " + plain_number(bath->temperature);
    if (const auto* piston = std::get_if<Piston>(&behaviour))
        return "becomes a piston of mass " + plain_number(piston->mass);
    if (const auto* driven = std::get_if<Driven>(&behaviour))
        return "moves at " + plain_number(driven->velocity);
    return std::holds_alternative<Membrane>(behaviour) ? "becomes a membrane" : "only reflects";
}

std::string heat_words(const Heat& heat, const Gas& gas) {
    const std::string whom =
        heat.species ? "“" + gas.species[static_cast<std::size_t>(*heat.species)].name + "”"
                     : "The gas";
    if (const auto* to = std::get_if<Temperature>(&heat.amount))
        return fmt::format("{} is brought to temperature {}", whom, plain_number(to->value));
    const double energy = std::get<double>(heat.amount);
    return fmt::format("{} is {} by an energy of {}", whom, energy < 0.0 ? "cooled" : "heated",
                       plain_number(std::abs(energy)));
}

}  // namespace

std::string words_of_surface_event(const RunEvent& event, const Gas& gas) {
    const auto with = [&](std::int32_t surface, const std::string& what) {
        return name_of_surface(surface, gas) + " " + what;
    };
    if (const auto* set = std::get_if<SetOpen>(&event.action))
        return with(set->surface, set->is_open ? "opens" : "closes");
    if (const auto* move = std::get_if<MoveSurface>(&event.action))
        return with(move->surface, move->velocity == 0.0
                                       ? "stands still from now on"
                                       : "moves at " + plain_number(move->velocity));
    if (const auto* hold = std::get_if<HoldPiston>(&event.action))
        return with(hold->surface, "is held");
    if (const auto* release = std::get_if<ReleasePiston>(&event.action))
        return with(release->surface, "is released");
    if (const auto* change = std::get_if<ChangeSurface>(&event.action))
        return with(change->surface, change_words(change->behaviour));
    if (const auto* heat = std::get_if<Heat>(&event.action)) return heat_words(*heat, gas);
    return "";
}

namespace {

std::string words_of(const MirroredEvent& mirrored, const Run& run, const Gas& gas) {
    const RunEvent& event = run.events.at(mirrored.event);
    if (!mirrored.is_undone) return words_of_surface_event(event, gas);
    if (const auto* move = std::get_if<MoveSurface>(&event.action))
        return name_of_surface(move->surface, gas) + " does again what it did before";
    if (const auto* change = std::get_if<ChangeSurface>(&event.action))
        return name_of_surface(change->surface, gas) + " does again what it did before";
    if (const std::optional<RunEvent> opposite = opposite_of(event))
        return words_of_surface_event(*opposite, gas);
    return std::holds_alternative<Heat>(event.action)
               ? "The gas loses the energy that it was given, or gets back what it lost"
               : "";
}

// Empty where the gas goes on the way it came.
std::string words_of(const WayBack& way, const Run& run) {
    if (!way.event || way.end >= run.until) return "";
    const RunEvent& event = run.events.at(*way.event);
    if (event.at >= way.begin) return "The gas leaves the way it came";
    return fmt::format("The gas leaves the way it came, as what happened at time {} is not undone",
                       event.at);
}

}  // namespace

std::vector<Happening> happenings(const Run& run, const Gas& gas) {
    std::vector<Happening> all;
    for (const RunEvent& event : run.events)
        all.push_back(
            {event.at, fmt::format("time {}", event.at), words_of_surface_event(event, gas)});
    for (const MirroredEvent& mirrored : mirrored_events(run))
        all.push_back({mirrored.at, fmt::format("time {}, on the way back", mirrored.at),
                       words_of(mirrored, run, gas)});
    for (const WayBack& way : ways_back(run.events))
        all.push_back({way.end, "time " + plain_number(way.end), words_of(way, run)});
    std::erase_if(all, [](const Happening& one) { return one.words.empty(); });
    return all;
}

std::string words_of_events(const Run& run, const Gas& gas) {
    constexpr std::size_t most_told = 3, most_of_surfaces = 8;
    std::string text;
    std::vector<std::string> times;
    for (const double time : reversal_times(run)) times.push_back(fmt::format("{}", time));
    if (!times.empty())
        text += fmt::format(" At time {} all velocities are reversed.", listed(times));
    std::vector<std::string> nudges;
    for (const RunEvent& event : run.events)
        if (const auto* nudge = std::get_if<Perturbation>(&event.action))
            nudges.push_back(fmt::format(" {} at time {}.", words_of(*nudge), event.at));
    if (nudges.size() > most_told)
        text += fmt::format(" {} times a particle is moved by a small amount.", nudges.size());
    else
        for (const std::string& one : nudges) text += one;
    const std::vector<Happening> changes = happenings(run, gas);
    if (changes.size() > most_of_surfaces)
        text += fmt::format(" {} times a wall, a partition or the heat of the gas is changed.",
                            changes.size());
    else
        for (const Happening& one : changes)
            text += fmt::format(" At {}: {}.", one.when, one.words);
    return text.empty() ? text : text.substr(1);
}

std::string describe(const Scene& scene) {
    const Gas& gas = scene.gas;
    std::vector<std::string> groups;
    for (const Species& species : gas.species)
        groups.push_back(species_words(species, gas.box.dimension, gas.species.size() > 1));
    const bool alone = gas.species.size() == 1 && gas.species[0].count == 1;
    const auto [where, passage] = words_of(gas.box);
    const std::string text =
        fmt::format("{} {} {} and {} elastically.", listed(groups), alone ? "starts" : "start",
                    where, alone ? "collides" : "collide") +
        passage;
    constexpr std::size_t most_told = 10;
    std::string all = text;
    const std::vector<std::string> surfaces = words_of_surfaces(gas);
    for (std::size_t k = 0; k < std::min(most_told, surfaces.size()); ++k)
        all += " " + surfaces[k] + ".";
    if (surfaces.size() > most_told)
        all += fmt::format(" There are {} more walls and partitions.", surfaces.size() - most_told);
    const std::string events = words_of_events(scene.run, gas);
    return events.empty() ? all : all + " " + events;
}

}  // namespace carom
