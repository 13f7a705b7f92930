#include "scene/time/event_words.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "scene/yaml/scalar.h"
#include "util/text.h"

namespace carom {

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

}  // namespace carom
