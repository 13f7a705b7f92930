// The vocabulary in which the key table is written: makers of forms, keys and sections.
#pragma once

#include "scene/keys/keys.h"

namespace carom {

Form number(Range range);

/// A whole number from `low` up to the ceiling.
Form integer(double low, Limit most);

Form flag();
Form one_of(std::vector<std::string> words);
Form color();

/// One line, of at least `shortest` characters.
Form text(std::size_t shortest, Limit most);

/// The same with line breaks.
Form lines(std::size_t shortest, Limit most);

/// A list of a fixed or bounded length; `phrase` is how a message calls it.
Form list_of(std::vector<Form> items, std::size_t shortest, std::size_t longest,
             std::string phrase);
Form list_of(std::vector<Form> items, std::size_t shortest, Limit most, std::string phrase);

Form mapping(Section section, std::string phrase = "a mapping");

/// NUMBER of the scene language: a number for all, a list of one for each particle, or a law.
std::vector<Form> quantity(Range range);

/// A key that must be there.
Key required(Key key);

/// A key with a fixed default, as it would be written in a scene.
Key otherwise(std::string preset, Key key);

/// A key whose default comes from elsewhere, in words.
Key left_to(std::string note, Key key);

/// A key that stands only beside these words of `kind`.
Key only_with(std::vector<std::string> kinds, Key key);

/// The section with the defaults of its keys as values.
Section complete(Section section);

}  // namespace carom
