#include "app/check/command_facts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "util/joined.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

std::string time_words(double seconds) { return seconds < 1.0 ? "0:01" : clock_text(seconds); }

// "run 0:02; figures 0:14; render 1:00".
Facts time_rows(const NamedWork& works) {
    Json values = Json::object();
    std::vector<std::string> words;
    for (const auto& [command, work] : works) {
        values[command] = {{"cpu_seconds", work.seconds()},
                           {"memory_bytes", std::round(work.memory)},
                           {"bytes", std::round(work.bytes)}};
        words.push_back(fmt::format("{} {}", command, time_words(work.seconds())));
    }
    return {{"work", std::move(values), "CPU time",
             fmt::format("{} (rough, on all cores together)", fmt::join(words, "; "))}};
}

// A part of a command's work that takes long. Pictures of films are estimated elsewhere.
std::vector<std::pair<std::string, const WorkPart*>> slow_parts(const NamedWork& works) {
    constexpr double long_time = 10.0;
    std::vector<std::pair<std::string, const WorkPart*>> slow;
    for (const auto& [command, work] : works)
        for (const WorkPart& part : work.parts)
            if (part.seconds >= long_time && !part.is_drawing) slow.emplace_back(command, &part);
    return slow;
}

// "figures: about 26 seconds of CPU time for the figure `flights` (line 12); to reduce it, change
// `lags` ...".
Facts slow_rows(const NamedWork& works) {
    std::vector<ListItem> parts;
    for (const auto& [command, part] : slow_parts(works)) {
        const int line = part->place.span.line;
        parts.push_back({fmt::format("{}: about {} seconds of CPU time for {}{}; to reduce it: {}",
                                     command, about(part->seconds), part->what,
                                     line > 0 ? fmt::format(" (line {})", line) : "", part->reduce),
                         Json{{"command", command},
                              {"part", part->what},
                              {"line", line > 0 ? Json(line) : Json()},
                              {"cpu_seconds", part->seconds},
                              {"reduce", part->reduce}}});
    }
    return rows_of("slow", "slow", std::move(parts));
}

// "render, still and plan: a film of 60000 seconds has ...; the limit is ...".
std::string words_of(const CommandsRefused& refused) {
    std::vector<std::string> reasons;
    for (const Diagnostic& one : refused.reasons)
        reasons.push_back(one.hint.empty() ? one.message : one.message + "; " + one.hint);
    return fmt::format("{}: {}", listed(refused.commands), fmt::join(reasons, "; "));
}

}  // namespace

Json error_value(const Diagnostic& error) {
    const auto position = [](int value) { return value > 0 ? Json(value) : Json(); };
    return Json{{"file", error.span.file},
                {"line", position(error.span.line)},
                {"column", position(error.span.column)},
                {"length", error.span.length},
                {"message", error.message},
                {"hint", error.hint.empty() ? Json() : Json(error.hint)}};
}

Facts work_rows(const NamedWork& works) {
    if (works.empty()) return {};
    return joined<Fact>({time_rows(works), slow_rows(works)});
}

Facts refused_rows(const std::vector<CommandsRefused>& all) {
    std::vector<ListItem> items;
    for (const CommandsRefused& one : all) {
        Json value{{"commands", one.commands}};
        for (const Diagnostic& reason : one.reasons) value["errors"].push_back(error_value(reason));
        items.push_back({words_of(one), std::move(value)});
    }
    return rows_of("refused", "refused", std::move(items));
}

}  // namespace carom
