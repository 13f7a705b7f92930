#include "panels/plot/window.h"

#include <fmt/format.h>

#include <algorithm>

#include "util/text.h"

namespace carom {

std::optional<double> window_of(const Over& over) {
    if (over.since == Over::Since::start) return std::nullopt;
    return over.window;
}

std::optional<double> start_of_mean(const Over& over, double at) {
    if (over.since == Over::Since::start) return 0.0;
    if (over.since == Over::Since::now) return std::nullopt;
    return std::max(0.0, at - over.window);
}

std::string words_of_window(const Wording& language, const Over& over, Phrase alone) {
    if (over.since == Over::Since::start) return say(language, "mean since the start");
    if (over.since == Over::Since::now) return say(language, alone);
    return say(language, "mean over the last {}",
               plain_number(language, quantities::time, over.window));
}

std::string words_of_moments(const Wording& language, const PanelSpec& spec, const Over& over) {
    if (!spec.at) return words_of_window(language, over, Phrase{"now"});
    if (over.since == Over::Since::now)
        return spec.at_ends ? say(language, "at the end")
                            : say(language, "at time {}",
                                  plain_number(language, quantities::time, *spec.at));
    const bool is_whole = !spec.at_ends && start_of_mean(over, *spec.at) == 0.0;
    return words_of_window(language, is_whole ? Over{.since = Over::Since::start} : over,
                           Phrase{"now"});
}

std::string time_words(const Wording& language, const PanelSpec& spec) {
    const Over over = spec.over.value_or(Over{});
    const std::optional<double> back = window_of(over);
    const bool is_real = language.units == UnitSystem::real;
    const std::string length = !back     ? ""
                               : is_real ? plain_number(language, quantities::time, *back)
                                         : localised(language, fmt::format("{}", *back));
    if (!spec.at) {
        if (!back) return say(language, "so far");
        return *back > 0.0 ? say(language, "mean over the last {}", length) : say(language, "now");
    }
    if (spec.at_ends) {
        if (!back) return say(language, "until the end");
        return *back > 0.0 ? say(language, "mean over the last {}", length)
                           : say(language, "at the end");
    }
    const std::string at = plain_number(language, quantities::time, *spec.at);
    if (!back) return say(language, "until time {}", at);
    const auto start = start_of_mean(over, *spec.at);
    return *back > 0.0 ? say(language, "time {} to {}",
                             plain_number(language, quantities::time, *start), at)
                       : say(language, "at time {}", at);
}

}  // namespace carom
