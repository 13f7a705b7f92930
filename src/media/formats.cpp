#include "media/formats.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "media/gif_film.h"

namespace carom {
namespace {

// The costs in docs/encoding.md ("Rough costs"), of films of 300 frames with 200 and 1,000 disks.
// Up to 20,000 disks the times are right to a third; the bytes depend more on the speed of the
// particles. The memory is that of the slowest quality (docs/scaling.md).
constexpr double pixels_measured = 1920.0 * 1080.0;

constexpr PowerLaw milliseconds(double at_200, double at_1000) {
    return {1e-3 * at_200, 1e-3 * at_1000};
}
constexpr PowerLaw megabytes_of_300(double at_200, double at_1000) {
    return {1e6 / 300 * at_200, 1e6 / 300 * at_1000};
}

constexpr FormatCost mp4_cost{.core_seconds = milliseconds(9.3, 13.0),
                              .bytes = megabytes_of_300(2.62, 5.14),
                              .power_of_pixels = 0.5,
                              .memory_per_pixel = 48,
                              .seconds_by_quality = {.draft = 0.65, .final_ = 3.0},
                              .bytes_by_quality = {.draft = 2.2, .final_ = 1.4}};
constexpr FormatCost webm_cost{.core_seconds = milliseconds(23.8, 34.5),
                               .bytes = megabytes_of_300(3.69, 8.14),
                               .power_of_pixels = 0.5,
                               .memory_per_pixel = 100,
                               .seconds_by_quality = {.draft = 0.65, .final_ = 5.3},
                               .bytes_by_quality = {.draft = 0.8, .final_ = 1.0}};
constexpr FormatCost gif_cost{milliseconds(13.5, 17.2), megabytes_of_300(10.6, 20.4), 0.7, 30, 0.6};
constexpr FormatCost png_cost{milliseconds(62.2, 68.2), megabytes_of_300(73.5, 109), 0.8, 24};

// Rough costs for 200 and 1000 disks at 1080p: pages are drawn one by one, and only their memory
// counts.
constexpr FormatCost pdf_cost{.core_seconds = mp4_cost.core_seconds,
                              .bytes = {26e3, 50e3},
                              .power_of_pixels = 0,
                              .memory_per_pixel = 4};

template <class Use>
std::vector<std::string> names(Use use) {
    std::vector<std::string> found;
    for (const OutputFormat& format : output_formats())
        if (format.*use) found.push_back(format.name);
    return found;
}

}  // namespace

double PowerLaw::at(double disks) const {
    constexpr double few = 20.0;  // text and histograms cost the same with fewer disks
    const double power = std::log(at_1000 / at_200) / std::log(5.0);
    return at_200 * std::pow(std::max(few, disks) / 200.0, power);
}

double QualityFactors::at(Quality quality) const {
    if (quality == Quality::standard) return 1.0;
    return quality == Quality::draft ? draft : final_;
}

double FormatCost::frame_seconds(double disks, double pixels, Quality quality) const {
    return seconds_by_quality.at(quality) * core_seconds.at(disks) * pixels / pixels_measured;
}

double FormatCost::frame_bytes(double disks, double pixels, Quality quality) const {
    return bytes_by_quality.at(quality) * bytes.at(disks) *
           std::pow(pixels / pixels_measured, power_of_pixels);
}

double FormatCost::seconds_before(double pixels) const {
    return beforehand * pixels / pixels_measured;
}

const std::vector<OutputFormat>& output_formats() {
    static const std::vector<OutputFormat> formats{
        {.name = "mp4",
         .film = mp4_cost,
         .no_transparency = "MP4 cannot be transparent",
         .sound = {{"AAC", 12e3}},
         .make_film = mp4_film},
        {.name = "webm", .film = webm_cost, .sound = {{"Opus", 8e3}}, .make_film = webm_film},
        {.name = "gif",
         .film = gif_cost,
         .no_transparency = "a GIF has no partial transparency and would show ragged letters",
         .most_frames_per_second = most_gif_frames_per_second,
         .large_bytes = 10e6,
         .previews = 32,
         .make_film = gif_film},
        {.name = "svg", .stills = true, .figures = true, .vector = VectorFormat::svg},
        {.name = "pdf",
         .stills = true,
         .figures = true,
         .vector = VectorFormat::pdf,
         .film = pdf_cost,
         .in_one_piece = true,
         .make_film = pdf_film},
        {.name = "png",
         .stills = true,
         .figures = true,
         .film = png_cost,
         .make_film = folder_of_frames},
        {.name = "csv", .figures = true}};
    return formats;
}

const OutputFormat& output_format(const std::string& name) {
    const auto found = std::ranges::find(output_formats(), name, &OutputFormat::name);
    assert(found != output_formats().end());
    return *found;
}

std::string ending_of(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return ending;
}

const OutputFormat& format_of_film(const std::filesystem::path& path) {
    if (!path.has_filename()) return output_format("png");
    for (const OutputFormat& format : output_formats())
        if (format.film && ending_of(path) == "." + format.name) return format;
    return output_format("mp4");
}

std::unique_ptr<FilmWriter> film_writer(const std::filesystem::path& path,
                                        const VideoSettings& settings, int frames) {
    return format_of_film(path).make_film(path, settings, frames);
}

std::vector<std::string> film_formats() { return names(&OutputFormat::film); }

std::vector<std::string> chunk_formats() {
    std::vector<std::string> found = film_formats();
    std::erase_if(found, [](const std::string& name) { return output_format(name).in_one_piece; });
    return found;
}

std::vector<std::string> still_formats() { return names(&OutputFormat::stills); }

std::vector<std::string> figure_formats() { return names(&OutputFormat::figures); }

}  // namespace carom
