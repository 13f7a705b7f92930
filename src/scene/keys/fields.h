// Reading a checked mapping by the key table: values as written, or their defaults.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/gas.h"
#include "scene/keys/keys.h"
#include "scene/yaml/node.h"

namespace carom {

/// The values of one mapping. Refers to the node and the section.
class Fields {
  public:
    Fields(const Node& node, const Section& section) : node_(node), section_(section) {}

    /// The value as written; null if it is not there or invalid.
    const Node* given(std::string_view key) const;

    /// Whether the key is written, rightly or wrongly.
    bool mentions(std::string_view key) const;

    /// The value or its default; null if there is neither.
    const Node* value(std::string_view key) const;

    std::optional<double> number(std::string_view key) const;
    std::optional<std::int64_t> integer(std::string_view key) const;
    std::optional<bool> flag(std::string_view key) const;
    std::optional<std::string> text(std::string_view key) const;  ///< without space at its end

    /// The fields of a mapping inside this one; nothing if it is not there or no mapping.
    std::optional<Fields> inner(std::string_view key) const;

    const Node& node() const { return node_; }
    const Section& section() const { return section_; }

  private:
    const Node& node_;
    const Section& section_;
};

/// The numbers of a checked list.
std::vector<double> numbers(const Node& list);

/// A checked list of two numbers.
Eigen::Array2d pair(const Node& list);

/// One checked point or velocity, or a list of them: [x, y] in two dimensions, a number in one.
std::vector<Eigen::Array2d> points(const Node& node, int dimension);

/// Whether a node lists several points, and is not one itself.
bool lists_points(const Node& node, int dimension);

/// A checked NUMBER. Reports laws that contradict themselves or leave `range`.
std::optional<Quantity> quantity_in(const Node& node, Range range, Errors& errors);

}  // namespace carom
