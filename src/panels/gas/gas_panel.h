// The box and its disks with their trails, velocities and names: the main picture of a film in the
// plane; in space the box and its spheres in perspective.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "panels/gas/drawn_radius.h"
#include "panels/gas/marks/seed_paths.h"
#include "panels/gas/marks/streaks.h"
#include "panels/gas/particle_panel.h"
#include "panels/surfaces/surface_view.h"

namespace carom {

class GasPanel : public ParticlePanel {
  public:
    explicit GasPanel(const PanelContext& context, const FixedView& fixed = {});

    void survey(const FrameInput& input) override;
    bool surveys_positions() const override {
        return camera_.moves() || callouts_.any() || field_.shown();
    }
    void fix_axes() override;
    void archive(Archive& archive) override;
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    void archive_progress(Archive& archive) override;
    void draw_ground(Canvas& canvas, const DrawContext& dc) const override;
    void draw(Canvas& canvas, const DrawContext& dc, const PanelState& state) const override;
    Table table(const PanelState& state, const Theme& theme) const override;

    /// Trails, streaks and fields need the collisions between frames.
    bool wants_collisions() const override {
        return !followed_.empty() || streaks_.shown() || field_.shown();
    }

    /// The box is as large as fits, at the top left of the area; in its middle if the layout has no
    /// places for panels.
    Rect frame_in(const Rect& area, double unit) const override;

    /// Describes the present state of the surfaces.
    std::string account(const PanelState& state) const override;

  private:
    struct Drawing;
    struct TrailedParticle {  // particle with a trail
        Eigen::Index particle;
        double trail_seconds;
    };
    struct TrailPoint {
        double film_time;  // seconds
        Vec place;         // scene units
        void archive(auto& archive) { archive(film_time, place); }
    };
    struct Trail {
        std::vector<Vec> places;  // oldest first, scene units
        std::vector<float> ages;  // seconds of film
    };
    struct State : ParticleState {
        double time = 0.0;                           // simulated
        std::shared_ptr<const DrawnRadii> radii;     // never null in a frame
        std::vector<Trail> trails;                   // one for each particle that is followed
        std::vector<SurfaceState> surfaces;          // of sides and partitions; none of a plain box
        std::shared_ptr<const StreakState> streaks;  // null: none
        std::size_t bytes() const override {
            std::size_t sum = ParticleState::bytes();
            for (const Trail& trail : trails)
                sum += trail.places.size() * (sizeof(Vec) + sizeof(float));
            if (streaks) sum += streaks->bytes();
            return sum + surfaces.size() * sizeof(SurfaceState);
        }
    };

    double scale_in(const DrawContext& own) const override;
    void choose_particles();
    void extend_trails(const FrameInput& input);
    bool stands_alone() const;
    BoxMap map_in(const DrawContext& own) const;
    BoxMap map_from(const DrawContext& own, const Viewpoint& from) const;
    BoxMap part_of(const BoxMap& whole, const CameraView& view) const;
    std::string label(Eigen::Index particle, const State& state) const;
    bool is_disk(Eigen::Index particle, const State& state) const {
        return !field_.shown() && !context_.is_laid_over() && is_filled(particle, state);
    }

    SurfaceView surfaces_;
    Streaks streaks_;
    std::shared_ptr<const DrawnRadii> radii_;  // at the last frame of the second pass
    std::vector<TrailedParticle> followed_;
    std::vector<std::ptrdiff_t> trail_of_;  // for each particle its trail, or -1; empty: no trails
    std::vector<std::deque<TrailPoint>> trails_;  // of the followed particles, at the last state
    std::vector<SeedPath> seed_paths_;            // of the followed particles in other runs
    double moving_seconds_ = 0.0;                 // film time without holds
    double last_time_ = 0.0;
};

}  // namespace carom
