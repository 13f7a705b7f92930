#include "panels/callouts/cards.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "draw/formula/words.h"
#include "panels/callouts/scrim.h"

namespace carom {
namespace {

constexpr double card_margin = 160.0 / 1920.0;       // of the width
constexpr double top_of_last_line = 440.0 / 1080.0;  // of a title, of the height
constexpr double card_edge = 48.0 / 1080.0;          // of the height
constexpr double title_size = 88.0 / 30.0, subtitle_size = 44.0 / 30.0, end_size = 2.0;  // units
constexpr double title_to_subtitle = 4.0;  // units, from top to top
constexpr double frame_behind_title = 0.12, gas_behind_end = 0.3;
constexpr double seconds_of_way = 0.8;
constexpr double card_line = 1.2, small_card_line = 1.35;  // of the size of letters
constexpr double above_card_baseline = 0.9;                // likewise
constexpr std::size_t most_card_lines = 8;
constexpr double least_shrunk = 0.4;

double width_on_card(const std::string& words, TextStyle style) {
    style.max_width = 0.0;
    return measure_words(words, style).width;
}

// What stands between spaces; formulae are not broken.
std::vector<std::string> single_words(const std::string& words) {
    if (words.find('$') != std::string::npos)
        return wrapped_words(words, {.max_width = 1e-3}, std::numeric_limits<std::size_t>::max());
    std::vector<std::string> all;
    std::istringstream rest(words);
    for (std::string word; rest >> word;) all.push_back(word);
    return all;
}

double widest_word(const std::string& words, const TextStyle& style) {
    double widest = 0.0;
    for (const std::string& word : single_words(words))
        widest = std::max(widest, width_on_card(word, style));
    return widest;
}

double height_on_card(const std::vector<std::string>& lines, const TextStyle& style, double line) {
    double height = 0.0;
    for (const std::string& words : lines) height += line_height_of(words, style, line).all;
    return height;
}

// Lines that fit into a height, with smaller letters if they must be. Each part begins a line.
std::vector<std::string> fitted(std::span<const std::string> parts, TextStyle& style, double line,
                                double height) {
    const double largest = style.size;
    for (;; style.size *= 0.95) {
        std::vector<std::string> lines;
        bool fits = true;
        for (const std::string& part : parts) {
            for (std::string& words : balanced(part, style, most_card_lines))
                lines.push_back(std::move(words));
            fits = fits && widest_word(part, style) <= style.max_width;
        }
        fits = fits && height_on_card(lines, style, line) <= height;
        if (fits || style.size < least_shrunk * largest) return lines;
    }
}

// The places of the single words of some lines, in order.
std::vector<PlacedLine> places_of_words(const PlacedWords& set) {
    std::vector<PlacedLine> all;
    for (const PlacedLine& line : set.lines) {
        std::string before;
        for (const std::string& word : single_words(line.words)) {
            before += word;
            all.push_back(
                {word,
                 {line.at.x + width_on_card(before, set.style) - width_on_card(word, set.style),
                  line.at.y}});
            before += " ";
        }
    }
    return all;
}

// Draws words on their way between two places, of which the second has no more lines than the
// first. Lines that become one are joined when their words have gone sideways, so that none crosses
// another.
void draw_on_way(Canvas& canvas, const PlacedWords& from, const PlacedWords& to, double way) {
    if (way <= 0.0) return draw_placed(canvas, from, 1.0);
    const std::vector<PlacedLine> begin = places_of_words(from), end = places_of_words(to);
    if (begin.size() != end.size()) {  // a word was broken
        draw_placed(canvas, from, std::max(0.0, 1.0 - 2.0 * way));
        return draw_placed(canvas, to, std::max(0.0, 2.0 * way - 1.0));
    }
    constexpr double sideways = 0.6;  // of the way, where lines are joined
    const bool joins = from.lines.size() > to.lines.size();
    const double share = smooth(joins ? std::min(1.0, way / sideways) : way);
    const double joined =
        joins ? smooth(std::max(0.0, (way - sideways) / (1.0 - sideways))) : share;
    const auto between = [&](double a, double b) { return a + share * (b - a); };
    TextStyle style = from.style;
    style.max_width = 0.0;
    style.size = between(from.style.size, to.style.size);
    style.color = mix(from.style.color, to.style.color, share);
    const double first = from.lines.front().at.y, last = to.lines.front().at.y;
    for (std::size_t k = 0; k < begin.size(); ++k) {
        const double lower = (begin[k].at.y - first) * style.size / from.style.size;
        const double y = between(first, last) + lower + joined * (end[k].at.y - last - lower);
        draw_words(canvas, {between(begin[k].at.x, end[k].at.x), y}, begin[k].words, style);
    }
}

std::vector<std::string> words_of_lines(const PlacedWords& set) {
    std::vector<std::string> all;
    for (const PlacedLine& line : set.lines) all.push_back(line.words);
    return all;
}

}  // namespace

void draw_placed(Canvas& canvas, const PlacedWords& set, double alpha) {
    TextStyle style = set.style;
    style.color = with_alpha(style.color, alpha);
    for (const PlacedLine& line : set.lines) draw_words(canvas, line.at, line.words, style);
}

std::vector<std::string> balanced(const std::string& words, const TextStyle& style,
                                  std::size_t most) {
    std::vector<std::string> lines = wrapped_words(words, style, most);
    if (lines.size() < 2 || lines.size() == most) return lines;
    TextStyle narrow = style;
    double least = widest_word(words, style), enough = style.max_width;
    for (int step = 0; step < 10 && least < enough; ++step) {
        narrow.max_width = 0.5 * (least + enough);
        std::vector<std::string> tried = wrapped_words(words, narrow, most);
        if (tried.size() > lines.size()) {
            least = narrow.max_width;
        } else {
            enough = narrow.max_width;
            lines = std::move(tried);
        }
    }
    return lines;
}

TextStyle Cards::style(double size, int weight, Color color) const {
    return {.size = size * unit_,
            .weight = weight,
            .color = color,
            .tabular = false,
            .max_width = (1.0 - 2.0 * card_margin) * picture().width,
            .fonts = theme_.fonts};
}

// Of a short card half of it.
double Cards::way_of_title(const Film& film, const Tick& tick) {
    const int frames = card_frames(film).title;
    const double way = std::min(seconds_of_way * film.fps, 0.5 * frames);
    return way > 0.0 ? std::clamp(1.0 - (frames - tick.frame) / way, 0.0, 1.0) : 1.0;
}

// Its last line has a fixed place, so that the subtitle has one, too.
PlacedWords Cards::title_on_card(std::span<const std::string> parts) const {
    PlacedWords title{{}, style(title_size, 600, theme_.ink)};
    const double height = picture().height, top = top_of_last_line * height;
    const std::vector<std::string> lines = fitted(
        parts, title.style, card_line, top + title_size * card_line * unit_ - card_edge * height);
    const double line = card_line * title.style.size;
    double y = top + above_card_baseline * title.style.size - line * double(lines.size());
    for (const std::string& words : lines)
        title.lines.push_back({words, {card_margin * picture().width, y += line}});
    return title;
}

PlacedWords Cards::subtitle_on_card(std::span<const std::string> parts) const {
    PlacedWords subtitle{{}, style(subtitle_size, 500, theme_.muted)};
    const double height = picture().height;
    double top = top_of_last_line * height + title_to_subtitle * unit_;
    for (const std::string& words :
         fitted(parts, subtitle.style, small_card_line, (1.0 - card_edge) * height - top)) {
        subtitle.lines.push_back(
            {words,
             {card_margin * picture().width, top + above_card_baseline * subtitle.style.size}});
        top += small_card_line * subtitle.style.size;
    }
    return subtitle;
}

void Cards::draw_title(Canvas& canvas, const PlacedWords& title,
                       const std::optional<PlacedWords>& subtitle, const Tick& tick) const {
    const double way = way_of_title(film_, tick);
    const double behind = frame_behind_title + (1.0 - frame_behind_title) * smooth(way);
    cover(canvas, picture(), 1.0 - behind);
    draw_on_way(canvas, title_on_card(words_of_lines(title)), title, way);
    if (subtitle)
        draw_on_way(canvas, subtitle_on_card(words_of_lines(*subtitle)), *subtitle, way);
    else
        draw_placed(canvas, subtitle_on_card({{words_of_text(subtitle_)}}),
                    std::max(0.0, 1.0 - 2.0 * way));
}

void Cards::cover(Canvas& canvas, const Rect& part, double share) const {
    if (film_.transparent)
        canvas.fade(part, share);
    else
        canvas.fill(part, with_alpha(theme_.page, share));
}

void Cards::draw_end(Canvas& canvas, const Rect& gas, double share) const {
    const Rect all = picture();
    cover(canvas, all, (1.0 - gas_behind_end) * share);
    const double left = std::floor(gas.x), top = std::floor(gas.y);  // edges of whole pixels
    cover_around(all, {left, top, std::ceil(gas.right()) - left, std::ceil(gas.bottom()) - top},
                 [&](const Rect& part) { cover(canvas, part, share); });
    const double seen = std::max(0.0, 2.0 * share - 1.0);  // not over the gas's own words
    TextStyle large = style(end_size, 600, with_alpha(theme_.ink, seen));
    const std::vector<std::string> lines =
        fitted({{film_.end_card}}, large, card_line, (1.0 - 2.0 * card_edge) * all.height);
    const double height = height_on_card(lines, large, card_line);
    const Rect& behind = height < gas.height ? gas : all;
    const double middle = behind.y + 0.5 * (behind.height - height);
    double y = std::max(0.0, std::min(middle, all.height - height));
    for (const std::string& line : lines) {
        const auto [above, whole] = line_height_of(line, large, card_line);
        draw_words(canvas, {card_margin * all.width, y + above}, line, large);
        y += whole;
    }
}

}  // namespace carom
