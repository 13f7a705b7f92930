// The vocabulary in which the key table is written: makers of forms and sections.
#pragma once

#include <initializer_list>

#include "scene/keys.h"

namespace carom {

Form number(Range range);

/// A whole number from `low` up to the ceiling.
Form integer(double low, Limit most);

Form flag();
Form one_of(std::vector<std::string> words);
Form color();

/// One line, `shortest` to `longest` characters.
Form text(std::size_t shortest, std::size_t longest);

/// The same with line breaks.
Form lines(std::size_t shortest, Limit most);

/// A list of a fixed or bounded length; `phrase` is how a message calls it.
Form list_of(std::vector<Form> items, std::size_t shortest, std::size_t longest,
             std::string phrase);
Form list_of(std::vector<Form> items, std::size_t shortest, Limit most, std::string phrase);

Form mapping(Section section, std::string phrase = "a mapping");

/// NUMBER of the scene language: a number for all, a list of one for each particle, or a law.
std::vector<Form> quantity(Range range);

/// The section with the defaults of its keys as values.
Section complete(Section section);

}  // namespace carom
