#include "panels/plots/series_record.h"

#include <algorithm>

#include "util/text.h"

namespace carom {

std::optional<ReferenceLevel> SeriesRecord::common_level() const {
    const std::optional<ReferenceLevel>& first = runs.front().level;
    for (const SeriesRun& run : runs)
        if (!run.level || three_digits(run.level->value) != three_digits(first->value)) return {};
    return first;
}

std::vector<std::pair<double, std::vector<std::string>>> SeriesRecord::common_events() const {
    std::vector<std::pair<double, std::vector<std::string>>> events;
    for (const SeriesRun& run : runs)
        if (run.events != runs.front().events) return {};
    for (const auto& [at, word] : runs.front().events) {
        const auto known = std::ranges::find_if(
            events, [at = at](const auto& event) { return event.first == at; });
        if (known == events.end())
            events.emplace_back(at, std::vector{word});
        else if (std::ranges::find(known->second, word) == known->second.end())
            known->second.push_back(word);
    }
    std::ranges::sort(events);
    return events;
}

std::vector<double> SeriesRecord::common_turns() const {
    for (const SeriesRun& run : runs)
        if (run.turns != runs.front().turns) return {};
    return runs.front().turns;
}

SeriesRecord mean_of(std::vector<SeriesRecord> records) {
    SeriesRecord mean = records.front();
    mean.runs_in_mean = static_cast<int>(records.size());
    SeriesRun& run = mean.runs.front();
    run.errors = run.lines;
    const auto over_runs = [&](const auto& number) {
        std::vector<double> values;
        for (const SeriesRecord& record : records) values.push_back(number(record.runs.front()));
        return mean_error(values);
    };
    for (std::size_t k = 0; k < run.lines.size(); ++k)
        for (std::size_t i = 0; i < run.time.size(); ++i) {
            const MeanError one = over_runs([&](const SeriesRun& of) { return of.lines[k][i]; });
            run.lines[k][i] = one.mean;
            run.errors[k][i] = one.error;
        }
    for (std::size_t k = 0; k < run.numbers.size(); ++k)
        for (std::size_t i = 0; i < run.numbers[k].size(); ++i)
            run.numbers[k][i] =
                over_runs([&](const SeriesRun& of) { return of.numbers[k][i].mean; });
    if (!run.level) return mean;
    std::erase_if(records, [](const SeriesRecord& one) { return !one.runs.front().level; });
    run.level->value = over_runs([](const SeriesRun& of) { return of.level->value; }).mean;
    return mean;
}

SeriesRecord compare(std::vector<SeriesRecord> records, const std::vector<std::string>& names) {
    SeriesRecord all{.runs = {}, .compared = records.front().compared};
    for (std::size_t k = 0; k < records.size(); ++k) {
        SeriesRun& run = all.runs.emplace_back(std::move(records[k].runs.front()));
        run.lines = {std::move(run.lines[all.compared])};
        if (!run.numbers.empty()) run.numbers = {std::move(run.numbers[all.compared])};
        run.name = names[k];
    }
    return all;
}

}  // namespace carom
