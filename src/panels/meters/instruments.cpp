#include "panels/meters/instruments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/registry.h"
#include "scene/panel_kind.h"

namespace carom {
namespace {

bool is_measured(const MeterLine& line) { return !line.is_theory; }

}  // namespace

Instruments::Instruments(const PanelContext& context, std::span<const PanelSpec> specs) {
    for (const PanelSpec& spec : specs)
        instruments_.push_back({&spec, MeterReader(kind_of(spec).meter(context, spec))});
}

bool Instruments::need_collisions() const {
    return std::ranges::any_of(instruments_,
                               [](const auto& one) { return one.reader.meter().needs_collisions; });
}

void Instruments::see(const FrameInput& input) {
    for (Instrument& instrument : instruments_) instrument.last = instrument.reader(input);
}

std::vector<std::vector<RunNumber>> Instruments::numbers() const {
    std::vector<std::vector<RunNumber>> all;
    for (const Instrument& instrument : instruments_) all.push_back(numbers_of(instrument));
    return all;
}

std::vector<LastReading> Instruments::readings() const {
    std::vector<LastReading> all;
    for (const Instrument& instrument : instruments_) {
        const std::vector<MeanError> values = values_of(instrument);
        std::size_t k = 0;
        for (RunNumber& number : numbers_of(instrument)) {
            const MeanError& value = values.at(k++);
            all.push_back({std::move(number), value.mean, value.error});
        }
    }
    return all;
}

double Instruments::value(std::size_t instrument, const std::string& column, bool is_result) const {
    const Meter& meter = instruments_.at(instrument).reader.meter();
    const std::vector<double>& last = instruments_[instrument].last;
    std::vector<std::vector<MeanError>> results;
    if (is_result) results = meter.results.find();
    for (std::size_t line = 0; line < meter.lines.size(); ++line) {
        if (!is_measured(meter.lines[line])) continue;
        if (!column.empty() && meter.lines[line].column != column) continue;
        const double value = is_result ? (line < results.size() ? results[line].front().mean : NAN)
                                       : (line < last.size() ? last[line] : NAN);
        if (std::isfinite(value) || !column.empty()) return value;
    }
    return NAN;
}

const Quantity& Instruments::quantity(std::size_t instrument, bool is_result) const {
    const Meter& meter = instruments_.at(instrument).reader.meter();
    return is_result ? meter.results.of.front() : meter.quantity;
}

// "temperature at the end", "diffusion coefficient", or the title that the scene gives, with the
// name of the line if it needs one: "pressure at the end (on the walls)".
std::vector<RunNumber> Instruments::numbers_of(const Instrument& instrument) {
    const Meter& meter = instrument.reader.meter();
    const std::optional<std::string>& title = instrument.spec->title;
    const bool is_one = std::ranges::count_if(meter.lines, is_measured) == 1;
    const std::size_t of_each = (meter.read ? 1 : 0) + meter.results.of.size();
    const auto what = [&](const Quantity& quantity, const char* when) {
        const std::string word = std::string(quantity.word.english) + when;
        if (!title) return word;
        return of_each == 1 ? *title : *title + ": " + word;
    };
    std::vector<RunNumber> numbers;
    const auto add = [&](const Quantity& quantity, const char* when) {
        const std::string name = what(quantity, when);
        for (const MeterLine& line : meter.lines) {
            if (!is_measured(line)) continue;
            const bool is_enough = line.name.empty() || (title && is_one);
            numbers.push_back(
                {is_enough ? name : fmt::format("{} ({})", name, line.column), quantity});
        }
    };
    if (meter.read) add(meter.quantity, " at the end");
    for (const Quantity& quantity : meter.results.of) add(quantity, "");
    return numbers;
}

// In the order of numbers_of().
std::vector<MeanError> Instruments::values_of(const Instrument& instrument) {
    const Meter& meter = instrument.reader.meter();
    std::vector<MeanError> values;
    const auto add = [&](const auto& of_line) {
        for (std::size_t line = 0; line < meter.lines.size(); ++line)
            if (is_measured(meter.lines[line])) values.push_back(of_line(line));
    };
    if (meter.read)
        add([&](std::size_t line) {
            return MeanError{instrument.last.empty() ? NAN : instrument.last.at(line), NAN};
        });
    if (meter.results.of.empty()) return values;
    const std::vector<std::vector<MeanError>> found = meter.results.find();
    for (std::size_t k = 0; k < meter.results.of.size(); ++k)
        add([&](std::size_t line) {
            return line < found.size() ? found[line].at(k) : MeanError{NAN, NAN};
        });
    return values;
}

}  // namespace carom
