#include "panels/meters/history.h"

#include <algorithm>
#include <cmath>

#include "util/text.h"

namespace carom {

void History::add(double moment, const std::vector<double>& readings, bool is_sample,
                  bool is_frame) {
    if (is_sample) Measured::add(moment, readings);
    if (is_frame) frames.add(moment, readings);
}

std::size_t History::samples_until(std::size_t shown_frames) const {
    if (shown_frames == 0 || frames.x.empty()) return 0;
    const double now = frames.x[std::min(shown_frames, frames.x.size()) - 1];
    return static_cast<std::size_t>(std::ranges::upper_bound(x, now) - x.begin());
}

Measured History::until(std::size_t shown_frames) const {
    const std::size_t samples = samples_until(shown_frames);
    const auto first_of = [&](const std::vector<double>& all) {
        return std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(samples));
    };
    Measured now{.x = first_of(x)};
    for (const std::vector<double>& line : y) now.y.push_back(first_of(line));
    for (const std::vector<double>& line : error) now.error.push_back(first_of(line));
    if (shown_frames == 0 || frames.x.empty()) return now;
    const std::size_t frame = std::min(shown_frames, frames.x.size()) - 1;
    if (samples > 0 && !(frames.x[frame] > x[samples - 1])) return now;
    now.x.push_back(frames.x[frame]);
    for (std::size_t line = 0; line < now.y.size(); ++line)
        now.y[line].push_back(frames.y[line][frame]);
    for (std::size_t line = 0; line < now.error.size(); ++line)
        now.error[line].push_back(frames.error[line][frame]);
    return now;
}

ReferenceLevels HistoryRecord::common_levels() const {
    const ReferenceLevels& first = runs.front().levels;
    const auto look_alike = [](const ReferenceLevel& a, const ReferenceLevel& b) {
        return a.name == b.name && a.line == b.line &&
               three_digits(a.value) == three_digits(b.value);
    };
    for (const History& run : runs)
        if (!std::ranges::equal(run.levels, first, look_alike)) return {};
    return first;
}

std::vector<std::pair<double, std::vector<std::string>>> HistoryRecord::common_events() const {
    std::vector<std::pair<double, std::vector<std::string>>> events;
    for (const History& run : runs)
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

std::vector<double> HistoryRecord::common_turns() const {
    for (const History& run : runs)
        if (run.turns != runs.front().turns) return {};
    return runs.front().turns;
}

HistoryRecord mean_of(std::vector<HistoryRecord> records) {
    HistoryRecord mean = begun_mean(records);
    History& run = mean.runs.front();
    run.laws.clear();
    std::vector<const Measured*> samples, frames;
    for (const HistoryRecord& record : records) {
        samples.push_back(&record.runs.front());
        frames.push_back(&record.runs.front().frames);
    }
    static_cast<Measured&>(run) = mean_of(samples);
    run.frames = mean_of(frames);
    const std::size_t levels = run.levels.size();
    std::erase_if(
        records, [&](const HistoryRecord& one) { return one.runs.front().levels.size() < levels; });
    for (std::size_t k = 0; k < levels; ++k) {
        const auto of_level = [&](double ReferenceLevel::*number) {
            std::vector<double> values;
            for (const HistoryRecord& record : records)
                values.push_back(record.runs.front().levels[k].*number);
            return mean_error(values).mean;
        };
        run.levels[k].value = of_level(&ReferenceLevel::value);
        run.levels[k].deviation =
            of_level(&ReferenceLevel::deviation) / std::sqrt(double(mean.runs_in_mean));
    }
    return mean;
}

HistoryRecord compare(std::vector<HistoryRecord> records, const std::vector<std::string>& names) {
    HistoryRecord all = compare<HistoryRecord>(std::move(records), names);
    if (!all.compared) return all;
    const std::size_t kept = *all.compared;
    const auto keep = [kept](auto& of_lines) {
        if (!of_lines.empty()) of_lines = {std::move(of_lines[kept])};
    };
    for (History& run : all.runs) {
        keep(run.y);
        keep(run.frames.y);
        keep(run.numbers);
        keep(run.laws);
        std::erase_if(run.levels, [kept](const ReferenceLevel& level) {
            return level.line.value_or(kept) != kept;
        });
        for (ReferenceLevel& level : run.levels) level.line.reset();
    }
    return all;
}

}  // namespace carom
