// The cards of a film: its title over the first frame before it moves to its place, and the last
// words over the gas.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "draw/style.h"
#include "draw/text.h"
#include "scene/film.h"
#include "scene/time/timeline.h"

namespace carom {

/// A line of words (draw_words()) with its baseline through `at`.
struct PlacedLine {
    std::string words;
    Point at;
};

/// Words in their place.
struct PlacedWords {
    std::vector<PlacedLine> lines;
    TextStyle style;
};

/// Draws them with the opacity `alpha`.
void draw_placed(Canvas& canvas, const PlacedWords& set, double alpha);

class Cards {
  public:
    /// `subtitle`: of the scene. `unit` is that of the film's grid.
    Cards(const Film& film, const std::string& subtitle, const Theme& theme, double unit)
        : film_(film), subtitle_(subtitle), theme_(theme), unit_(unit) {}

    /// Draws the card before the film over its first frame without the words that the card shows.
    /// In its last 0.8 s these go to `title` and `subtitle`, where the film shows them, and the
    /// frame appears. A subtitle without a place fades out.
    void draw_title(Canvas& canvas, const PlacedWords& title,
                    const std::optional<PlacedWords>& subtitle, const Tick& tick) const;

    /// Draws the card after the film over a frame with `gas` in it. `share` is what has appeared
    /// of it, from 0 to 1.
    void draw_end(Canvas& canvas, const Rect& gas, double share) const;

    /// The share of the way from the card to its place that the title has gone in a frame.
    static double way_of_title(const Film& film, const Tick& tick);

  private:
    Rect picture() const { return {0.0, 0.0, double(film_.size.width), double(film_.size.height)}; }
    /// Covers a part of the picture with the page, or with nothing where the film has none.
    void cover(Canvas& canvas, const Rect& part, double share) const;
    TextStyle style(double size, int weight, Color color) const;
    PlacedWords title_on_card(std::span<const std::string> parts) const;
    PlacedWords subtitle_on_card(std::span<const std::string> parts) const;

    const Film& film_;
    const std::string& subtitle_;
    const Theme& theme_;
    double unit_;
};

/// Breaks words into as few lines of at most `style.max_width` as possible, and these into lines of
/// about equal length, so that no word stands alone in the last one.
std::vector<std::string> balanced(const std::string& words, const TextStyle& style,
                                  std::size_t most);

}  // namespace carom
