#include "scene/describe.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

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
        return fmt::format("at temperature {}", temperature->value);
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
    if (box.dimension == 1) {
        const std::string wire = fmt::format("on a wire of length {}", box.size[0]);
        if (!across) return {wire + " between two walls", ""};
        return {wire + " whose ends are joined",
                " What leaves at the right end enters at the left, and the other way round."};
    }
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

}  // namespace

std::string words_of(const Perturbation& nudge) {
    const auto length = [&](std::size_t axis) {
        return parse_number(nudge.by[axis]).value_or(0.0);
    };
    return fmt::format("Particle {} is moved by {}", nudge.particle,
                       three_digits(std::hypot(length(0), length(1))));
}

std::string words_of_events(const Run& run) {
    constexpr std::size_t most_told = 3;
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
    const std::string events = words_of_events(scene.run);
    return events.empty() ? text : text + " " + events;
}

}  // namespace carom
