#include <fmt/format.h>

#include "scene/reading/film_reading.h"
#include "scene/time/event_words.h"
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

std::string box_words(const Box& box) {
    if (box.dimension == 1)
        return box.is_periodic(0)
                   ? fmt::format("on a wire of length {} whose ends are joined", box.size[0])
                   : fmt::format("on a wire of length {} between two walls", box.size[0]);
    const bool across = box.is_periodic(0);
    const bool up = box.is_periodic(1);
    const std::string size = fmt::format("box of {} by {}", box.size[0], box.size[1]);
    if (across && up) return "in a periodic " + size;
    if (across) return fmt::format("in a {} with solid walls below and above,", size);
    if (up) return fmt::format("in a {} with solid walls on the left and right,", size);
    return fmt::format("in a {} with solid walls", size);
}

std::string passage_words(const Box& box) {
    if (box.dimension == 1)
        return box.is_periodic(0)
                   ? " What leaves at the right end enters at the left, and the other way round."
                   : "";
    const bool across = box.is_periodic(0);
    const bool up = box.is_periodic(1);
    if (across && up) return " What leaves on one side enters on the opposite side.";
    if (across) return " What leaves on the left enters on the right, and the other way round.";
    if (up) return " What leaves at the top enters at the bottom, and the other way round.";
    return "";
}

}  // namespace

std::string describe(const Scene& scene) {
    const Gas& gas = scene.gas;
    std::vector<std::string> groups;
    for (const Species& species : gas.species)
        groups.push_back(species_words(species, gas.box.dimension, gas.species.size() > 1));
    const bool alone = gas.species.size() == 1 && gas.species[0].count == 1;
    std::string text =
        fmt::format("{} {} {} and {} elastically.", listed(groups), alone ? "starts" : "start",
                    box_words(gas.box), alone ? "collides" : "collide");
    text += passage_words(gas.box);
    const std::string events = words_of_events(scene.run);
    return events.empty() ? text : text + " " + events;
}

}  // namespace carom
