// The parts of the key table, which keys.cpp puts together: a file each for films, panels and
// figures, and figure sets.
#pragma once

#include <string>
#include <vector>

#include "scene/keys/forms.h"
#include "scene/keys/keys.h"

namespace carom::keys {

inline constexpr Range any_number{};
inline constexpr Range not_negative{0.0, largest_quantity.value, largest_quantity.meaning};
inline constexpr Range positive{smallest_quantity.value, largest_quantity.value,
                                largest_quantity.meaning};

// panel_keys.cpp
std::vector<Form> chosen();  ///< particles: all, a species, a number, or a list of these
Form monitors();             ///< a list of numbers to show
Form panel_kind();
Section panel();
Section figure();
const std::vector<std::string>& compared();  ///< kinds that show several runs, one line of each
Key changes();                               ///< what is laid over the scene of a compared run

// film_keys.cpp
Section film();
Section template_file();

// set_keys.cpp
Section figure_set();

}  // namespace carom::keys
