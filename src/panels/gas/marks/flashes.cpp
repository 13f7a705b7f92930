#include "panels/gas/marks/flashes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/film.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double usual_life = 0.25;  // seconds of film
constexpr std::size_t most = 3;      // seen in any second

// Of a surface a negative number.
std::int32_t number_of(Partner partner) {
    return partner.is_surface() ? -1 - partner.surface() : partner.particle();
}

// Hits of reflecting outer walls do not count as contacts.
bool is_contact(const Collision& collision, const FrameInput& input, const Surfaces& all) {
    if (collision.second.is_particle() || !all.is_side(collision.second.surface())) return true;
    const std::vector<SurfaceState>& surfaces = input.advanced.surfaces;
    const auto side = static_cast<std::size_t>(collision.second.surface());
    return side < surfaces.size() && !only_reflects(surfaces[side].behaviour);
}

}  // namespace

// A flash is visible in at least one frame. If there are more contacts than may flash, flashes are
// spaced evenly: three at once would look like a pulse.
Flashes::Flashes(const PanelContext& context)
    : context_(context),
      asked_(context.film().flashes && context.in_film),
      life_(std::max(usual_life, 1.0 / context.film().fps)),
      dense_{0.0, {}},
      even_{(1.0 + life_) / double(most), {}} {}

// A flash that begins at least one second plus one lifetime after the third flash before it cannot
// be visible within the same second as all three.
bool Flashes::is_free(const Choice& choice, double seconds) const {
    constexpr double rounding = 1e-9;  // after a reversal the same gaps recur up to round-off
    const std::vector<Start>& starts = choice.starts;
    if (!starts.empty() && seconds - starts.back().seconds < choice.gap - rounding) return false;
    return starts.size() < most ||
           seconds - starts[starts.size() - most].seconds >= 1.0 + life_ - rounding;
}

// Whether a contact after a reversal is the repetition of one that has flashed before.
bool Flashes::is_seen_again(const Choice& choice, const Start& start, double nearest) const {
    return std::ranges::any_of(choice.starts, [&](const Start& other) {
        return other.pair == start.pair && std::abs(other.folded - start.folded) < nearest;
    });
}

void Flashes::survey(const FrameInput& input, const std::function<Vec(const Collision&)>& place) {
    if (!asked_) return;
    const Tick& tick = input.tick;
    const double step = tick.time - last_time_;
    if (tick.reversals != leg_) {
        leg_ = tick.reversals;
        low_ = leg_low_;
        high_ = leg_high_;
    }
    for (const Collision& collision : input.advanced.collisions) {
        if (!is_contact(collision, input, context_.box().surfaces)) continue;
        ++contacts_;
        const double share = step > 0.0 ? (collision.time - last_time_) / step : 1.0;
        Start start{(last_frame_ + share * (tick.frame - last_frame_)) / context_.film().fps,
                    folded_time(context_.run(), collision.time),
                    std::minmax({collision.first, number_of(collision.second)}),
                    {}};
        const bool is_way_back = start.folded > low_ && start.folded < high_;
        for (Choice* choice : {&dense_, &even_}) {
            if (!is_free(*choice, start.seconds)) continue;
            if (is_way_back && !is_seen_again(*choice, start, 0.5 * step)) continue;
            start.place = place(collision);
            choice->starts.push_back(start);
        }
    }
    const double folded = folded_time(context_.run(), tick.time);
    leg_low_ = std::min(leg_low_, folded);
    leg_high_ = std::max(leg_high_, folded);
    last_time_ = tick.time;
    last_frame_ = tick.frame;
}

void Flashes::fix_scale() {
    if (static_cast<std::int64_t>(dense_.starts.size()) < contacts_) dense_ = std::move(even_);
    even_.starts = {};
}

std::vector<Flash> Flashes::at(const Tick& tick) const {
    const double now = static_cast<double>(tick.frame) / context_.film().fps;
    const auto end = std::ranges::upper_bound(dense_.starts, now, {}, &Start::seconds);
    const auto begin = std::ranges::upper_bound(dense_.starts, now - life_, {}, &Start::seconds);
    std::vector<Flash> flashes;
    for (auto start = begin; start < end; ++start)
        flashes.push_back({start->place, (now - start->seconds) / life_});
    return flashes;
}

std::vector<std::string> Flashes::remarks() const {
    const auto shown = static_cast<std::int64_t>(dense_.starts.size());
    if (shown == contacts_) return {};
    const Language language = context_.language();
    const std::string some =
        say(language, "{} of {} collisions flash", grouped(shown), grouped(contacts_));
    return {say(language, "{}, at most three per second", some), some};
}

void draw_flash(Canvas& canvas, const DrawContext& dc, Point at, double share) {
    const double u = dc.unit;
    const double alpha = 1.0 - share * share;
    const double line = (0.26 - 0.12 * share) * u;
    const double radius = (0.7 + 0.8 * share) * u;
    // An edge in the ground's colour on both sides makes it visible on disks of any colour.
    canvas.stroke_circle(at, radius, line + 0.2 * u, with_alpha(dc.theme.ground, 0.9 * alpha));
    canvas.stroke_circle(at, radius, line, with_alpha(dc.theme.ink, alpha));
    canvas.fill_circle(at, 0.34 * u, with_alpha(dc.theme.ground, 0.9 * alpha));
    canvas.fill_circle(at, 0.24 * u, with_alpha(dc.theme.ink, alpha));
}

}  // namespace carom
