#include "panels/gas/camera.h"

#include <algorithm>
#include <cmath>

#include "scene/film.h"

namespace carom {
namespace {

CameraView whole_of(const Region& box) {
    return {0.5 * (box.low + box.high), box.high[0] - box.low[0]};
}

}  // namespace

CameraView between(const CameraView& from, const CameraView& to, double share) {
    if (share <= 0.0) return from;
    if (share >= 1.0) return to;
    const double width = from.width * std::pow(to.width / from.width, share);
    const double turned = std::abs(to.width / from.width - 1.0) > 1e-6
                              ? (from.width - width) / (from.width - to.width)
                              : share;
    return {from.middle + turned * (to.middle - from.middle), width};
}

Camera::Camera(const PanelContext& context, const std::optional<View>& fixed)
    : context_(context), moves_(context.film().camera) {
    if (fixed) moves_ = {{0.0, *fixed, 0.0}};
    const bool all_whole = std::ranges::all_of(
        moves_, [](const CameraMove& move) { return std::holds_alternative<WholeBox>(move.view); });
    if (all_whole) moves_.clear();
    for (const CameraMove& move : moves_) {
        const auto* followed = std::get_if<Followed>(&move.view);
        followed_.emplace_back(
            context, followed ? std::vector<Chosen>{followed->what} : std::vector<Chosen>{});
    }
}

Vec Camera::nearest_image(const Vec& of, const Vec& to) const {
    return to + context_.box().nearest(of - to);
}

// The position of what a view follows: a particle, or the centre of mass of several. Where none is
// left, it stays where the last were.
Vec Camera::target(std::size_t move, const FrameInput& input) {
    Vec sum;
    const auto& lists = followed_[move].at(input.sample);
    if (lists.empty()) return sum;
    const std::vector<Eigen::Index>& its = lists.front();
    if (its.empty()) return frames_.empty() ? sum : frames_.back().targets[move];
    const Eigen::ArrayXd& inverse_mass = context_.particles.inverse_mass;
    const bool weighs = its.size() > 1 && std::ranges::all_of(its, [&](Eigen::Index i) {
                            return inverse_mass[i] > 0.0;
                        });
    double mass = 0.0;
    for (const Eigen::Index i : its) {
        const double one = weighs ? 1.0 / inverse_mass[i] : 1.0;
        sum += one * vec_in(input.sample.position, i);
        mass += one;
    }
    return sum / mass;
}

// A target continues across periodic sides without a jump.
void Camera::survey(const FrameInput& input) {
    if (!moves()) return;
    Frame frame{input.tick.time, input.tick.seconds, {}};
    for (std::size_t k = 0; k < moves_.size(); ++k) {
        const Vec now = target(k, input);
        frame.targets.push_back(frames_.empty() ? now
                                                : nearest_image(now, frames_.back().targets[k]));
    }
    frames_.push_back(std::move(frame));
}

// A region is widened to the aspect ratio of the box; its middle and its width are limited to the
// largest extent of the box.
CameraView Camera::view_of(std::size_t move, const Frame& frame, const Region& whole_box) const {
    const View& view = moves_[move].view;
    const Vec all = whole_box.high - whole_box.low;
    if (const auto* followed = std::get_if<Followed>(&view))
        return {frame.targets[move], std::min(followed->width, all[0])};
    const auto* region = std::get_if<Region>(&view);
    if (region == nullptr) return whole_of(whole_box);
    const Vec size = region->high - region->low;
    const bool is_line = context_.box().dimension == 1;
    const double width = is_line ? size[0] : std::max(size[0], size[1] * all[0] / all[1]);
    const Vec middle = 0.5 * (region->low + region->high);
    return {lower(upper(middle, whole_box.low), whole_box.high), std::min(width, all[0])};
}

// Every move starts from the current view, which may itself follow something meanwhile. In a
// periodic box it goes to the image of its target that is nearest at its start.
void Camera::fix_way(const Region& whole_box) {
    const CameraView whole = whole_of(whole_box);
    std::vector<std::optional<Vec>> shifts(moves_.size());
    std::vector<double> begins(moves_.size(), 0.0);
    for (const Frame& frame : frames_) {
        CameraView now = whole;
        for (std::size_t k = 0; k < moves_.size() && moves_[k].at <= frame.time; ++k) {
            CameraView next = view_of(k, frame, whole_box);
            if (!shifts[k]) {
                shifts[k] = nearest_image(next.middle, now.middle) - next.middle;
                begins[k] = &frame == &frames_.front() ? -1e9 : frame.seconds;
            }
            next.middle += *shifts[k];
            const double passed = frame.seconds - begins[k], takes = moves_[k].seconds;
            now = between(now, next,
                          takes > 0.0 ? smooth(std::clamp(passed / takes, 0.0, 1.0)) : 1.0);
        }
        const Vec off = nearest_image(now.middle, whole.middle) - whole.middle;
        const bool is_whole =
            now.width > (1.0 - 1e-9) * whole.width && longest(abs(off), 2) < 1e-9 * whole.width;
        way_.push_back(is_whole ? CameraView{} : now);
    }
    frames_ = {};
}

std::optional<CameraView> Camera::at(std::size_t frame) const {
    if (frame >= way_.size() || way_[frame].width <= 0.0) return std::nullopt;
    CameraView view = way_[frame];
    for (const int axis : {0, 1})
        view.middle[axis] = context_.box().wrapped(axis, view.middle[axis]);
    return view;
}

// After the last frame, behind an end card, its view stays.
std::optional<CameraView> Camera::next() {
    const std::size_t last = way_.empty() ? 0 : way_.size() - 1;
    return at(std::min(next_++, last));
}

}  // namespace carom
