// What is written on disks and beads: masses or numbers, where they fit.
#pragma once

#include <optional>
#include <string>

#include "panels/panel.h"

namespace carom {

/// The mass of a particle in few digits; "∞" for an infinite one.
std::string mass_text(Language language, double inverse_mass);

/// A number with a decimal point, shorter by a digit; as it is if that is not possible.
std::string shorter_number(const std::string& words);

/// Its mass or its number, whichever `labels` asks for; empty for none.
std::string words_on(const PanelContext& context, Eigen::Index particle, Labels labels);

/// Words as they fit on a bead.
struct FittingWords {
    std::string text;
    TextStyle style;  ///< without a colour
};

/// Words for a bead of a radius (pixels), as large as fits; a number with a digit or two less where
/// it fits only so, and nothing where that does not fit.
std::optional<FittingWords> fitting_words(const DrawContext& dc, double radius,
                                          const std::string& words);

/// Writes words on a bead of a colour around `center`, as they fit, or not at all.
void draw_words_on(Canvas& canvas, const DrawContext& dc, Point center, double radius,
                   const std::string& words, Color bead);

}  // namespace carom
