#include "works/build_facts.h"

#include <fmt/format.h>

#include <memory>
#include <string_view>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/text.h"
#include "physics/gas.h"
#include "physics/simulation.h"
#include "util/archive.h"
#include "util/fingerprint.h"
#include "works/source_fingerprint.h"

namespace carom {
namespace {

// The fingerprint of a run with sampled velocities, heat baths at sides and collisions of unequal
// disks, which uses those functions of the processor and of the mathematical library that runs
// depend on.
std::string fingerprint_of_physics() {
    Gas gas;
    gas.box.size = {10.0, 10.0};
    gas.box.surfaces.sides[0] = Bath{2.0};
    gas.species = {{.name = "",
                    .count = 40,
                    .radius = UniformDistribution{0.2, 0.4},
                    .mass = Density{1.0},
                    .velocity = Temperature{1.0}}};
    Run run;
    run.until = 10.0;
    Simulation simulation(gas, run);
    simulation.advance_to(run.until);
    Sample sample = simulation.sample();
    Archive archive;
    archive(sample.position, sample.velocity);
    return fingerprint(archive.finished());
}

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

BuildFacts physics_build_facts() {
    static const BuildFacts facts{{"carom", CAROM_VERSION},
                                  {"source", source_fingerprint},
                                  {"physics", fingerprint_of_physics()}};
    return facts;
}

BuildFacts film_build_facts(const OutputFormat& format) {
    BuildFacts facts = physics_build_facts();
    const Canvas picture = reference_picture();
    facts.emplace_back("pictures", fmt::format("{}, {}, {}", drawing_library(), text_library(),
                                               fingerprint_of(picture)));
    facts.emplace_back("encoder", fmt::format("{}, {}, {}", format.name, encoding_library(),
                                              fingerprint_of_film(format, picture)));
    return facts;
}

Json to_json(const BuildFacts& facts) {
    Json json = Json::object();
    for (const auto& [name, value] : facts) json[name] = value;
    return json;
}

std::string difference(const Json& one, const Json& other, const std::string& name_of_one,
                       const std::string& name_of_other) {
    const auto value = [](const Json& facts, const std::string& name) {
        const auto found = facts.find(name);
        return found == facts.end() ? std::string("nothing")
               : found->is_string() ? found->get<std::string>()
                                    : text_of(*found);
    };
    for (const auto& [name, unused] : one.items())
        if (value(one, name) != value(other, name))
            return fmt::format("{} differ: {} in {}, {} in {}", name, value(one, name), name_of_one,
                               value(other, name), name_of_other);
    return "";
}

}  // namespace carom
