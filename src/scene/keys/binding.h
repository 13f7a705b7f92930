// Bindings: each defines a key of the scene language in one entry. A binding has the key's name,
// the field that it fills, the notation of its value, its meaning, and its default.
//
//     bind_key("fps", &Film::fps, whole(1, most_frames_per_second), "Frames in a second.")
//
// The default is the field's value in a default-constructed object of its type; if there is no such
// value, the binding gives the default. Reading, the check, the schema, the reference page and the
// starter scene are all generated from tables of bindings. Rules between several keys are functions
// that a table names.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/keys/notation.h"

namespace carom {

/// A key, and how its value is read into a part of an object. This is what bindings of all types of
/// objects have in common; their code is compiled once for it, not for each of hundreds of fields.
struct AnyBinding {
    /// Reads a value into a part of an object.
    using ReadPart = SharedFunction<void(void* part, const Node&, Reading&)>;

    Key key;
    ReadPart read_part;
    std::ptrdiff_t offset = 0;   ///< of the part in the object, in bytes
    bool reads_default = false;  ///< whether the default is read if the key is not given

    AnyBinding(Key key, ReadPart read_part, std::ptrdiff_t offset = 0);
    AnyBinding(const AnyBinding&);
    AnyBinding(AnyBinding&&) noexcept;
    AnyBinding& operator=(const AnyBinding&);
    AnyBinding& operator=(AnyBinding&&) noexcept;
    ~AnyBinding();

    /// Reads a value into the part of the object.
    void read_into(void* object, const Node& node, Reading& reading) const;
};

namespace binding {

/// Returns an object whose fields have their initial values.
template <typename T>
const T& initial() {
    static const T value{};
    return value;
}

/// Returns how far a part lies behind the start of an object, in bytes.
std::ptrdiff_t distance(const void* object, const void* part);

}  // namespace binding

/// A key and the field of T that it fills.
template <typename T>
struct Binding : AnyBinding {
    using AnyBinding::AnyBinding;
    template <std::same_as<AnyBinding> Any>
    explicit Binding(Any any) : AnyBinding(std::move(any)) {}

    /// Reads a value into the field.
    void read(T& into, const Node& node, Reading& reading) const {
        read_into(&into, node, reading);
    }

    /// Converts to a binding of the same field in a type derived from T.
    template <std::derived_from<T> Derived>
    operator Binding<Derived>() && {
        const Derived& object = binding::initial<Derived>();
        const T& base = object;
        offset += binding::distance(&object, &base);
        return Binding<Derived>(static_cast<AnyBinding&&>(*this));
    }

    /// Makes the key required.
    Binding required() && {
        key.required = true;
        key.default_value.clear();
        return std::move(*this);
    }

    /// Sets a default, as a scene would write it, that differs from the field's initial value.
    Binding default_value(std::string written) && {
        key.default_value = std::move(written);
        reads_default = true;
        return std::move(*this);
    }

    /// Sets a default that is not a fixed value, described in words.
    Binding default_text(std::string words) && {
        key.default_value.clear();
        key.default_text = std::move(words);
        return std::move(*this);
    }

    /// Gives the name that the key had in earlier versions. Scenes may still use it, with a note.
    Binding formerly(std::string name) && {
        key.formerly = std::move(name);
        return std::move(*this);
    }

    /// Gives other names that users are likely to try: the hint for them is this key.
    Binding tried_as(std::vector<std::string> names) && {
        key.tried = std::move(names);
        return std::move(*this);
    }

    /// Restricts the key to some kinds of panel.
    Binding only_with(std::vector<std::string> kinds) && {
        key.kinds = std::move(kinds);
        return std::move(*this);
    }
};

namespace binding {

// Returns the field's initial value as a scene would write it.
template <typename V, typename Field>
std::string initial_text(const Notation<V>& notation, const Field& initial) {
    if constexpr (std::is_same_v<V, Field>)
        return notation.write(initial);
    else if constexpr (std::is_same_v<std::optional<V>, Field>)
        return initial ? notation.write(*initial) : "";
    else if constexpr (std::is_arithmetic_v<Field>)
        return notation.write(static_cast<V>(initial));
    else
        return "";
}

template <typename V, typename Field>
void assign(Field& field, V value) {
    if constexpr (std::is_arithmetic_v<V> && std::is_arithmetic_v<Field>)
        field = static_cast<Field>(value);
    else if constexpr (std::is_same_v<std::int64_t, V> && std::is_same_v<std::optional<int>, Field>)
        field = static_cast<int>(value);
    else
        field = std::move(value);
}

/// A key that fills a field, in an object of any type.
template <typename Field, typename V>
AnyBinding of_field(std::string name, const Field& initial, const Notation<V>& notation,
                    std::string meaning) {
    Key key{.name = std::move(name), .meaning = std::move(meaning), .forms = notation.forms};
    key.default_value = initial_text(notation, initial);
    return {std::move(key),
            [read = notation.read](void* field, const Node& node, Reading& reading) {
                if (auto value = read(node, reading))
                    assign(*static_cast<Field*>(field), std::move(*value));
            }};
}

}  // namespace binding

/// A key that fills a field, with the field's initial value as its default.
template <typename T, typename Field, typename V>
Binding<T> bind_key(std::string name, Field T::*field, const Notation<V>& notation,
                    std::string meaning) {
    const T& object = binding::initial<T>();
    Binding<T> bound(
        binding::of_field(std::move(name), object.*field, notation, std::move(meaning)));
    bound.offset = binding::distance(&object, &(object.*field));
    return bound;
}

/// A key that fills several fields: `fill(T&, value)`.
template <typename T, typename V, typename Fill>
Binding<T> bind_with(std::string name, Fill fill, const Notation<V>& notation,
                     std::string meaning) {
    return {{.name = std::move(name), .meaning = std::move(meaning), .forms = notation.forms},
            [fill, read = notation.read](void* into, const Node& node, Reading& reading) {
                if (auto value = read(node, reading))
                    fill(*static_cast<T*>(into), std::move(*value));
            }};
}

/// Returns a key of a T as a key of a whole, in which `part` finds the T: `part(Whole&)` returns a
/// reference to it.
template <typename Whole, typename T, typename Part>
Binding<Whole> bind_within(Part part, Binding<T> binding) {
    const auto read = [part, read = std::move(binding.read_part), offset = binding.offset](
                          void* into, const Node& node, Reading& reading) {
        T& found = part(*static_cast<Whole*>(into));
        read(reinterpret_cast<char*>(&found) + offset, node, reading);
    };
    Binding<Whole> bound(std::move(binding.key), read);
    bound.reads_default = binding.reads_default;
    return bound;
}

/// Returns a key of a T, or several, as keys of a whole of which the T is a member.
template <typename Whole, typename T>
Binding<Whole> bind_within(T Whole::*member, Binding<T> binding) {
    const Whole& object = binding::initial<Whole>();
    binding.offset += binding::distance(&object, &(object.*member));
    return Binding<Whole>(static_cast<AnyBinding&&>(binding));
}

template <typename Whole, typename T>
std::vector<Binding<Whole>> bind_within(T Whole::*member, std::vector<Binding<T>> keys) {
    std::vector<Binding<Whole>> all;
    for (Binding<T>& key : keys) all.push_back(bind_within(member, std::move(key)));
    return all;
}

/// A key that fills a whole value, with the initial value as its default.
template <typename V>
Binding<V> bind_value(std::string name, const Notation<V>& notation, std::string meaning) {
    Binding<V> bound = bind_with<V>(
        std::move(name), [](V& into, V value) { into = std::move(value); }, notation,
        std::move(meaning));
    bound.key.default_value = binding::initial_text(notation, V{});
    return bound;
}

/// Returns the bindings of a T and of its bases in one list.
template <typename T, typename... Bases>
std::vector<Binding<T>> joined(std::vector<Binding<Bases>>... parts) {
    std::vector<Binding<T>> all;
    all.reserve((parts.size() + ...));
    const auto append = [&all](auto&& part) {
        for (auto& binding : part) all.push_back(std::move(binding));
    };
    (append(std::move(parts)), ...);
    return all;
}

/// Returns a default as a node.
Node default_node(const std::string& written);

/// The keys of one mapping that is read into a T.
template <typename T>
struct KeyTable {
    std::string name;  ///< as in "an item of `gas`"
    std::vector<Binding<T>> keys;
    std::vector<Choice> choices = {};
    std::vector<Refused> refused = {};

    /// Rules between several keys; called after all keys have been read.
    std::function<void(T&, const Node&, Reading&)> rule = {};
};

/// A complete table of keys, as a section and the functions that read its keys into an object.
/// Copies share both.
class AnyTable {
  public:
    /// Called after all keys have been read.
    using Rule = SharedFunction<void(void* object, const Node&, Reading&)>;

    AnyTable(Section section, std::vector<AnyBinding> keys, std::optional<Rule> rule);

    const Section& section() const;

    /// Returns the form of a mapping with these keys; `phrase` is what messages call it.
    Form form(std::string phrase) const;

    /// Reads a checked mapping into an object. Fields whose keys are invalid or not given keep
    /// their defaults.
    void read_into(void* object, const Node& mapping, Reading& reading) const;

    /// Returns whether all required keys have valid values.
    bool is_complete(const Node& mapping) const;

  private:
    struct Contents;
    std::shared_ptr<const Contents> contents_;
};

/// A complete table of the keys of a T.
template <typename T>
class FixedTable : public AnyTable {
  public:
    FixedTable(KeyTable<T> table)
        : AnyTable({.name = std::move(table.name),
                    .keys = {},
                    .choices = std::move(table.choices),
                    .refused = std::move(table.refused)},
                   {std::move_iterator(table.keys.begin()), std::move_iterator(table.keys.end())},
                   erased(std::move(table.rule))) {}

    void read(const Node& mapping, T& value, Reading& reading) const {
        read_into(&value, mapping, reading);
    }

  private:
    static std::optional<Rule> erased(std::function<void(T&, const Node&, Reading&)> rule) {
        if (!rule) return std::nullopt;
        return [rule](void* object, const Node& mapping, Reading& reading) {
            rule(*static_cast<T*>(object), mapping, reading);
        };
    }
};

/// A notation for a mapping with the keys of a table.
template <typename T>
Notation<T> mapping(const FixedTable<T>& table, std::string phrase = "a mapping") {
    return {{table.form(std::move(phrase))},
            [table](const Node& node, Reading& reading) -> std::optional<T> {
                if (!node.is_mapping()) return std::nullopt;
                std::optional<T> value(std::in_place);
                table.read(node, *value, reading);
                return value;
            }};
}
template <typename T>
Notation<T> mapping(KeyTable<T> keys, std::string phrase = "a mapping") {
    return mapping(FixedTable<T>(std::move(keys)), std::move(phrase));
}

/// The same notation, but it reads as nothing if a required key has no valid value.
template <typename T>
Notation<T> complete_mapping(KeyTable<T> keys, std::string phrase = "a mapping") {
    const FixedTable<T> table(std::move(keys));
    Notation<T> notation = mapping(table, std::move(phrase));
    notation.read = [table, read = notation.read](const Node& node,
                                                  Reading& reading) -> std::optional<T> {
        auto value = read(node, reading);
        if (!table.is_complete(node)) value.reset();
        return value;
    };
    return notation;
}

}  // namespace carom
