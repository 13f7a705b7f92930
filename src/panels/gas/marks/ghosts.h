// Marks: the positions of all particles at some moment, kept on the screen as outlines under the
// particles. A label is shown for a while after the mark and at the end of the film. A later mark
// replaces an earlier one.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// The positions that a mark has recorded, with its label.
struct Ghosts {
    std::string words;
    int frame = 0;          ///< first frame with the mark
    Eigen::ArrayXXf place;  ///< of all particles, a column for each axis; NaN: absent
    void archive(auto& archive) { archive(words, frame, place); }
};

/// The marks of a scene as its frames pass.
class GhostKeeper {
  public:
    explicit GhostKeeper(const Scene& scene) : scene_(scene) {}

    /// Second pass, every frame in order: a mark records the given positions (a column for each
    /// axis; NaN of a particle that is absent) in the first frame at or after its time.
    void see(const Tick& tick, const Eigen::ArrayXXf& places);

    /// The ghosts of the present frame; null before the first mark.
    const std::shared_ptr<const Ghosts>& present() const { return present_; }

    /// The opacity of the label, from 0 to 1.
    double words_alpha(const Tick& tick) const;

    /// Writes or reads which mark is the present one, and the positions that it has recorded.
    void archive(auto& archive) { archive(next_, present_); }

  private:
    const Scene& scene_;
    std::size_t next_ = 0;
    std::shared_ptr<const Ghosts> present_;
};

/// Draws the label after a sample of an outline, on a baseline that begins at `left` and is `width`
/// long, as the box.
void draw_ghost_words(Canvas& canvas, const DrawContext& dc, Point left, double width,
                      const Ghosts& ghosts, double alpha);

/// The line width of an outline, in pixels.
double ghost_line(const DrawContext& dc);

}  // namespace carom
