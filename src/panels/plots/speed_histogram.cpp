// The histogram of the speeds of particles, or of the part of their velocities along one axis or
// two, with the equilibrium distribution of this finite gas.
#include <cmath>

#include "panels/plots/histogram_panel.h"
#include "panels/registry.h"
#include "physics/theory/theory.h"
#include "scene/panel_kind.h"
#include "stats/paths/course.h"

namespace carom {
namespace {

Quantity speed_along(Component component) {
    switch (component) {
        case Component::x:
            return quantities::speed.named(Phrase{"speed along x"});
        case Component::y:
            return quantities::speed.named(Phrase{"speed along y"});
        case Component::z:
            return quantities::speed.named(Phrase{"speed along z"});
        case Component::xy:
            return quantities::speed.named(Phrase{"speed in the plane xy"});
        case Component::xz:
            return quantities::speed.named(Phrase{"speed in the plane xz"});
        case Component::yz:
            return quantities::speed.named(Phrase{"speed in the plane yz"});
        case Component::both:
            break;
    }
    return quantities::speed;
}

// The piece of a path with the motion along these axes alone.
PathPiece piece_along(const PathPiece& piece, const std::vector<int>& axes) {
    PathPiece part = piece;
    part.velocity = part.acceleration = {};
    for (const int axis : axes) {
        part.velocity[axis] = piece.velocity[axis];
        part.acceleration[axis] = piece.acceleration[axis];
    }
    return part;
}

void take_speed(const PathPiece& piece, const std::function<void(const Course&)>& take) {
    Course course = square_of_speed(piece, 1.0);
    course.is_root = true;
    take(course);
}

std::unique_ptr<Panel> make_speed_histogram(const PanelContext& context, const PanelSpec& spec) {
    const Component component = spec.component.value_or(Component::both);
    HistogramSubject subject{.title = Phrase{"Speed distribution"},
                             .quantity = speed_along(component),
                             .values = [](const FrameInput& o) { return values_in(o.speed); },
                             .courses = take_speed,
                             .density = speed_density,
                             .tested = TestedQuantity::speed,
                             .colored_by = ColorBy::speed};
    if (component != Component::both) {
        const std::vector<int> axes = axes_of(component, context.box().dimension);
        subject.axes = axes;
        subject.values = [axes, speeds = Eigen::ArrayXd()](const FrameInput& o) mutable {
            speeds = o.sample.velocity(Eigen::all, axes).square().rowwise().sum().sqrt();
            return values_in(speeds);
        };
        subject.courses = [axes](const PathPiece& piece, const auto& take) {
            take_speed(piece_along(piece, axes), take);
        };
        subject.colored_by = {};
    }
    return std::make_unique<HistogramPanel>(context, spec, std::move(subject));
}

}  // namespace

PanelKind speed_histogram_kind() {
    using enum Ability;
    return histogram_kind(
        {.name = "speed-histogram",
         .words = Phrase{"speed histogram"},
         .shows = "A histogram of the speeds, now or averaged over a time (`over`), with the "
                  "equilibrium distribution. With `component` it is that of the speed along an "
                  "axis or, in space, in a plane.",
         .make = make_speed_histogram,
         .abilities = {bars, of, over, component, both, two_axes, theory, equilibrium, means,
                       comparison, any_space}},
        quantities::speed, true);
}

}  // namespace carom
