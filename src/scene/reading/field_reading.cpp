// The key of a film's field.
#include <fmt/format.h>

#include <algorithm>

#include "physics/gas.h"
#include "scene/limits.h"
#include "scene/reading/overlay_reading.h"
#include "scene/words.h"
#include "util/text.h"

namespace carom {
namespace {

struct FieldDraft : Field {
    std::string name;  // of a species
};

// A share is that of a species.
std::optional<Field> field_of(const FieldDraft& draft, const Node& node, Reading& reading) {
    Field field = draft;
    const Node* named = given(node, "species");
    const bool is_share = field.of == FieldOf::concentration;
    const std::vector<Species>& all = reading.gas.species;
    const std::string example =
        all.empty() ? "species: NAME" : fmt::format("species: {}", all.back().name);
    if (is_share && named == nullptr && find(node, "species") == nullptr)
        reading.errors.add(node, "a `concentration` is that of a species: `species` is missing",
                           "for instance {of: concentration, " + example + "}");
    if (!is_share && named != nullptr)
        reading.errors.add(*named, "`species` applies to `of: concentration` only",
                           "leave it out, or write `of: concentration`");
    if (!is_share || named == nullptr) return field;
    const auto found = std::ranges::find(all, draft.name, &Species::name);
    if (found == all.end()) {
        reading.errors.add(*named, fmt::format("there is no species {}", in_quotes(draft.name)),
                           "give a name from `gas`, for instance " + example);
        return std::nullopt;
    }
    field.species = static_cast<std::size_t>(found - all.begin());
    return field;
}

}  // namespace

Notation<FieldOf> quantity_notation(bool with_shares) {
    return with_shares ? one_of<FieldOf>()
                       : one_of<FieldOf>({{"density", FieldOf::density},
                                          {"temperature", FieldOf::temperature},
                                          {"speed", FieldOf::speed},
                                          {"flow", FieldOf::flow}});
}

Binding<Film> field_key() {
    const KeyTable<FieldDraft> table{
        .name = "`field`",
        .keys = {bind_key("of", &FieldDraft::of, quantity_notation(true),
                          "What it shows: the number of particles per unit of area, the "
                          "temperature of their motion about the mean velocity of the cell, their "
                          "mean speed, their mean velocity as arrows, or the share of a species.")
                     .required(),
                 bind_key("species", &FieldDraft::name, text(1, most_name_letters),
                          "With `of: concentration`: the species whose share is shown.")
                     .default_text("required for a concentration"),
                 bind_key("cells", &FieldDraft::cells, whole(2, most_field_cells),
                          "The number of cells along the longer side of the box."),
                 bind_key("over", &FieldDraft::over, number(positive, quantities::time),
                          "The simulated time before the present over which it is averaged, by the "
                          "exact times that particles spend in each cell."),
                 bind_key("opacity", &FieldDraft::opacity, number({0.1, {1.0}}),
                          "The opacity of its colours over the background.")}};
    const auto made =
        parsed(complete_mapping(table, "{of: density, cells: 20, over: 1}"), field_of);
    return bind_key("field", &Film::field, made,
                    "A quantity in square cells, drawn under the particles, which are then drawn "
                    "as dim outlines. Along a direction in which all places of the gas are alike "
                    "it is the mean over the whole box. Colours go over smoothly from cell to "
                    "cell, with the mean of each cell kept; tables give the cells. Cells with "
                    "fewer than three particles on average are blank.")
        .default_text("none");
}

}  // namespace carom
