#include "panels/gas/marks/ghosts.h"

#include <algorithm>

#include "scene/scene.h"

namespace carom {
namespace {

constexpr double words_seconds = 4.0;  // of film
constexpr double fade_seconds = 0.5;

}  // namespace

void GhostKeeper::see(const Tick& tick, const Eigen::ArrayXXf& places) {
    const std::size_t before = next_;
    while (next_ < scene_.marks.size() && scene_.marks[next_].at <= tick.time) ++next_;
    if (next_ == before) return;
    auto ghosts = std::make_shared<Ghosts>();
    ghosts->words = scene_.marks[next_ - 1].words;
    ghosts->frame = tick.frame;
    ghosts->place = places;
    present_ = std::move(ghosts);
}

double GhostKeeper::words_alpha(const Tick& tick) const {
    if (!present_) return 0.0;
    const double seconds = static_cast<double>(tick.frame - present_->frame) / scene_.film.fps;
    const double at_first = (words_seconds - seconds) / fade_seconds;
    const double at_last = tick.phase == Phase::closing ? 4.0 * tick.progress : 0.0;
    return std::clamp(std::max(at_first, at_last), 0.0, 1.0);
}

double ghost_line(const DrawContext& dc) { return std::max(1.0, 0.07 * dc.unit); }

void draw_ghost_words(Canvas& canvas, const DrawContext& dc, Point left, double width,
                      const Ghosts& ghosts, double alpha) {
    if (alpha <= 0.0) return;
    const double u = dc.unit, margin = 0.3 * u;
    const Point at{left.x + margin, left.y};
    width -= 2.0 * margin;
    TextStyle style = title_style(dc);
    style.color = with_alpha(dc.theme.ink, alpha);
    style.max_width = width - 2.3 * u;
    const std::string words = escape_markup(ghosts.words);
    canvas.fill({at.x, at.y - 1.25 * u, measure_text(words, style).width + 2.3 * u, 1.7 * u},
                with_alpha(dc.theme.ground, plate_alpha * alpha));
    canvas.stroke_circle({at.x + 0.9 * u, at.y - 0.4 * u}, 0.45 * u, 1.5 * ghost_line(dc),
                         with_alpha(dc.theme.muted, alpha));
    draw_text(canvas, {at.x + 1.8 * u, at.y}, words, style);
}

}  // namespace carom
