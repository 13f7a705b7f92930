// How values are written in a scene. A notation says it once for all: the forms that a value may
// take (for messages, schema and reference), how a checked node becomes the value, and how a value
// is written again (for defaults). Larger notations are put together from smaller ones.
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

#include "physics/gas.h"
#include "physics/run.h"
#include "scene/keys/keys.h"
#include "scene/words.h"
#include "scene/yaml/node.h"

namespace carom {

/// What reading a value may look at beside its node: where mistakes are reported, and what has been
/// read of the scene so far.
struct Reading {
    Errors& errors;
    const Gas& gas;
    const Run& run;
};

/// What copies share. Nothing of it is inline: notations are compiled to a third less code so.
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

/// A function whose copies share what it holds: notations are put together from many. Little is
/// compiled for each, as there are hundreds.
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

    /// The value of a node that has one of the forms; nothing if it has none of them, or if the
    /// value is wrong in itself, which is reported.
    SharedFunction<std::optional<V>(const Node&, Reading&)> read;

    /// A value as a scene would write it; empty if it would be written as no single word or number.
    SharedFunction<std::string(const V&)> write = [](const V&) { return std::string{}; };

    /// The same where messages call its first form by a phrase.
    Notation called(std::string phrase) const {
        Notation notation = *this;
        notation.forms.front().phrase = std::move(phrase);
        return notation;
    }
};

Notation<double> number(Range range);

/// A whole number from `low` up to the limit.
Notation<std::int64_t> whole(double low, Limit most);

Notation<bool> flag();

/// A colour as #rrggbb.
Notation<std::string> color();

/// One line, of at least `shortest` characters, without space at its end.
Notation<std::string> text(std::size_t shortest, Limit most);

/// The same with line breaks.
Notation<std::string> lines(std::size_t shortest, Limit most);

/// The same where spans between `$` signs are formulae (util/formula/).
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

/// The value of a notation turned into another by `convert(value)`.
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

/// The value as another type that is made from it: an alternative of a variant, its only member, a
/// base.
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

/// The same where `parse(value, node, reading)` may find a mistake, which it reports: it gives an
/// optional.
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

/// The same value after `check(value, node, reading)`, which reports what is wrong with it.
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

/// Either of two notations; which, the forms tell.
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

/// A list of at least `shortest` items, at most so many; `phrase` is how a message calls it. Items
/// with mistakes, which are reported, are left out.
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
            for (const Node& one : node.items)
                if (one.valid)
                    if (auto value = read(one, reading)) values.push_back(std::move(*value));
            return values;
        }};
}

/// One value or a list of several.
template <typename V>
Notation<std::vector<V>> one_or_list(Notation<V> one, Limit most, std::string phrase) {
    return either(as<std::vector<V>>(one), list_of(one, 1, most, std::move(phrase)));
}

/// A list of two numbers.
Notation<Eigen::Array2d> pair_of(Range range, std::string phrase);

/// One place or velocity, or a list of one for each particle: [x, y] in two dimensions, a number in
/// one.
Notation<std::vector<Eigen::Array2d>> points(int dimension);

/// Whether a checked node lists several points, and is not one itself.
bool lists_points(const Node& node, int dimension);

/// NUMBER of the scene language: a number for all, a list of one for each particle, or a
/// distribution to draw from.
Notation<Quantity> quantity(Range range);

/// A value together with its node, for what is checked later. Nodes outlive the reading.
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

/// The values without their nodes.
template <typename V>
std::vector<V> values_of(const std::vector<Placed<V>>& placed) {
    std::vector<V> values;
    for (const Placed<V>& one : placed) values.push_back(one.value);
    return values;
}

/// The node alone, to be read later.
template <typename V>
Notation<const Node*> kept(const Notation<V>& notation) {
    return {notation.forms, [](const Node& node, Reading&) { return std::optional(&node); }};
}

/// The value of a key as written, if it is valid; null if it is not there, or wrong.
const Node* given(const Node& mapping, std::string_view key);

}  // namespace carom
