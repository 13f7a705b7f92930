// The box and the disks in it, their colours, trails and names: the picture a film is about.
#pragma once

#include <deque>
#include <vector>

#include "draw/palette.h"
#include "panels/panel.h"

namespace carom {

class GasPanel : public Panel {
  public:
    explicit GasPanel(const Cast& cast);

    void survey(const Observation& observation) override;
    void settle() override;
    std::shared_ptr<const PanelState> state(const Observation& observation) override;
    void draw_ground(Canvas& canvas, const Page& page) const override;
    void draw(Canvas& canvas, const Page& page, const PanelState& state) const override;

    /// Draws the colour bar, or the legend of species, into `page.area`.
    void draw_color_key(Canvas& canvas, const Page& page) const;

    /// Whether a trail needs the collisions on the way.
    bool wants_collisions() const { return !chosen_.empty(); }

    /// Where the box lies in `page.area`: as large as fits, at its top left.
    Rect box_on(const Rect& area) const;

  private:
    struct Chosen {
        Eigen::Index particle;
        double trail_seconds;
    };
    struct TrailPoint {
        double film_time;  ///< seconds
        Point place;       ///< scene units
    };

    void choose_particles();
    void extend_trails(const Observation& observation);
    std::uint8_t shade(const Observation& observation, Eigen::Index particle) const;
    std::vector<Color> shades(const Theme& theme) const;
    double color_value(const Observation& observation, Eigen::Index particle) const;
    void draw_disks(Canvas& canvas, const Page& page, const PanelState& state) const;
    void draw_trails(Canvas& canvas, const Page& page, const PanelState& state) const;
    void draw_chosen(Canvas& canvas, const Page& page, const PanelState& state) const;
    void draw_scale(Canvas& canvas, const Page& page) const;
    void draw_legend(Canvas& canvas, const Page& page) const;

    Cast cast_;
    std::vector<Chosen> chosen_;
    std::vector<std::deque<TrailPoint>>
        trails_;                   ///< one for each chosen particle, as of the last state
    double moving_seconds_ = 0.0;  ///< film time without holds
    double last_time_ = 0.0;
    std::vector<double> pool_;
    int surveyed_ = 0;
    double scale_top_ = 1.0;  ///< the value at the bright end of the colour scale
};

}  // namespace carom
