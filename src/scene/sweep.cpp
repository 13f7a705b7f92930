#include "scene/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "scene/limits.h"

namespace carom {
namespace {

template <class Number>
std::optional<Number> number_from(const std::string& text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

// Splits a text at separators outside brackets, braces and quotes.
std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    int depth = 0;
    char quote = 0;
    for (const char c : text) {
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '[' || c == '{') {
            ++depth;
        } else if (c == ']' || c == '}') {
            --depth;
        }
        if (c == separator && depth == 0 && quote == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

struct Spacing {
    double first, last;
    std::int64_t count;
};

// Returns nothing if the text does not have the form FIRST:LAST:N.
std::optional<Spacing> spacing_from(const std::string& text) {
    const std::vector<std::string> parts = parts_of(text, ':');
    if (parts.size() != 3) return std::nullopt;
    const auto first = number_from<double>(trimmed(parts[0]));
    const auto last = number_from<double>(trimmed(parts[1]));
    const auto count = number_from<std::int64_t>(trimmed(parts[2]));
    if (!first || !last || !count || !std::isfinite(*first) || !std::isfinite(*last))
        return std::nullopt;
    return Spacing{*first, *last, *count};
}

// The value is the text that is written: 0.15 and not 0.15000000000000002.
std::vector<std::string> values_at(const Spacing& spacing, const std::string& text) {
    if (spacing.count < 2 || spacing.count > static_cast<std::int64_t>(most_points.count()))
        throw SweepError(fmt::format("{}: expected from 2 to {} values, found {}", text,
                                     number_text(most_points.value), spacing.count));
    std::vector<std::string> values;
    for (std::int64_t k = 0; k < spacing.count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(spacing.count - 1);
        values.push_back(
            fmt::format("{:.15g}", spacing.first * (1.0 - share) + spacing.last * share));
    }
    return values;
}

// Refuses FIRST:LAST without a valid number of values.
void refuse_colons(const std::string& values, const std::string& axis) {
    const std::vector<std::string> parts = parts_of(values, ':');
    if (parts.size() > 1 && number_from<double>(trimmed(parts[0])) &&
        number_from<double>(trimmed(parts[1])))
        throw SweepError(fmt::format("{}: expected FIRST:LAST:N, found {}", axis, values),
                         "for instance 0.1:0.4:7, which are 7 values");
}

std::vector<std::string> listed_values(const std::string& text, const std::string& axis) {
    std::vector<std::string> values;
    for (const std::string& part : parts_of(text, ',')) {
        values.push_back(trimmed(part));
        if (values.back().empty())
            throw SweepError(fmt::format("{}: a value is empty", axis),
                             "expected KEY=FIRST:LAST:N or KEY=VALUE,VALUE,...");
    }
    return values;
}

void refuse_equal_values(const SweepAxis& axis) {
    std::set<std::string> seen;  // numbers as the shortest text that gives them
    for (const std::string& value : axis.values)
        if (const auto number = number_from<double>(value);
            !seen.insert(number ? fmt::format("{}", *number) : value).second)
            throw SweepError(fmt::format("{}: the value {} is there twice", axis.key, value),
                             "the runs of both would be the same");
}

}  // namespace

std::int64_t Sweep::points() const {
    std::int64_t count = 1;
    for (const SweepAxis& axis : axes) count *= static_cast<std::int64_t>(axis.values.size());
    return count;
}

std::vector<std::string> Sweep::values_at(std::int64_t point) const {
    std::vector<std::string> values(axes.size());
    for (std::size_t k = axes.size(); k-- > 0;) {
        const auto count = static_cast<std::int64_t>(axes[k].values.size());
        values[k] = axes[k].values[static_cast<std::size_t>(point % count)];
        point /= count;
    }
    return values;
}

std::vector<std::string> Sweep::changes_at(std::int64_t point) const {
    std::vector<std::string> changes = values_at(point);
    for (std::size_t k = 0; k < axes.size(); ++k) changes[k] = axes[k].key + "=" + changes[k];
    return changes;
}

SeedRange seed_range(const std::string& text) {
    const std::vector<std::string> parts = parts_of(text, ':');
    const auto first = number_from<std::uint64_t>(parts.size() == 1 ? "1" : trimmed(parts[0]));
    const auto last = number_from<std::uint64_t>(trimmed(parts.back()));
    if (parts.size() > 2 || !first || !last || *first > *last ||
        *last > static_cast<std::uint64_t>(largest_seed.value))
        throw SweepError(fmt::format("expected FIRST:LAST or a number of seeds, found {}", text),
                         "for instance 1:100");
    return {*first, *last};
}

SweepAxis sweep_axis(const std::string& text) {
    const std::size_t sign = text.find('=');
    if (sign == 0 || sign == std::string::npos)
        throw SweepError(
            fmt::format("expected KEY=FIRST:LAST:N or KEY=VALUE,VALUE,..., found {}", text),
            "for instance gas.0.radius=0.1:0.4:7");
    const std::string values = text.substr(sign + 1);
    const auto spacing = spacing_from(values);
    if (!spacing) refuse_colons(values, text);
    SweepAxis axis{trimmed(text.substr(0, sign)),
                   spacing ? values_at(*spacing, text) : listed_values(values, text)};
    refuse_equal_values(axis);
    return axis;
}

void check_sweep(const Sweep& sweep) {
    if (sweep.seeds.first > sweep.seeds.last) throw SweepError("the last seed is before the first");
    if (sweep.seeds.last > static_cast<std::uint64_t>(largest_seed.value))
        throw SweepError(fmt::format("the last seed is {}", sweep.seeds.last),
                         to_text(largest_seed));
    std::set<std::string> keys;
    for (const SweepAxis& axis : sweep.axes) {
        if (axis.key == "seed") throw SweepError("`seed` cannot be varied", "use `seeds` instead");
        if (axis.values.empty()) throw SweepError(fmt::format("{} has no values", axis.key));
        if (!keys.insert(axis.key).second)
            throw SweepError(fmt::format("{} is varied twice", axis.key));
        for (const std::string& other : keys)
            if (axis.key.starts_with(other + ".") || other.starts_with(axis.key + "."))
                throw SweepError(fmt::format(
                    "{} and {} are varied, one of which is part of the other", other, axis.key));
    }
    double points = 1.0;
    for (const SweepAxis& axis : sweep.axes) points *= static_cast<double>(axis.values.size());
    const double runs = points * static_cast<double>(sweep.seeds.count());
    for (const auto& [count, limit] : {std::pair{points, most_points}, std::pair{runs, most_runs}})
        if (count > limit.value)
            throw SweepError(fmt::format("the sweep has {}", number_text(count)), to_text(limit));
}

}  // namespace carom
