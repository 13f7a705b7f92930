#include "app/check/accessibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/report/facts.h"
#include "panels/chosen.h"
#include "panels/gas/gas_colors.h"
#include "panels/layout.h"
#include "physics/placement/draws.h"
#include "scene/describe.h"
#include "scene/scene.h"
#include "scene/time/timeline.h"
#include "util/text.h"

namespace carom {
namespace {

// Least height of letters in a film that is shown at its own size.
constexpr double least_pixels = 12.0;

// Longest motion that viewers have no way to stop (success criterion 2.2.2).
constexpr double most_seconds_of_motion = 5.0;

// Most flashes in any second (2.3.1), and the share of a region of the view that must flash
// together to count.
constexpr double most_flashes = 3.0, share_that_flashes = 0.25;

Diagnostic barrier(Diagnostic place, std::string message, std::string hint) {
    place.message = std::move(message);
    place.hint = std::move(hint);
    return place;
}

Diagnostic whole_file(const Scene& scene) {
    Diagnostic place;
    place.span.file = scene.source.path;
    return place;
}

// The barrier that a scene has no description of its own as a text alternative.
std::optional<Diagnostic> missing_description(const Scene& scene) {
    if (scene.description != describe(scene)) return std::nullopt;
    return barrier(whole_file(scene),
                   "WCAG 1.1.1, 1.2.1: the scene has no `description`; the words that carom makes "
                   "say what is there, not what there is to see",
                   "say in a sentence or two what happens and what it shows");
}

// How a species looks in grey.
struct GreyLook {
    double radius = 0.0;  // the mean
    bool is_ring = false;
    bool is_followed = true;       // each of its particles has a trail or a rim
    std::optional<double> number;  // on each of its disks, where it is the same on all
};

// Approximate pixels per unit of length: there may be walls and arrows between the box and its
// slot.
double pixels_of_length(const Scene& scene) {
    const Rect place = Grid(scene.film).place(scene.film.layout.gas);
    const Vec& box = scene.gas.box.size;
    return std::min(place.width / box[0],
                    scene.gas.box.dimension == 1 ? INFINITY : place.height / box[1]);
}

std::vector<GreyLook> grey_looks(const Scene& scene, const Particles& particles) {
    std::vector<GreyLook> all(scene.gas.species.size());
    const double unit = Grid(scene.film).unit();
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        GreyLook& its = all[static_cast<std::size_t>(particles.species[i])];
        if (scene.film.labels == Labels::mass) its.number = particles.inverse_mass[i];
        if (scene.film.labels == Labels::index) its.number = static_cast<double>(i);
        its.radius += particles.radius[i];
        const std::optional<double> trail = asked_trail(scene, particles, i);
        its.is_followed &= trail ? *trail > 0.0 : is_single_among_many(scene, particles, i);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto count =
            static_cast<double>(std::max<std::int64_t>(1, scene.gas.species[k].count));
        all[k].radius /= count;
        const double shown = all[k].radius * pixels_of_length(scene);
        const bool has_room = scene.gas.box.dimension == 1 || shown > 2.0 * ring_line(shown, unit);
        all[k].is_ring = !scene.looks[k].fill && has_room;
        // Smaller disks have no room for a number, and in a species of several particles the
        // numbers differ.
        if (count > 1.0 || (scene.gas.box.dimension > 1 && shown < unit)) all[k].number.reset();
    }
    return all;
}

bool differ(const GreyLook& one, const GreyLook& other) {
    constexpr double ratio = 1.25;
    return one.is_ring != other.is_ring || one.is_followed != other.is_followed ||
           (one.number && other.number && *one.number != *other.number) ||
           std::max(one.radius, other.radius) >= ratio * std::min(one.radius, other.radius);
}

std::vector<Diagnostic> told_by_color_alone(const Scene& scene, const Particles& particles) {
    std::vector<Diagnostic> found;
    if (scene.film.theme == ThemeName::print) return found;
    const std::vector<GreyLook> looks = grey_looks(scene, particles);
    const auto is_colored = [&](std::size_t k) {
        return scene.film.color_by == ColorBy::species || scene.looks[k].color.has_value();
    };
    const auto are_told_apart = [&](std::size_t i, std::size_t k) {
        const std::optional<std::string>& color = scene.looks[k].color;
        return (is_colored(i) || is_colored(k)) && !(color && color == scene.looks[i].color);
    };
    for (std::size_t k = 1; k < looks.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            if (are_told_apart(i, k) && !differ(looks[i], looks[k])) {
                found.push_back(
                    barrier(scene.species_spans[k],
                            fmt::format("WCAG 1.4.1: `{}` and `{}` are told apart by colour alone",
                                        printable(scene.gas.species[i].name),
                                        printable(scene.gas.species[k].name)),
                            fmt::format("draw one of them as rings with `fill: false`, where {} "
                                        "are large enough for rings, or a quarter larger",
                                        word_for_bodies(scene.gas.box.dimension))));
                break;
            }
    return found;
}

std::optional<Diagnostic> unknown_ground(const Scene& scene) {
    if (!scene.film.transparent) return std::nullopt;
    return barrier(whole_file(scene),
                   "WCAG 1.4.3, 1.4.11: the ground is none, and the contrast is that with "
                   "whatever lies behind",
                   "leave out `ground: none`, or show it on a ground like that of the theme");
}

std::optional<Diagnostic> small_text(const Scene& scene) {
    const PictureSize& size = scene.film.size;
    const double pixels = Grid(scene.film).unit();
    if (pixels >= least_pixels) return std::nullopt;
    return barrier(
        whole_file(scene),
        fmt::format(
            "WCAG 1.4.4, 1.4.5: the smallest letters of a picture of {} by {} have {:.2g} pixels; "
            "expected {} or more",
            size.width, size.height, pixels, least_pixels),
        fmt::format("make the picture {:.2g} times as large (`film.size`, --size)",
                    std::ceil(10.0 * least_pixels / pixels) / 10.0));
}

std::optional<Diagnostic> motion_without_end(const Scene& scene, const OutputFormat* format) {
    if (format == nullptr || format->name != "gif" || scene.film.seconds <= most_seconds_of_motion)
        return std::nullopt;
    return barrier(whole_file(scene),
                   fmt::format("WCAG 2.2.2: a GIF of {:.3g} seconds moves without an end and "
                               "cannot be stopped",
                               scene.film.seconds),
                   fmt::format("write a .mp4 or .webm, which players stop, or make it {} seconds "
                               "long",
                               most_seconds_of_motion));
}

// The largest simulated time per second of film.
double fastest_pace(const Scene& scene) {
    double step = 0.0, before = 0.0;
    for (const Tick& tick : timeline(scene)) {
        step = std::max(step, std::abs(tick.time - before));
        before = tick.time;
    }
    return step * scene.film.fps;
}

// A disk that passes makes a place bright and dark. If disks cover more than a quarter of a region
// of the view, this may count as flashing. Spheres are seen as disks, which a picture shows with
// pi/4 of their speed on average, and which lie before each other: only what comes over the ground
// makes a place bright, and of places that spheres cover c times on average, independently of each
// other, exp(-c) show it.
std::optional<Diagnostic> flashing(const Scene& scene, const Particles& particles,
                                   const Sample& sample) {
    const Box& box = scene.gas.box;
    if (box.dimension == 1 || particles.count() == 0) return std::nullopt;
    const double area = box.size[0] * box.size[1];
    const double covered = std::numbers::pi * particles.radius.square().sum() / area;
    if (covered <= share_that_flashes) return std::nullopt;
    const Eigen::ArrayXd energy = kinetic_energies(particles, sample);
    double energies = 0.0, moving = 0.0;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (particles.inverse_mass[i] > 0.0) energies += energy[i], moving += 1.0;
    // The speed of each particle is taken as that at the start or in equilibrium, whichever is
    // greater.
    const Eigen::ArrayXd later =
        (2.0 * energies / std::max(1.0, moving) * particles.inverse_mass).sqrt();
    const double coverings = (2.0 * particles.radius * speeds(sample).max(later)).sum() / area;
    const double seen = box.dimension == 3 ? 0.25 * std::numbers::pi * std::exp(-covered) : 1.0;
    const double flashes = seen * coverings * fastest_pace(scene);
    if (flashes <= most_flashes) return std::nullopt;
    return barrier(
        whole_file(scene),
        fmt::format("WCAG 2.3.1: {} cover {:.2g} of the box and come past each place about "
                    "{:.2g} times in a second of film; more than {:.0f} flashes of a quarter of "
                    "the view cannot be ruled out",
                    word_for_bodies(box.dimension), covered, flashes, most_flashes),
        "make the film longer (`film.seconds`) or show it slower (`film.pace`)");
}

}  // namespace

std::vector<Diagnostic> barriers_in(const Scene& scene, const OutputFormat* format) {
    const auto [particles, sample] = draw_gas(scene.gas);
    std::vector<Diagnostic> found = told_by_color_alone(scene, particles);
    for (std::optional<Diagnostic>& one :
         std::vector{missing_description(scene), unknown_ground(scene), small_text(scene),
                     motion_without_end(scene, format), flashing(scene, particles, sample)})
        if (one) found.push_back(std::move(*one));
    std::ranges::stable_sort(found, {}, [](const Diagnostic& one) { return one.message; });
    return found;
}

}  // namespace carom
