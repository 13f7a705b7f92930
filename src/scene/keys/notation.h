// How values are written in a scene. A notation defines this in one place: the forms that a value
// may take (for messages, schema and reference), how a checked node is converted to the value, and
// how a value is written again (for defaults). Larger notations are composed of smaller ones.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "physics/run.h"
#include "physics/value_rule.h"
#include "physics/vec.h"
#include "scene/keys/keys.h"
#include "scene/keys/numbers_in_words.h"
#include "scene/words.h"
#include "scene/yaml/node.h"

namespace carom {

struct Box;
struct Gas;
struct Region;

/// What reading a value may use besides its node: where errors are reported, and the gas and the
/// run as far as they have been read.
struct Reading {
    Errors& errors;
    const Gas& gas;
    const Run& run;
    std::vector<NumberInWords>& numbers;     ///< for which words ask, as far as they have been read
    UnitSystem units = UnitSystem::reduced;  ///< of the scene

    const Box& box() const;  ///< of the gas
};

/// A reference-counted object of erased type. None of its functions is inline, which makes the
/// compiled code of notations a third smaller.
class Held {
  public:
    Held(const void* what, void (*destroy)(const void*));
    Held(const Held& other);
    Held& operator=(const Held& other);
    ~Held();
    const void* get() const { return what_.get(); }

  private:
    std::shared_ptr<const void> what_;
};

/// A function object whose copies share their state, because notations are composed of many. It
/// generates little code for each function, of which there are hundreds.
template <typename Signature>
class SharedFunction;
template <typename Result, typename... Arguments>
class SharedFunction<Result(Arguments...)> {
  public:
    template <typename F>
    requires(!std::same_as<F, SharedFunction>) SharedFunction(F function)
        : held_(new F(std::move(function)),
                [](const void* held) { delete static_cast<const F*>(held); }),
          call_([](const void* held, Arguments... arguments) -> Result {
              return (*static_cast<const F*>(held))(std::forward<Arguments>(arguments)...);
          }) {}

    Result operator()(Arguments... arguments) const {
        return call_(held_.get(), std::forward<Arguments>(arguments)...);
    }

  private:
    Held held_;
    Result (*call_)(const void*, Arguments...);
};

/// How a value of type V is written.
template <typename V>
struct Notation {
    std::vector<Form> forms;

    /// Returns the value of a node that has one of the forms; nothing if it has none of them, or if
    /// the value is wrong in itself, which is reported.
    SharedFunction<std::optional<V>(const Node&, Reading&)> read;

    /// Returns a value as a scene would write it; empty if that would not be a single word or
    /// number.
    SharedFunction<std::string(const V&)> write = [](const V&) { return std::string{}; };

    /// Returns this notation with a hint for lists: of its first form, for lists of another length
    /// and mappings, or where it is no list, for any.
    Notation with_list_hint(std::string hint) const {
        Notation notation = *this;
        notation.forms.front().list_hint = std::move(hint);
        return notation;
    }

    /// Returns this notation with words that its first form does not take, and their hints.
    Notation with_elsewhere(std::vector<Elsewhere> words) const {
        Notation notation = *this;
        notation.forms.front().elsewhere = std::move(words);
        return notation;
    }

    /// Returns this notation with a phrase by which messages call its first form.
    Notation called(std::string phrase) const {
        Notation notation = *this;
        notation.forms.front().phrase = std::move(phrase);
        return notation;
    }
};

/// A number; `quantity` is what it measures, in real units with a unit. None: a plain number.
Notation<double> number(Range range, std::optional<Quantity> quantity = {});

/// A number in a plot: of the quantity of its axis, which depends on the plot.
Notation<double> number_of_any_quantity(Range range);

/// A length with its unit, given in `unit`.
Notation<double> length(Range range, LengthUnit unit);

/// A whole number from `low` up to the limit.
Notation<std::int64_t> whole(double low, Limit most);

Notation<bool> flag();

/// A colour as #rrggbb.
Notation<std::string> color();

/// One line of at least `shortest` characters, without spaces at its end.
Notation<std::string> text(std::size_t shortest, Limit most);

/// A text of at least `shortest` characters that may have line breaks.
Notation<std::string> lines(std::size_t shortest, Limit most);

/// A text notation in which spans between `$` signs are formulae (util/formula/).
Notation<std::string> with_formulas(Notation<std::string> text);

/// Words, each of which stands for a value.
template <typename V>
Notation<V> one_of(std::vector<std::pair<std::string, V>> words) {
    Form form{.shape = Shape::word};
    for (const auto& [word, value] : words) form.words.push_back(word);
    const auto read = [words](const Node& node, Reading&) -> std::optional<V> {
        for (const auto& [word, value] : words)
            if (node.is_scalar() && node.text == word) return value;
        return std::nullopt;
    };
    if constexpr (std::equality_comparable<V>) {
        return {{std::move(form)}, read, [words](const V& value) {
                    for (const auto& [word, its] : words)
                        if (its == value) return word;
                    return std::string{};
                }};
    } else {
        return {{std::move(form)}, read};
    }
}

/// The words of an enum.
template <typename E>
Notation<E> one_of() {
    std::vector<std::pair<std::string, E>> words;
    for (const EnumWord<E>& entry : enum_words<E>) words.emplace_back(entry.word, entry.value);
    return one_of<E>(std::move(words));
}

/// Words that stand for themselves.
Notation<std::string> word(const std::vector<std::string>& words);

/// A notation whose value is converted to another by `convert(value)`.
template <typename V, typename Convert>
auto mapped(Notation<V> from, Convert convert) {
    using W = std::invoke_result_t<Convert, V>;
    return Notation<W>{
        from.forms,
        [read = from.read, convert](const Node& node, Reading& reading) -> std::optional<W> {
            auto value = read(node, reading);
            if (!value) return std::nullopt;
            return std::optional<W>(std::in_place, convert(std::move(*value)));
        }};
}

/// A notation whose value is converted to another type constructed from it: a variant that has it
/// as an alternative, a struct that has it as its only member, or a base class.
template <typename W, typename V>
Notation<W> as(Notation<V> notation) {
    Notation<W> other = mapped(notation, [](V value) { return W{std::move(value)}; });
    if constexpr (requires(const W& whole) { std::get_if<V>(&whole); })
        other.write = [write = notation.write](const W& whole) {
            const V* its = std::get_if<V>(&whole);
            return its != nullptr ? write(*its) : std::string{};
        };
    return other;
}

/// A notation whose value is converted by `parse(value, node, reading)`, which returns an optional:
/// nothing after it has reported an error.
template <typename V, typename Parse>
auto parsed(Notation<V> from, Parse parse) {
    using Result = std::invoke_result_t<Parse, V, const Node&, Reading&>;
    return Notation<typename Result::value_type>{
        from.forms, [read = from.read, parse](const Node& node, Reading& reading) -> Result {
            auto value = read(node, reading);
            if (!value) return std::nullopt;
            return parse(std::move(*value), node, reading);
        }};
}

/// A notation with the same value, on which `check(value, node, reading)` is called to report
/// errors.
template <typename V, typename Check>
Notation<V> checked(Notation<V> notation, Check check) {
    const auto read = notation.read;
    notation.read = [read, check](const Node& node, Reading& reading) {
        auto value = read(node, reading);
        if (value) check(*value, node, reading);
        return value;
    };
    return notation;
}

/// Either of two notations; the form of the node decides which.
template <typename V>
Notation<V> either(Notation<V> first, Notation<V> second) {
    std::vector<Form> forms = first.forms;
    forms.insert(forms.end(), second.forms.begin(), second.forms.end());
    return {std::move(forms),
            [first = first.read, second = second.read](const Node& node, Reading& reading) {
                auto value = first(node, reading);
                return value ? value : second(node, reading);
            },
            [first = first.write, second = second.write](const V& value) {
                const std::string written = first(value);
                return written.empty() ? second(value) : written;
            }};
}

/// A list of at least `shortest` and at most `most` items; `phrase` is what messages call it. Items
/// with errors are reported and left out.
template <typename V>
Notation<std::vector<V>> list_of(Notation<V> item, std::size_t shortest, Limit most,
                                 std::string phrase) {
    Form form{.shape = Shape::list,
              .items = item.forms,
              .shortest = shortest,
              .most = most,
              .phrase = std::move(phrase)};
    return {
        {std::move(form)},
        [read = item.read](const Node& node, Reading& reading) -> std::optional<std::vector<V>> {
            if (!node.is_list()) return std::nullopt;
            std::vector<V> values;
            values.reserve(node.items.size());
            for (const Node& element : node.items)
                if (element.valid)
                    if (auto value = read(element, reading)) values.push_back(std::move(*value));
            return values;
        }};
}

/// One value or a list of several.
template <typename V>
Notation<std::vector<V>> one_or_list(Notation<V> one, Limit most, std::string phrase) {
    return either(as<std::vector<V>>(one), list_of(one, 1, most, std::move(phrase)));
}

/// A list of two numbers: the ends of an interval, or a width and a height.
using TwoNumbers = std::array<double, 2>;
Notation<TwoNumbers> pair_of(Notation<double> each, std::string phrase);

/// A vector of a box of this dimension: a number on a wire, [x, y] in a plane, [x, y, z] in space.
/// `phrase` is what messages call a list.
Notation<Vec> vector_of(int dimension, Range range, const Quantity& quantity,
                        std::string phrase = "");

/// What messages call the particles in a box of this dimension.
const char* particles_of(int dimension);

/// The lower and the upper corner of a part of a box of this dimension, in one list: [x0, x1] on a
/// wire, [x0, y0, x1, y1] in a plane, [x0, y0, z0, x1, y1, z1] in space; for `key`, the name of the
/// value. Reports corners that are not in order; `first` is the hint to write one of them first.
Notation<Region> corners_of(int dimension, std::string key, std::string first);
const char* corners(int dimension);

/// The corners in a list of so many numbers; none if they are not in order.
std::optional<Region> region_of(int dimension, const std::vector<double>& ends);

/// What messages say of the order of corners: "x0 < x1 and y0 < y1".
std::string order_of_corners(int dimension);

/// One place or velocity, or a list with one for each particle, each a vector_of(dimension).
Notation<std::vector<Vec>> points(int dimension, const Quantity& quantity);

/// Returns whether a checked node is a list of several points rather than a single point.
bool lists_points(const Node& node, int dimension);

/// NUMBER of the scene language: one number for all particles, a list with one for each, or a
/// distribution to draw from.
Notation<ValueRule> rule_for(Range range, const Quantity& quantity);

/// A value together with its node, for checks that come later. The nodes must outlive the reading.
template <typename V>
struct Placed {
    V value;
    const Node* node;
};

template <typename V>
Notation<Placed<V>> placed(Notation<V> notation) {
    return parsed(notation, [](V value, const Node& node, Reading&) {
        return std::optional(Placed<V>{std::move(value), &node});
    });
}

/// Returns the values without their nodes.
template <typename V>
std::vector<V> values_of(const std::vector<Placed<V>>& placed) {
    std::vector<V> values;
    for (const Placed<V>& item : placed) values.push_back(item.value);
    return values;
}

/// A notation whose value is the node itself, to be read later.
template <typename V>
Notation<const Node*> kept(const Notation<V>& notation) {
    return {notation.forms, [](const Node& node, Reading&) { return std::optional(&node); }};
}

/// Returns the node of a key's value if it is given and valid; otherwise null.
const Node* given(const Node& mapping, std::string_view key);

}  // namespace carom
