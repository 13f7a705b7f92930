// The sections of the scene language in their order, and what a reference says of their keys: for
// the reference page and for the manual of the program.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/panel_kind.h"

namespace carom {

/// A section in a plane, and the same section on a wire and in space. They may be one.
struct SectionsOfBoxes {
    const Section* plane = nullptr;
    const Section* wire = nullptr;
    const Section* space = nullptr;
};

/// Returns the sections of scenes, or one section that does not depend on the box.
SectionsOfBoxes sections_of_scenes(PanelKinds kinds);
inline SectionsOfBoxes in_any_box(const Section& section) { return {&section, &section, &section}; }

/// Returns a section and all sections inside it, in the order of their keys, each name once.
std::vector<SectionsOfBoxes> sections_within(const SectionsOfBoxes& all);

/// Returns the default of a key in words; code between backticks: "`1`", "required", "none".
std::string default_of(const Section& section, const Key& key);

/// Returns the rules about keys that exclude each other: "Exactly one of `size` and `length`."
std::vector<std::string> choices_in_words(const Section& section);

/// What is otherwise on a wire or in space: keys that are new or differ there, and the names of
/// keys that do not exist there.
struct Otherwise {
    std::vector<const Key*> keys;
    std::vector<std::string> missing;
    bool any() const { return !keys.empty() || !missing.empty(); }
};
Otherwise otherwise(const Section& plane, const Section& other);

/// The keys of panels of one kind beside those of all kinds. Keys that only this kind takes are its
/// own.
struct KeysOfKind {
    std::vector<const Key*> own, shared;
};

/// Returns those keys of a section of panels, figures or instruments that only some kinds take, and
/// this kind does.
KeysOfKind keys_of_kind(const Section& section, const std::string& kind);

/// The sections of panels in films and of figures.
const Section& panel_section(PanelKinds kinds);
const Section& figure_section(PanelKinds kinds);

}  // namespace carom
