#include "app/report/accessibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "panels/layout.h"
#include "physics/placement/draws.h"
#include "scene/describe.h"
#include "scene/time/timeline.h"
#include "util/text.h"

namespace carom {
namespace {

// Of letters, where a film is shown with as many pixels as it has.
constexpr double least_pixels = 12.0;

// Without a way to stop it (2.2.2).
constexpr double most_seconds_of_motion = 5.0;

// In any second (2.3.1), and the share of a part of the view that must flash together.
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

// What stands for a film where none is seen.
std::optional<Diagnostic> missing_description(const Scene& scene) {
    if (scene.description != describe(scene)) return std::nullopt;
    return barrier(whole_file(scene),
                   "WCAG 1.1.1, 1.2.1: the scene has no `description`; the words that carom makes "
                   "say what is there, not what there is to see",
                   "say in a sentence or two what happens and what it shows");
}

// Whether two species look different in grey.
bool differ_without_color(const Scene& scene, const std::vector<double>& radius, std::size_t i,
                          std::size_t k) {
    const SpeciesLook &one = scene.looks[i], &other = scene.looks[k];
    constexpr double ratio = 1.25;
    const double larger = std::max(radius[i], radius[k]), smaller = std::min(radius[i], radius[k]);
    return one.label != other.label || one.fill != other.fill || one.trail != other.trail ||
           larger >= ratio * smaller;
}

std::vector<double> mean_radii(const Scene& scene, const Particles& particles) {
    std::vector<double> sum(scene.gas.species.size(), 0.0);
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        sum[static_cast<std::size_t>(particles.species[i])] += particles.radius[i];
    for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] /= static_cast<double>(std::max<std::int64_t>(1, scene.gas.species[k].count));
    return sum;
}

std::vector<Diagnostic> told_by_color_alone(const Scene& scene, const Particles& particles) {
    std::vector<Diagnostic> found;
    if (scene.film.color_by != ColorBy::species || scene.film.theme == ThemeName::print)
        return found;
    const std::vector<double> radius = mean_radii(scene, particles);
    for (std::size_t k = 1; k < scene.looks.size(); ++k)
        for (std::size_t i = 0; i < k; ++i)
            if (!differ_without_color(scene, radius, i, k)) {
                found.push_back(
                    barrier(scene.species_spans[k],
                            fmt::format("WCAG 1.4.1: `{}` and `{}` are told apart by colour alone",
                                        printable(scene.gas.species[i].name),
                                        printable(scene.gas.species[k].name)),
                            "give one a `label`, or draw it as rings with `fill: false`"));
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
    const double pixels = Grid(scene.film.layout, size).unit();
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

// Simulated time in a second of film, where it is fastest.
double fastest_pace(const Scene& scene) {
    double step = 0.0, before = 0.0;
    for (const Tick& tick : timeline(scene)) {
        step = std::max(step, std::abs(tick.time - before));
        before = tick.time;
    }
    return step * scene.film.fps;
}

// A disk that comes and goes makes a place bright and dark. As many as cover more than a quarter of
// a part of the view can do so together.
std::optional<Diagnostic> flashing(const Scene& scene, const Particles& particles,
                                   const Sample& sample) {
    const Box& box = scene.gas.box;
    if (box.dimension != 2 || particles.count() == 0) return std::nullopt;
    const double area = box.size.prod();
    const double covered = std::numbers::pi * particles.radius.square().sum() / area;
    if (covered <= share_that_flashes) return std::nullopt;
    const Eigen::ArrayXd energy = kinetic_energies(particles, sample);
    double energies = 0.0, moving = 0.0;
    for (Eigen::Index i = 0; i < particles.count(); ++i)
        if (particles.inverse_mass[i] > 0.0) energies += energy[i], moving += 1.0;
    // Each as fast as it is at the start, or in equilibrium, if that is more.
    const Eigen::ArrayXd later =
        (2.0 * energies / std::max(1.0, moving) * particles.inverse_mass).sqrt();
    const double coverings = (2.0 * particles.radius * speeds(sample).max(later)).sum() / area;
    const double flashes = coverings * fastest_pace(scene);
    if (flashes <= most_flashes) return std::nullopt;
    return barrier(
        whole_file(scene),
        fmt::format("WCAG 2.3.1: disks cover {:.2g} of the box and come past each place about "
                    "{:.2g} times in a second of film; more than {:.0f} flashes of a quarter of "
                    "the view cannot be ruled out",
                    covered, flashes, most_flashes),
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
