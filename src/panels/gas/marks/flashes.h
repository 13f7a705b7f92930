// Flashes: short marks where two particles touch, or one touches a surface that is more than an
// outer wall. Never more than three are seen in any second of film (WCAG 2.2, 2.3.1); those beyond
// are left out, by a rule that knows only the film's times.
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
    Point place;         ///< of the contact
    double share = 0.0;  ///< of its short life that has passed, from 0 to 1
};

/// The flashes of a film: chosen in the first pass, looked up in the second.
class Flashes {
  public:
    explicit Flashes(const PanelContext& context);

    bool asked() const { return asked_; }

    /// First pass, every frame in order; then fix_scale(). `place` says where a contact is drawn.
    void survey(const FrameInput& input, const std::function<Point(const Collision&)>& place);
    void fix_scale();

    void archive(auto& archive) { archive(dense_, contacts_); }

    /// Those of a frame, a function of the frame alone.
    std::vector<Flash> at(const Tick& tick) const;

    /// What to say where some are left out, from the longest on; else nothing.
    std::vector<std::string> remarks() const;

  private:
    struct Start {
        double seconds;  ///< of film
        double folded;   ///< simulated time, running back after a reversal
        std::pair<std::int32_t, std::int32_t> pair;
        Point place;
        void archive(auto& archive) { archive(seconds, folded, pair, place); }
    };

    /// Contacts that may flash together: as many as the limit allows, at least `gap` apart.
    struct Choice {
        double gap;  ///< seconds of film
        std::vector<Start> starts;
        void archive(auto& archive) { archive(gap, starts); }
    };

    bool is_free(const Choice& choice, double seconds) const;
    bool is_seen_again(const Choice& choice, const Start& start, double nearest) const;

    const Scene& scene_;
    bool asked_;
    double life_;  ///< of a flash, in seconds of film
    Choice dense_, even_;
    std::int64_t contacts_ = 0;
    int leg_ = 0;
    double low_ = 0.0, high_ = 0.0;          ///< folded times of the legs before this one
    double leg_low_ = 0.0, leg_high_ = 0.0;  ///< and with this one
    double last_time_ = 0.0;
    int last_frame_ = 0;
};

/// A ring that grows and fades about the place, and a spark in its middle.
void draw_flash(Canvas& canvas, const DrawContext& dc, Point at, double share);

/// The largest radius of the ring, in units.
constexpr double flash_reach = 1.8;

}  // namespace carom
