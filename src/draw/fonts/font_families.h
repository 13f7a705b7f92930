// The families of fonts that text is set in.
#pragma once

#include <string>

namespace carom {

/// The families of a picture, as fontconfig names them. Those of a style are kept until the program
/// ends, so that texts can refer to them.
struct FontFamilies {
    std::string text, numbers, formulas;
};

}  // namespace carom
