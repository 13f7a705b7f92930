#include <fmt/format.h>

#include "scene/film_reading.h"

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

std::string species_words(const Species& species, bool several) {
    const char* noun = species.count == 1 ? "disk" : "disks";
    return several
               ? fmt::format("{} {} ({}, {})", species.count, noun, species.name, start_of(species))
               : fmt::format("{} {}, {},", species.count, noun, start_of(species));
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
        text += words[i];
    }
    return text;
}

std::string walls_words(const Box& box) {
    const bool across = box.walls[0] == Wall::periodic;
    const bool up = box.walls[1] == Wall::periodic;
    if (across && up) return "that has no walls: what leaves on one side enters on the other";
    if (across) return "with walls below and above, open to itself on the left and right";
    if (up) return "with walls on the left and right, open to itself below and above";
    return "with solid walls";
}

}  // namespace

std::string describe(const Scene& scene) {
    const Gas& gas = scene.gas;
    std::vector<std::string> groups;
    for (const Species& species : gas.species)
        groups.push_back(species_words(species, gas.species.size() > 1));
    std::string text =
        fmt::format("{} start in a box of {} by {} {} and collide elastically.", listed(groups),
                    gas.box.size[0], gas.box.size[1], walls_words(gas.box));
    std::vector<std::string> times;
    for (const RunEvent& event : scene.run.events)
        if (std::holds_alternative<ReverseVelocities>(event.action))
            times.push_back(fmt::format("{}", event.at));
    if (!times.empty())
        text += fmt::format(" At time {} every velocity is turned round.", listed(times));
    return text;
}

}  // namespace carom
