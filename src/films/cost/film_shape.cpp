#include "films/cost/film_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "util/diagnostics.h"

namespace carom {
namespace {

// Smaller text cannot be read, and slower motion is not seen as motion.
constexpr std::array heights{1440, 1080, 900, 720, 600, 540, 480, 420, 360, 300, 240};
constexpr std::array rates{50, 30, 25, 20, 15, 12, 10};

struct Candidate {
    FilmShape shape;
    double loss = 0.0;  ///< number of halvings, of size and of rate together
    bool is_measured = false;
};

// Width and height are rounded to even numbers, as video formats require.
PictureSize scaled(const PictureSize& size, double factor) {
    const auto even = [&](int length) {
        return std::max(2, 2 * static_cast<int>(std::lround(0.5 * factor * length)));
    };
    return {even(size.width), even(size.height)};
}

// The value asked for, and all smaller steps of the ladder.
template <class Ladder>
std::vector<int> steps(int asked, const Ladder& ladder) {
    std::vector<int> found{asked};
    std::ranges::copy_if(ladder, std::back_inserter(found), [&](int one) { return one < asked; });
    return found;
}

// Sorted by loss; the first is the shape that was asked for.
std::vector<Candidate> candidates_of(const FilmShape& asked) {
    std::vector<Candidate> found;
    const int shorter = std::min(asked.size.width, asked.size.height);
    for (const int height : steps(shorter, heights))
        for (const int fps : steps(asked.fps, rates)) {
            const double factor = static_cast<double>(height) / shorter;
            found.push_back({{height == shorter ? asked.size : scaled(asked.size, factor), fps},
                             std::log2(static_cast<double>(asked.fps) / fps) - std::log2(factor)});
        }
    std::ranges::stable_sort(found, {}, &Candidate::loss);
    return found;
}

// The bytes to expect in a shape, extrapolated from those measured in another.
double expected(const FilmShape& shape, const FilmShape& measured, double bytes,
                const FormatCost& cost) {
    const auto pixels = [](const FilmShape& one) {
        return static_cast<double>(one.size.width) * one.size.height;
    };
    return bytes * std::pow(pixels(shape) / pixels(measured), cost.power_of_pixels) * shape.fps /
           measured.fps;
}

}  // namespace

std::optional<FilmShape> fitting_shape(const FilmShape& asked, const FormatCost& cost, double most,
                                       const std::function<double(const FilmShape&)>& measure) {
    constexpr double margin = 0.95;  // because only a sample of the frames is measured
    std::vector<Candidate> candidates = candidates_of(asked);
    std::optional<Candidate> best;
    Candidate* next = candidates.data();
    for (int k = 0; k < most_shapes_measured && next != nullptr; ++k) {
        next->is_measured = true;
        const FilmShape shape = next->shape;
        const double bytes = measure(shape);
        if (bytes <= margin * most) best = *next;
        const auto found = std::ranges::find_if(candidates, [&](const Candidate& one) {
            return !one.is_measured && !(best && one.loss >= best->loss) &&
                   expected(one.shape, shape, bytes, cost) <= margin * most;
        });
        next = found == candidates.end() ? nullptr : &*found;
        // The smallest shape is measured, although it is not expected to fit, before giving up.
        if (next == nullptr && !best && !candidates.back().is_measured) next = &candidates.back();
    }
    return best ? std::optional(best->shape) : std::nullopt;
}

double parsed_bytes(const std::string& option, const std::string& text) {
    static const std::vector<std::pair<std::string, double>> units{
        {"", 1},
        {"B", 1},
        {"kB", 1e3},
        {"KB", 1e3},
        {"MB", 1e6},
        {"GB", 1e9},
        {"KiB", 1024.0},
        {"MiB", 1024.0 * 1024.0},
        {"GiB", 1024.0 * 1024.0 * 1024.0}};
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    std::string unit(end, text.data() + text.size());
    unit.erase(0, unit.find_first_not_of(' '));
    const auto found = std::ranges::find(units, unit, &std::pair<std::string, double>::first);
    if (error != std::errc() || found == units.end() || !(number > 0.0) || !std::isfinite(number))
        throw UsageError(fmt::format("{} {}: expected a size above zero, for instance 5MB or 800kB",
                                     option, text));
    return number * found->second;
}

}  // namespace carom
