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

Viewpoint between(const Viewpoint& from, const Viewpoint& to, double share) {
    return {std::lerp(from.turn, to.turn, share), std::lerp(from.tilt, to.tilt, share),
            std::lerp(from.lens, to.lens, share)};
}

Camera::Camera(const PanelContext& context, const FixedView& fixed)
    : context_(context), viewpoint_(context.film().viewpoint), moves_(context.film().camera) {
    if (fixed.view) {
        // The viewpoint of the film at the time of the figure goes on.
        for (CameraMove& move : moves_) move.view = std::nullopt;
        moves_.insert(moves_.begin(), {0.0, *fixed.view, {}, 0.0});
    }
    if (fixed.from) {
        viewpoint_ = {fixed.from->applied_to(viewpoint_), 0.0};
        for (CameraMove& move : moves_) move.viewpoint = {};
    }
    for (const CameraMove& move : moves_) {
        const ViewpointChange& its = move.viewpoint;
        shows_parts_ |= move.view && !std::holds_alternative<WholeBox>(*move.view);
        changes_viewpoint_ |= its.turn || its.tilt || its.lens;
    }
    if (!shows_parts_ && !changes_viewpoint_) moves_.clear();
    for (const CameraMove& move : moves_) {
        const auto* followed = move.view ? std::get_if<Followed>(&*move.view) : nullptr;
        followed_.emplace_back(
            context, followed ? std::vector<Chosen>{followed->what} : std::vector<Chosen>{});
    }
}

// A film without motion turns at once.
double Camera::spun_at(double seconds) const {
    const Film& film = context_.film();
    const double all = film.seconds - card_seconds(film);
    return viewpoint_.spin * smooth(all > 0.0 ? std::clamp(seconds / all, 0.0, 1.0) : 1.0);
}

std::vector<Viewpoint> Camera::viewpoints() const {
    constexpr double apart = 5.0;  // degrees of turning, between which the box hardly grows
    constexpr int steps = 8;       // of a move
    std::vector<Viewpoint> stations{viewpoint_};
    for (const CameraMove& move : moves_)
        stations.push_back(move.viewpoint.applied_to(stations.back()));
    std::vector<Viewpoint> on_the_way{stations.front()};
    for (std::size_t k = 1; k < stations.size(); ++k)
        for (int step = 1; step <= steps; ++step)
            on_the_way.push_back(between(stations[k - 1], stations[k], double(step) / steps));
    if (viewpoint_.spin == 0.0) return on_the_way;
    const int turns = static_cast<int>(std::ceil(std::abs(viewpoint_.spin) / apart));
    std::vector<Viewpoint> all;
    for (Viewpoint at : on_the_way)
        for (int turn = 0; turn <= turns; ++turn) {
            Viewpoint turned = at;
            turned.turn += viewpoint_.spin * turn / turns;
            all.push_back(turned);
        }
    return all;
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
    if (!shows_parts_ && !turns()) return;
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
    const View& view = *moves_[move].view;
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
    std::vector<bool> began(moves_.size(), false);
    for (const Frame& frame : frames_) {
        CameraView now = whole;
        Viewpoint from = viewpoint_;
        for (std::size_t k = 0; k < moves_.size() && moves_[k].at <= frame.time; ++k) {
            if (!began[k]) {
                began[k] = true;
                begins[k] = &frame == &frames_.front() ? -1e9 : frame.seconds;
            }
            const double passed = frame.seconds - begins[k], takes = moves_[k].seconds;
            const double share = takes > 0.0 ? smooth(std::clamp(passed / takes, 0.0, 1.0)) : 1.0;
            from = between(from, moves_[k].viewpoint.applied_to(from), share);
            if (!moves_[k].view) continue;
            CameraView next = view_of(k, frame, whole_box);
            if (!shifts[k]) shifts[k] = nearest_image(next.middle, now.middle) - next.middle;
            next.middle += *shifts[k];
            now = between(now, next, share);
        }
        if (turns()) turned_.push_back({from.turn + spun_at(frame.seconds), from.tilt, from.lens});
        if (!shows_parts_) continue;
        const Vec off = nearest_image(now.middle, whole.middle) - whole.middle;
        const bool is_whole = now.width > (1.0 - 1e-9) * whole.width &&
                              longest(abs(off), context_.box().dimension) < 1e-9 * whole.width;
        way_.push_back(is_whole ? CameraView{} : now);
    }
    frames_ = {};
}

std::optional<CameraView> Camera::at(std::size_t frame) const {
    if (frame >= way_.size() || way_[frame].width <= 0.0) return std::nullopt;
    CameraView view = way_[frame];
    for (const int axis : {0, 1, 2})
        view.middle[axis] = context_.box().wrapped(axis, view.middle[axis]);
    return view;
}

Viewpoint Camera::viewpoint_at(std::size_t frame) const {
    if (turned_.empty()) return viewpoint_;
    const Turned& at = turned_[std::min(frame, turned_.size() - 1)];
    return {at.turn, at.tilt, at.lens};
}

// After the last frame, behind an end card, its view stays.
std::optional<CameraView> Camera::next() {
    const std::size_t last = way_.empty() ? 0 : way_.size() - 1;
    return at(std::min(next_++, last));
}

}  // namespace carom
