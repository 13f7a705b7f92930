#include "panels/plots/series_record.h"

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom {

ReferenceLevels SeriesRecord::common_levels() const {
    const ReferenceLevels& first = runs.front().levels;
    const auto look_alike = [](const ReferenceLevel& a, const ReferenceLevel& b) {
        return a.name == b.name && a.line == b.line &&
               three_digits(a.value) == three_digits(b.value);
    };
    for (const SeriesRun& run : runs)
        if (!std::ranges::equal(run.levels, first, look_alike)) return {};
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
    SeriesRecord mean = begun_mean(records);
    SeriesRun& run = mean.runs.front();
    run.laws.clear();
    const auto over_runs = [&](const auto& number) {
        std::vector<double> values;
        for (const SeriesRecord& record : records) values.push_back(number(record.runs.front()));
        return mean_error(values);
    };
    const auto average = [&](SeriesPoints& points, const auto& of_run) {
        take_means(
            records,
            [&](const SeriesRecord& record) -> const NumberRows& {
                return of_run(record.runs.front()).lines;
            },
            points.lines, points.errors);
    };
    average(run, [](const SeriesRun& of) -> const SeriesPoints& { return of; });
    average(run.frames, [](const SeriesRun& of) -> const SeriesPoints& { return of.frames; });
    for (std::size_t k = 0; k < run.numbers.size(); ++k)
        for (std::size_t i = 0; i < run.numbers[k].size(); ++i)
            run.numbers[k][i] =
                over_runs([&](const SeriesRun& of) { return of.numbers[k][i].mean; });
    const std::size_t levels = run.levels.size();
    std::erase_if(records,
                  [&](const SeriesRecord& one) { return one.runs.front().levels.size() < levels; });
    for (std::size_t k = 0; k < levels; ++k) {
        const auto of_level = [&](double ReferenceLevel::*number) {
            return over_runs([&](const SeriesRun& of) { return of.levels[k].*number; }).mean;
        };
        run.levels[k].value = of_level(&ReferenceLevel::value);
        run.levels[k].deviation =
            of_level(&ReferenceLevel::deviation) / std::sqrt(double(mean.runs_in_mean));
    }
    return mean;
}

SeriesRecord compare(std::vector<SeriesRecord> records, const std::vector<std::string>& names) {
    SeriesRecord all = compare<SeriesRecord>(std::move(records), names);
    for (SeriesRun& run : all.runs) {
        for (SeriesPoints* points : {static_cast<SeriesPoints*>(&run), &run.frames})
            if (!points->lines.empty()) points->lines = {std::move(points->lines[all.compared])};
        if (!run.numbers.empty()) run.numbers = {std::move(run.numbers[all.compared])};
        if (!run.laws.empty()) run.laws = {std::move(run.laws[all.compared])};
        std::erase_if(run.levels, [&](const ReferenceLevel& level) {
            return level.line.value_or(all.compared) != all.compared;
        });
        for (ReferenceLevel& level : run.levels) level.line.reset();
    }
    return all;
}

}  // namespace carom
