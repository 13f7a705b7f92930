// The text on disks and beads: masses or numbers, if they fit.
#pragma once

#include <optional>
#include <string>

#include "panels/panel.h"

namespace carom {

/// The mass of a particle with few digits; "∞" for an infinite mass.
std::string mass_text(Language language, double inverse_mass);

/// Shortens a number with a decimal point by one digit; returns it unchanged if that is not
/// possible.
std::string shorter_number(const std::string& words);

/// The mass or the number of a particle, as `labels` asks for; empty if it asks for none.
std::string words_on(const PanelContext& context, Eigen::Index particle, Labels labels);

/// A text that fits on a bead.
struct FittingWords {
    std::string text;
    TextStyle style;  ///< without a colour
};

/// Sets a text as large as it fits on a bead of this radius (pixels). A number that does not fit
/// loses a digit or two; none if that does not fit either.
std::optional<FittingWords> fitting_words(const DrawContext& dc, double radius,
                                          const std::string& words);

/// Writes a text on a bead at `center` that has the colour `bead`, as fitting_words() sets it;
/// nothing if it does not fit.
void draw_words_on(Canvas& canvas, const DrawContext& dc, Point center, double radius,
                   const std::string& words, Color bead);

}  // namespace carom
