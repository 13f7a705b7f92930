#include "scene/keys/notation.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/gas.h"
#include "scene/keys/binding.h"
#include "scene/keys/colors.h"
#include "scene/keys/numbers_in_words.h"
#include "scene/yaml/scalar.h"
#include "util/formula/formula.h"

namespace carom {
namespace {

const Source& default_source() {
    static const Source source{"default", "", Origin::preset};
    return source;
}

std::string without_space_at_end(const std::string& text) {
    return text.substr(0, text.find_last_not_of(" \t\n") + 1);
}

Notation<std::string> text_form(bool lines, std::size_t shortest, Limit most) {
    return {{{.shape = Shape::text, .lines = lines, .shortest = shortest, .most = most}},
            [](const Node& node, Reading&) -> std::optional<std::string> {
                if (!node.is_scalar()) return std::nullopt;
                return without_space_at_end(node.text);
            },
            [](const std::string& text) { return text; }};
}

// Returns the byte of the source that corresponds to a byte of a node's text; the beginning of the
// node if the source spells the text differently there.
std::size_t place_in_source(const Node& node, std::size_t at) {
    const std::string& text = node.text;
    const std::size_t from = text[std::min(at, text.size() - 1)] == '$' ? at : text.rfind('$', at);
    const std::size_t end = std::min(text.find_first_of("$\n", from + 1), text.size());
    const std::string formula = text.substr(from, end - from);
    const std::size_t found = node.source->text.find(formula, node.offset);
    const bool is_near = found - node.offset <= 2 * text.size() + 100;
    return found != std::string::npos && is_near && at <= end ? found + (at - from) : node.offset;
}

/// A distribution, as far as its keys are given.
struct Distribution {
    std::optional<ValueRule> value;
};

KeyTable<Distribution> distribution(Range range, const Quantity& quantity) {
    const auto ordered = [](const TwoNumbers& ends, const Node& list,
                            Reading& reading) -> std::optional<ValueRule> {
        if (ends[0] <= ends[1]) return UniformDistribution{ends[0], ends[1]};
        reading.errors.add(
            list,
            fmt::format("expected [low, high] for `uniform`, found {} above {}", ends[0], ends[1]),
            fmt::format("write `[{}, {}]`", ends[1], ends[0]));
        return std::nullopt;
    };
    const auto positive_mean = [range](const TwoNumbers& parameters, const Node& list,
                                       Reading& reading) -> std::optional<ValueRule> {
        if (parameters[0] >= range.low) return NormalDistribution{parameters[0], parameters[1]};
        reading.errors.add(list.items[0],
                           fmt::format("expected a positive mean for `normal`, found {}",
                                       in_quotes(list.items[0].text)),
                           "for instance `normal: [1, 0.1]`");
        return std::nullopt;
    };
    const Range spread{0.0, range.most};
    return {
        .name = "a distribution",
        .keys =
            {bind_key("uniform", &Distribution::value,
                      parsed(pair_of(number(range, quantity), "[low, high]"), ordered),
                      "A uniform distribution between two numbers.")
                 .tried_as({"range", "between", "flat", "random"}),
             bind_key(
                 "normal", &Distribution::value,
                 parsed(pair_of(number(spread, quantity), "[mean, deviation]"), positive_mean),
                 "A normal distribution with this mean and standard deviation. Of radii, masses "
                 "and densities, values below 0 are drawn again; speeds lose their "
                 "sign. Where this is more than 1 % of the values, `carom check` "
                 "gives the mean and the deviation that result.")
                 .tried_as({"gauss", "gaussian", "Gaussian"})},
        .choices = {{{"uniform", "normal"}, true}}};
}

}  // namespace

const Box& Reading::box() const { return gas.box; }

Held::Held(const void* what, void (*destroy)(const void*)) : what_(what, destroy) {}
Held::Held(const Held& other) = default;
Held& Held::operator=(const Held& other) = default;
Held::~Held() = default;

Notation<double> number(Range range, std::optional<Quantity> quantity) {
    return {{{.shape = Shape::number, .range = range, .quantity = quantity}},
            [](const Node& node, Reading&) { return number_in(node); },
            [](double value) { return number_text(value); }};
}

Notation<double> number_of_any_quantity(Range range) {
    Notation<double> notation = number(range);
    notation.forms.front().takes_any_quantity = true;
    return notation;
}

Notation<double> length(Range range, LengthUnit unit) {
    return {{{.shape = Shape::length, .range = range, .unit = unit}},
            [unit](const Node& node, Reading&) -> std::optional<double> {
                if (!node.is_scalar() || node.quoted) return std::nullopt;
                return parse_length(node.text, unit);
            }};
}

Notation<std::int64_t> whole(double low, Limit most) {
    return {{{.shape = Shape::integer, .range = {low, most}}},
            [](const Node& node, Reading&) -> std::optional<std::int64_t> {
                const auto value = number_in(node);
                if (!value) return std::nullopt;
                return static_cast<std::int64_t>(*value);
            },
            [](std::int64_t value) { return std::to_string(value); }};
}

Notation<bool> flag() {
    return {{{.shape = Shape::flag}},
            [](const Node& node, Reading&) { return flag_in(node); },
            [](bool value) { return std::string(value ? "true" : "false"); }};
}

Notation<std::string> color() {
    return {{{.shape = Shape::color}},
            [](const Node& node, Reading&) { return std::optional(color_hex(node.text)); }};
}

Notation<std::string> text(std::size_t shortest, Limit most) {
    return text_form(false, shortest, most);
}

Notation<std::string> lines(std::size_t shortest, Limit most) {
    return text_form(true, shortest, most);
}

Notation<std::string> with_formulas(Notation<std::string> text) {
    text.forms.front().formulas = true;
    const auto write = text.write;
    Notation<std::string> all = parsed(
        std::move(text),
        [](std::string words, const Node& node, Reading& reading) -> std::optional<std::string> {
            try {
                formula::check(words);
            } catch (const formula::Error& error) {
                reading.errors.add(*node.source, place_in_source(node, error.at), error.what(),
                                   error.hint);
                return words;
            }
            const std::size_t before = reading.numbers.size();
            std::string marked = with_marks(words, node, reading.numbers, reading.errors);
            for (std::size_t k = before; k < reading.numbers.size(); ++k)
                if (reading.numbers[k].at && reading.units == UnitSystem::real)
                    reading.errors.add(
                        node,
                        fmt::format("the time of `{{{}}}` has no unit", reading.numbers[k].name),
                        "in real units words ask for numbers of the time at which they appear: "
                        "leave the time out");
            return marked;
        });
    all.write = write;
    return all;
}

Notation<std::string> word(const std::vector<std::string>& words) {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string& one : words) pairs.emplace_back(one, one);
    return one_of(std::move(pairs));
}

Notation<TwoNumbers> pair_of(Notation<double> each, std::string phrase) {
    return mapped(list_of(std::move(each), 2, {2}, std::move(phrase)),
                  [](const std::vector<double>& values) {
                      return TwoNumbers{values.at(0), values.at(1)};
                  });
}

Notation<Vec> vector_of(int dimension, Range range, const Quantity& quantity, std::string phrase) {
    const Notation<double> along_axis = number(range, quantity);
    if (dimension == 1) return mapped(along_axis, [](double x) { return Vec(x, 0.0); });
    if (phrase.empty()) phrase = dimension == 2 ? "[x, y]" : "[x, y, z]";
    const auto axes = static_cast<std::size_t>(dimension);
    return mapped(list_of(along_axis, axes, {static_cast<double>(dimension)}, std::move(phrase)),
                  [](const std::vector<double>& along) {
                      return Vec(along.at(0), along.at(1), along.size() == 3 ? along[2] : 0.0);
                  });
}

const char* particles_of(int dimension) {
    return dimension == 1 ? "beads" : dimension == 2 ? "disks" : "spheres";
}

const char* corners(int dimension) {
    return dimension == 1   ? "[x0, x1]"
           : dimension == 2 ? "[x0, y0, x1, y1]"
                            : "[x0, y0, z0, x1, y1, z1]";
}

std::optional<Region> region_of(int dimension, const std::vector<double>& ends) {
    Region region;
    for (int axis = 0; axis < dimension; ++axis) {
        region.low[axis] = ends.at(static_cast<std::size_t>(axis));
        region.high[axis] = ends.at(static_cast<std::size_t>(dimension + axis));
        if (!(region.low[axis] < region.high[axis])) return std::nullopt;
    }
    return region;
}

std::string order_of_corners(int dimension) {
    return dimension == 1   ? "x0 < x1"
           : dimension == 2 ? "x0 < x1 and y0 < y1"
                            : "x0 < x1, y0 < y1 and z0 < z1";
}

Notation<Region> corners_of(int dimension, std::string key, std::string first) {
    const Limit count{2.0 * dimension};
    return parsed(
        list_of(number(any_number, quantities::length), count.count(), count, corners(dimension)),
        [=](const std::vector<double>& ends, const Node& node, Reading& reading) {
            const std::optional<Region> region = region_of(dimension, ends);
            if (!region)
                reading.errors.add(node,
                                   fmt::format("expected {} with {} for `{}`", corners(dimension),
                                               order_of_corners(dimension), key),
                                   first);
            return region;
        });
}

Notation<std::vector<Vec>> points(int dimension, const Quantity& quantity) {
    const Notation<Vec> one = vector_of(dimension, any_number, quantity);
    if (dimension == 1) return one_or_list(one, most_particles, "a list of numbers");
    const auto several = list_of(one, 1, most_particles, "a list of " + one.forms.front().phrase);
    return {{one.forms.front(), several.forms.front()},
            [one, several](const Node& node, Reading& reading) -> std::optional<std::vector<Vec>> {
                if (lists_points(node, 2)) return several.read(node, reading);
                if (!node.is_list()) return std::nullopt;
                return std::vector{one.read(node, reading).value()};
            }};
}

bool lists_points(const Node& node, int dimension) {
    return node.is_list() && (dimension == 1 || node.items.front().is_list());
}

Notation<ValueRule> rule_for(Range range, const Quantity& quantity) {
    const Notation<ValueRule> drawn =
        parsed(mapping(distribution(range, quantity),
                       "{uniform: [low, high]} or {normal: [mean, deviation]}"),
               [](const Distribution& one, const Node&, Reading&) { return one.value; });
    const auto each = list_of(number(range, quantity), 1, most_particles, "a list of numbers");
    return either(as<ValueRule>(number(range, quantity)), either(as<ValueRule>(each), drawn));
}

const Node* given(const Node& mapping, std::string_view key) {
    const Node* node = find(mapping, key);
    return node != nullptr && node->valid && node->kind != Node::Kind::null ? node : nullptr;
}

Node default_node(const std::string& written) {
    return {.kind = Node::Kind::scalar, .source = &default_source(), .text = written};
}

}  // namespace carom
