#include "films/chunks/film_build_facts.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/text.h"
#include "util/archive.h"
#include "util/fingerprint.h"

namespace carom {
namespace {

Canvas reference_picture() {
    constexpr PixelSize size{320, 180};
    Canvas canvas(size);
    canvas.fill_all({1.0, 1.0, 1.0});
    draw_text(canvas, {10.0, 40.0}, "Gas 0123456789 <i>T</i> = √(2/3) ≤ π",
              {.size = 20.0, .color = {0.1, 0.2, 0.3}});
    canvas.stroke_line({5.5, 60.2}, {310.1, 171.7}, 1.3, {0.8, 0.1, 0.1});
    canvas.stroke_circle({200.0, 100.0}, 41.3, 2.1, {0.1, 0.5, 0.2});
    const std::vector<Disk> disks{{61.3f, 120.7f, 13.2f, 0x3366cc}, {97.8f, 99.1f, 7.9f, 0xcc6633}};
    DiskPainter().draw(canvas, disks, {0.0, 0.0, size.width, size.height});
    return canvas;
}

std::string fingerprint_of(const Canvas& picture) {
    const PixelView pixels = picture.pixels();
    std::string bytes;
    for (int y = 0; y < pixels.height; ++y)
        bytes.append(reinterpret_cast<const char*>(pixels.data + std::ptrdiff_t{y} * pixels.stride),
                     sizeof(std::uint32_t) * static_cast<std::size_t>(pixels.width));
    return fingerprint(bytes);
}

std::string fingerprint_of_film(const OutputFormat& format, const Canvas& picture) {
    const PixelSize size = picture.size();
    constexpr int frames = 3;
    const std::unique_ptr<FilmWriter> writer = format.make_film(
        {}, {.width = size.width, .height = size.height, .metadata = {}, .is_scratch = true},
        frames);
    std::vector<std::uint32_t> greys;
    for (std::uint32_t level = 0; level < 256; ++level)
        greys.push_back(0xff000000 | 0x10101 * level);
    if (format.previews > 0) writer->use_colors(greys);
    const std::unique_ptr<FilmSegment> segment = writer->segment(0);
    for (int i = 0; i < frames; ++i) segment->add(picture);
    segment->finish();
    Archive archive;
    segment->archive(archive);
    return fingerprint(archive.finished());
}

}  // namespace

BuildFacts film_build_facts(const OutputFormat& format) {
    BuildFacts facts = physics_build_facts();
    const Canvas picture = reference_picture();
    facts.emplace_back("pictures", fmt::format("{}, {}, {}", drawing_library(), text_library(),
                                               fingerprint_of(picture)));
    facts.emplace_back("encoder", fmt::format("{}, {}, {}", format.name, encoding_library(),
                                              fingerprint_of_film(format, picture)));
    return facts;
}

}  // namespace carom
