// The fonts that text is set with, for text.cpp: Inter through a private font configuration, and
// all fonts of the machine. Finds the fonts that could not be read, of which Pango and Cairo say
// nothing: they draw other letters, or none.
#pragma once

#include <pango/pangocairo.h>

#include <memory>

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

/// The typeface of all pictures.
inline constexpr const char* font_family = "Inter";

/// The fonts of one thread: Pango's may not be shared.
struct Fonts {
    Owned<PangoFontMap, g_object_unref> map;
    Owned<PangoContext, g_object_unref> context;
};

/// Only those of the family. Throws SystemError, with the Debian package to install, if it is not
/// on this machine, and where a file of it cannot be read.
Fonts declared_fonts();

/// All of the machine. Throws SystemError.
Fonts machine_fonts();

/// Throws SystemError where a font of the layout cannot be read, or where the declared one is there
/// in another weight than `weight` (0: any).
void require_fonts_of(PangoLayout* layout, int weight);

/// Throws SystemError where Cairo could not draw with a font.
void require_drawn(cairo_t* context);

}  // namespace carom
