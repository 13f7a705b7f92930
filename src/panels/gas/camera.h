// What is seen of the box: the camera goes over from view to view, and may follow particles. Its
// whole way is fixed in the first pass. It never turns. Knows no canvas.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// A part of the box with the proportions of all that is ever seen of it.
struct CameraView {
    Eigen::Array2d middle{0.0, 0.0};
    double width = 0.0;  ///< length

    void archive(auto& archive) { archive(middle, width); }
};

class Camera {
  public:
    /// `fixed`: a view that holds throughout, instead of the film's moves.
    explicit Camera(const PanelContext& context, const std::optional<View>& fixed = {});

    /// Whether anything but the whole box is ever seen.
    bool moves() const { return !moves_.empty(); }

    /// First pass, every frame in order; then fix_way(), of a box that is `whole_box` at its
    /// largest.
    void survey(const FrameInput& input);
    void fix_way(const Region& whole_box);

    /// Second pass, every frame in order: what is seen; none: the whole box. In a periodic box its
    /// middle is inside of the box.
    std::optional<CameraView> next();

    /// The same for a frame by its number, from 0 for the first that was seen.
    std::optional<CameraView> at(std::size_t frame) const;

    void archive(auto& archive) { archive(way_); }

    /// Writes or reads how far it is on its way.
    void archive_progress(auto& archive) { archive(next_); }

  private:
    struct Frame {
        double time, seconds;
        std::vector<Eigen::Array2d> targets;  ///< of each move that follows something
    };
    Eigen::Array2d target(const View& view, const FrameInput& input) const;
    CameraView view_of(std::size_t move, const Frame& frame, const Region& whole_box) const;
    Eigen::Array2d nearest_image(const Eigen::Array2d& of, const Eigen::Array2d& to) const;

    PanelContext context_;
    std::vector<CameraMove> moves_;
    std::vector<Frame> frames_;    ///< of the first pass
    std::vector<CameraView> way_;  ///< of width 0: the whole box
    std::size_t next_ = 0;
};

/// The view on the way from one to another, of which this share has passed: widths by their ratio,
/// and all of the picture about one point that stands still.
CameraView between(const CameraView& from, const CameraView& to, double share);

}  // namespace carom
