// The part of the box that is shown: the camera moves from view to view and may follow particles.
// In space it also has a viewpoint, which may change. Its whole path is fixed in the first pass.
// Independent of the canvas.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "panels/chosen.h"
#include "panels/panel.h"
#include "scene/film.h"

namespace carom {

/// A part of the box, with the aspect ratio of the largest extent that the film shows.
struct CameraView {
    Vec middle = {};
    double width = 0.0;  ///< length

    void archive(auto& archive) { archive(middle, width); }
};

/// What a figure shows throughout, instead of what the film's camera shows.
struct FixedView {
    std::optional<View> view = {};
    std::optional<ViewpointChange> from = {};
};

class Camera {
  public:
    explicit Camera(const PanelContext& context, const FixedView& fixed = {});

    /// Whether anything but the whole box is ever seen.
    bool moves() const { return shows_parts_; }

    /// In space: viewpoints so close to each other that any that is used lies among them or between
    /// two of them; of a viewpoint that never changes, that one.
    std::vector<Viewpoint> viewpoints() const;

    /// First pass: survey() for every frame in order, then fix_way(). `whole_box` is the box at its
    /// largest extent.
    void survey(const FrameInput& input);
    void fix_way(const Region& whole_box);

    /// Second pass, every frame in order: returns the view of the next frame; none for the whole
    /// box. In a periodic box the middle of the view is wrapped into the box.
    std::optional<CameraView> next();

    /// The view of a frame by its number; 0 is the first frame that was surveyed.
    std::optional<CameraView> at(std::size_t frame) const;

    /// The viewpoints of these frames; to be asked for the next one before next().
    Viewpoint next_viewpoint() const { return viewpoint_at(next_); }
    Viewpoint viewpoint_at(std::size_t frame) const;

    void archive(auto& archive) { archive(way_, turned_); }

    /// Writes or reads the number of the next frame.
    void archive_progress(auto& archive) { archive(next_); }

  private:
    struct Frame {
        double time, seconds;
        std::vector<Vec> targets;  ///< of each move; 0 if it follows nothing
    };
    Vec target(std::size_t move, const FrameInput& input);
    CameraView view_of(std::size_t move, const Frame& frame, const Region& whole_box) const;
    bool turns() const { return viewpoint_.spin != 0.0 || changes_viewpoint_; }
    double spun_at(double seconds) const;
    Vec nearest_image(const Vec& of, const Vec& to) const;

    struct Turned {
        double turn, tilt, lens;
        void archive(auto& archive) { archive(turn, tilt, lens); }
    };

    PanelContext context_;
    FilmViewpoint viewpoint_;
    bool shows_parts_ = false, changes_viewpoint_ = false;
    std::vector<CameraMove> moves_;
    std::vector<Members> followed_;  ///< of each move; none if it follows nothing
    std::vector<Frame> frames_;      ///< of the first pass
    std::vector<CameraView> way_;    ///< of each frame; width 0: the whole box
    std::vector<Turned> turned_;     ///< of each frame; empty: the viewpoint never changes
    std::size_t next_ = 0;
};

/// The view between two views after the fraction `share` of the move. The width is interpolated
/// geometrically, and one point of the picture stays fixed.
CameraView between(const CameraView& from, const CameraView& to, double share);

/// The viewpoint after this share of the way to another.
Viewpoint between(const Viewpoint& from, const Viewpoint& to, double share);

}  // namespace carom
