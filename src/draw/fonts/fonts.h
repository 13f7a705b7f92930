// The fonts used for text, for text.cpp: Inter, or another family, through a private font
// configuration, and all fonts of the machine. Detects fonts that could not be read, which Pango
// and Cairo do not report: they draw other letters or none.
#pragma once

#include <pango/pangocairo.h>

#include <memory>
#include <string>
#include <vector>

namespace carom {

template <auto release>
struct Releaser {
    template <typename T>
    void operator()(T* handle) const {
        release(handle);
    }
};
template <typename T, auto release>
using Owned = std::unique_ptr<T, Releaser<release>>;

/// The typeface of all pictures without another.
inline constexpr const char* font_family = "Inter";

/// The fonts of one thread: Pango's fonts may not be shared between threads.
struct Fonts {
    Owned<PangoFontMap, g_object_unref> map;
    Owned<PangoContext, g_object_unref> context;
};

/// Only the fonts of one family, and of Inter, which has the letters that it lacks. Throws
/// SystemError if the family is not on this machine (for Inter with the Debian package to install),
/// or if a file of it cannot be read.
Fonts declared_fonts(const std::string& family = font_family);

/// The names of all families of the machine, each once, in order. Throws SystemError.
std::vector<std::string> families_of_machine();

/// All fonts of the machine. Throws SystemError.
Fonts machine_fonts();

/// Throws SystemError if a font of the layout cannot be read, or if the declared font is used in
/// another weight than `weight` (0: any).
void require_fonts_of(PangoLayout* layout, int weight);

/// Throws SystemError if Cairo could not draw with a font.
void require_drawn(cairo_t* context);

}  // namespace carom
