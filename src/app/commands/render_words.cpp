#include "app/commands/render_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/pages/film_page.h"
#include "runs/run.h"
#include "scene/film.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

// Warns if a film is large for its format. A format that stores every change of every pixel soon
// exceeds what web pages and mail accept.
std::string warning(const OutputFormat& format, const RenderReport& report) {
    const auto bytes = static_cast<double>(report.bytes);
    if (format.large_bytes == 0.0 || bytes < format.large_bytes) return "";
    return fmt::format(
        "carom: {:.0f} MB is large for a {}; a smaller --size or --fps makes it "
        "smaller, and a .webm takes a third of it\n",
        1e-6 * bytes, upper_case(format.name));
}

std::string warning_of_page(const RenderReport& report) {
    if (static_cast<double>(report.bytes) < most_inlined_bytes) return "";
    return fmt::format(
        "carom: not all browsers play a film of {:.0f} MB from inside a page; --max-size {:.0f}MB "
        "makes it smaller\n",
        1e-6 * static_cast<double>(report.bytes), 1e-6 * most_inlined_bytes);
}

std::string warning_of_callouts(const std::vector<std::string>& never_shown) {
    if (never_shown.empty()) return "";
    return fmt::format("carom: no frame shows {} {}; `x` is beyond the axis of the panel\n",
                       never_shown.size() == 1 ? "the callout" : "the callouts",
                       printable(listed(never_shown)));
}

}  // namespace

std::string words_of(const RenderReport& report, const Film& film, const std::string& name,
                     const std::string& max_size) {
    std::string text = fmt::format(
        "{}: {}, {}, {:.1f} MB, {} between particles, made in {:.1f} s\n", printable(name),
        counted(report.frames, "frame"), clock_text(static_cast<double>(report.frames) / film.fps),
        1e-6 * static_cast<double>(report.bytes), counted(report.collisions.particle, "collision"),
        report.wall_seconds);
    if (!max_size.empty())
        text += fmt::format("  {} by {}, {} frames a second, for --max-size {}\n", film.size.width,
                            film.size.height, film.fps, max_size);
    return text;
}

std::string timings_of(const RenderReport& report) {
    std::string text;
    const auto row = [&](const char* stage, double seconds, const std::string& rate) {
        text += fmt::format("  {:<10} {:>8.2f} s CPU   {}\n", stage, seconds, rate);
    };
    const auto events = static_cast<double>(events_of(report.collisions));
    const double frames = report.frames;
    row("simulate", report.simulate_seconds,
        fmt::format("{:.3g} events/s in {}: {}",
                    events * static_cast<double>(report.passes.size()) / report.simulate_seconds,
                    counted(static_cast<int>(report.passes.size()), "run"),
                    fmt::join(report.passes, "; ")));
    row("draw", report.workers.draw,
        fmt::format("{:.2f} ms a frame", 1e3 * report.workers.draw / frames));
    row("encode", report.workers.encode,
        fmt::format("{:.2f} ms a frame, conversion included",
                    1e3 * report.workers.encode / frames));
    return text + fmt::format("  {:<10} {:>8.2f} s       {:.1f} frames/s\n", "wall",
                              report.wall_seconds, frames / report.wall_seconds);
}

std::string warning_of_silence(const OutputFormat& format) {
    return fmt::format(
        "carom: the film is silent, as {} has no sound; write a .mp4 or a .webm, or say "
        "--no-sound\n",
        upper_case(format.name));
}

std::string warning_of_cut(const std::vector<std::string>& cut) {
    if (cut.empty()) return "";
    return fmt::format("carom: no room for all of {}; write less, or choose another template\n",
                       printable(listed(cut)));
}

std::string warnings_of(const RenderReport& report, const OutputFormat& format, bool in_page) {
    return (report.lacks_sound ? warning_of_silence(format) : "") + warning(format, report) +
           (in_page ? warning_of_page(report) : "") + warning_of_cut(report.cut) +
           warning_of_callouts(report.never_shown);
}

std::string words_of(const SlidesReport& report, const std::string& page, std::size_t slides) {
    std::string text =
        fmt::format("{}: {}", printable(page), counted(static_cast<long long>(slides), "slide"));
    if (!report.removed.empty())
        text += fmt::format(", {} of other slides removed",
                            counted(static_cast<long long>(report.removed.size()), "file"));
    return text + "\n";
}

std::string warnings_of(const SlidesReport& report, const std::string& folder) {
    std::string text;
    if (!report.replaced.empty())
        text = fmt::format("carom: {}: replaced {}, not written by carom or changed since\n",
                           printable(folder), printable(listed(report.replaced)));
    if (!report.left.empty())
        text += fmt::format(
            "carom: {}: {} of slides that are there no longer; changed since, and left\n",
            printable(folder), printable(listed(report.left)));
    return text;
}

}  // namespace carom
