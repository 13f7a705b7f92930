// Marks: where all particles were at some moment, kept on the screen as outlines under them, with a
// word that comes with the mark and at the end of the film. A later mark replaces the one before.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

/// What a mark has stamped.
struct Ghosts {
    std::string words;
    int frame = 0;          ///< the first with the mark
    Eigen::ArrayXXf place;  ///< of all particles, a column for each axis
    void archive(auto& archive) { archive(words, frame, place); }
};

/// The marks of a scene as its frames pass.
class GhostKeeper {
  public:
    explicit GhostKeeper(const Scene& scene) : scene_(scene) {}

    /// Second pass, every frame in order: a mark is stamped in the first frame at its time or after
    /// it, with the places given (a column for each axis).
    void see(const Tick& tick, const Eigen::ArrayXXd& places);

    /// The ghosts of the present frame; null before the first mark.
    const std::shared_ptr<const Ghosts>& present() const { return present_; }

    /// How much of their words is seen, from 0 to 1.
    double words_alpha(const Tick& tick) const;

    /// Writes or reads which mark is the present one, and what it has stamped.
    void archive(auto& archive) { archive(next_, present_); }

  private:
    const Scene& scene_;
    std::size_t next_ = 0;
    std::shared_ptr<const Ghosts> present_;
};

/// Their words with an outline before them, on a baseline from `left` on that is as wide as the
/// box.
void draw_ghost_words(Canvas& canvas, const DrawContext& dc, Point left, double width,
                      const Ghosts& ghosts, double alpha);

/// The line of an outline, in pixels.
double ghost_line(const DrawContext& dc);

}  // namespace carom
