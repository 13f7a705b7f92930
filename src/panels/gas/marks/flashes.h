// Flashes: short marks where two particles collide, or where a particle hits a surface other than a
// reflecting outer wall. At most three are visible in any second of film (WCAG 2.2, 2.3.1); further
// ones are omitted, by a rule that depends only on the times of the film.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// One flash in one frame.
struct Flash {
    Vec place;           ///< of the contact
    double share = 0.0;  ///< share of its duration that has passed, from 0 to 1
};

/// The flashes of a film: chosen in the first pass, looked up in the second.
class Flashes {
  public:
    explicit Flashes(const PanelContext& context);

    bool asked() const { return asked_; }

    /// First pass, every frame in order; then fix_scale(). `place` says where a contact is drawn.
    void survey(const FrameInput& input, const std::function<Vec(const Collision&)>& place);
    void fix_scale();

    void archive(auto& archive) { archive(dense_, contacts_); }

    /// The flashes of a frame, a function of the frame alone.
    std::vector<Flash> at(const Tick& tick) const;

    /// A remark if some are omitted, in versions from longest to shortest; otherwise empty.
    std::vector<std::string> remarks() const;

  private:
    struct Start {
        double seconds;  ///< of film
        double folded;   ///< simulated time, counted backwards after a reversal
        std::pair<std::int32_t, std::int32_t> pair;
        Vec place;
        void archive(auto& archive) { archive(seconds, folded, pair, place); }
    };

    /// A selection of contacts that flash: as many as the limit allows, at least `gap` apart in
    /// time.
    struct Choice {
        double gap;  ///< seconds of film
        std::vector<Start> starts;
        void archive(auto& archive) { archive(gap, starts); }
    };

    bool is_free(const Choice& choice, double seconds) const;
    bool is_seen_again(const Choice& choice, const Start& start, double nearest) const;

    PanelContext context_;
    bool asked_;
    double life_;  ///< duration of a flash, in seconds of film
    Choice dense_, even_;
    std::int64_t contacts_ = 0;
    int leg_ = 0;
    double low_ = 0.0, high_ = 0.0;          ///< range of folded times of the legs before this one
    double leg_low_ = 0.0, leg_high_ = 0.0;  ///< the same with this leg included
    double last_time_ = 0.0;
    int last_frame_ = 0;
};

/// Draws a ring that grows and fades around the place, with a spark in its middle.
void draw_flash(Canvas& canvas, const DrawContext& dc, Point at, double share);

/// The largest radius of the ring, in units.
constexpr double flash_reach = 1.8;

}  // namespace carom
