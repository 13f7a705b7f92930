#include "films/chunks/film_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "films/chunks/chunk_file.h"
#include "films/chunks/film_build_facts.h"
#include "films/first_pass.h"
#include "media/formats.h"
#include "panels/words_left_out.h"
#include "scene/load.h"
#include "scene/time/timeline.h"
#include "sound/rate.h"
#include "util/archive.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/utf8_names.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr const char* plan_file = "film.plan";
constexpr const char* sound_file = "film.sound";

Json nullable(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

const char* name_of(Quality quality) {
    if (quality == Quality::draft) return "draft";
    return quality == Quality::standard ? "standard" : "final";
}

// Everything that determines a plan, for comparing plans: the "request" in plan.json.
Json request_of(const Scene& scene, const FilmOptions& options, const FilmDivision& division) {
    const OutputFormat& format = format_of_film(options.output);
    Json request{{"scene",
                  {{"path", utf8_of_name(scene.source.path)},
                   {"text", scene.source.text},
                   {"overrides", scene.source.overrides},
                   {"template", scene.source.template_text},
                   {"files", texts_to_json(scene.source.files)}}},
                 {"format", format.name},
                 {"quality", name_of(options.quality)},
                 {"from", nullable(options.from)},
                 {"to", nullable(options.to)},
                 {"chunks", division.chunks ? Json(*division.chunks) : Json()},
                 {"chunk_seconds", nullable(division.seconds)},
                 {"build", carom::to_json(film_build_facts(format))}};
    return request;
}

double pixels_of(const FilmPlan& plan) {
    return static_cast<double>(plan.scene.film.size.width) * plan.scene.film.size.height;
}

double disks_of(const FilmPlan& plan) { return static_cast<double>(plan.particles().count()); }

// Seconds on one core that a frame takes: measured for the simulation, from the table of formats
// for drawing and encoding.
double seconds_of_frame(const FilmPlan& plan, const FormatCost& cost, Quality quality,
                        double simulated) {
    return cost.frame_seconds(disks_of(plan), pixels_of(plan), quality) +
           (plan.runs.front().is_kept() ? 0.0 : simulated / std::max(1, plan.span.end));
}

struct Memory {
    std::int64_t bytes, bytes_per_thread;
};

// Upper estimates from measured peaks (docs/scaling.md), with some room for films in which all
// moves fast. A segment is in memory, encoded, while it is written.
Memory memory_of_chunk(const FilmPlan& plan, const PlannedChunk& chunk, const FormatCost& cost,
                       Quality quality, std::size_t start_bytes) {
    constexpr double of_program = 100e6, of_particle = 1500.0, of_start = 2.5;
    const double pixels = pixels_of(plan), disks = disks_of(plan);
    const double per_thread = cost.memory_per_pixel * pixels;
    const double encoded =
        cost.frame_bytes(disks, pixels, quality) * static_cast<double>(chunk.count());
    const double all = of_program + of_start * static_cast<double>(start_bytes) + 2.0 * encoded +
                       per_thread + of_particle * disks;
    return {static_cast<std::int64_t>(all), static_cast<std::int64_t>(per_thread)};
}

int chunks_wanted(const FilmDivision& division, int frames, double seconds_of_one) {
    constexpr int usual = 4;
    if (division.chunks) return *division.chunks;
    if (!division.seconds) return usual;
    return static_cast<int>(
        std::clamp(std::ceil(frames * seconds_of_one / *division.seconds), 1.0, double(frames)));
}

// The part of a plan that a chunk draws, without its runs.
FilmPlan without_runs(const FilmPlan& plan) {
    FilmPlan part;
    part.scene = plan.scene;
    part.starts = plan.starts;
    return part;
}

std::string name_of_start(int chunk) { return fmt::format("starts/{:04}.start", chunk); }

// The second pass over the run, without drawing: writes for each chunk the state that it begins
// with.
class StartWriter {
  public:
    StartWriter(FilmPlan& plan, const FormatCost& cost, Quality quality, PlanWriter& writer,
                Progress& progress)
        : plan_(plan),
          cost_(cost),
          quality_(quality),
          writer_(writer),
          progress_(progress),
          frames_(plan) {}

    /// Writes the starts of all chunks in order; sets their file names and memory.
    void write(std::vector<PlannedChunk>& chunks) {
        progress_.begin("writing the starts of chunks", static_cast<double>(plan_.span.end));
        for (PlannedChunk& chunk : chunks) {
            frames_.go_to(static_cast<std::size_t>(chunk.first),
                          [&](const FrameData&, const AdvanceResult&) { progress_.advance(); });
            write_start(chunk);
        }
        progress_.finish();
    }

    std::vector<std::string> cut_words() const {
        return words_without_room(frames_.panels(), plan_.ticks());
    }

  private:
    void write_start(PlannedChunk& chunk) {
        FilmPlan part = frames_.rest(without_runs(plan_), static_cast<std::size_t>(chunk.end));
        const std::string bytes = run_bytes(part);
        chunk.start = name_of_start(chunk.number);
        const Memory memory = memory_of_chunk(plan_, chunk, cost_, quality_, bytes.size());
        chunk.memory_bytes = memory.bytes;
        chunk.memory_bytes_per_thread = memory.bytes_per_thread;
        writer_.write(chunk.start, bytes);
    }

    FilmPlan& plan_;
    const FormatCost& cost_;
    Quality quality_;
    PlanWriter& writer_;
    Progress& progress_;
    FilmFrames frames_;
};

std::vector<PlannedChunk> chunks_of(const FilmPlan& plan, int wanted, double seconds_of_one) {
    const std::vector<std::size_t> starts = chunk_starts(plan.segments, wanted);
    std::vector<PlannedChunk> chunks;
    for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
        PlannedChunk chunk{.number = static_cast<int>(k) + 1,
                           .first = plan.span.first + plan.segments[starts[k]],
                           .end = plan.span.first + plan.segments[starts[k + 1]]};
        chunk.seconds = static_cast<double>(chunk.count()) * seconds_of_one;
        chunks.push_back(chunk);
    }
    return chunks;
}

Json facts_of(const FilmPlan& plan, const OutputFormat& format) {
    const Film& film = plan.scene.film;
    return {{"film",
             {{"format", format.name},
              {"frames", plan.frames()},
              {"fps", film.fps},
              {"size", {film.size.width, film.size.height}},
              {"particles", plan.particles().count()}}}};
}

// The segment starts of a chunk, counted like those of the plan.
std::vector<int> segments_of(const FilmPlan& plan, const PlannedChunk& chunk) {
    std::vector<int> segments;
    for (const int start : plan.segments)
        if (plan.span.first + start >= chunk.first && plan.span.first + start <= chunk.end)
            segments.push_back(start);
    return segments;
}

ChunkIdentity identity_of(const PlanFolder& folder, const FilmPlan& plan,
                          const PlannedChunk& chunk) {
    return {folder.fingerprint(), chunk.number,
            static_cast<int>(segments_of(plan, chunk).size()) - 1};
}

FilmPlan read_plan(const PlanFolder& folder, FilmOptions& options) {
    return read_shared(folder.read(plan_file), (folder.path() / plan_file).string(), options);
}

// The sound is stored in a file of its own, because chunks do not need it.
std::string sound_bytes(std::vector<std::int16_t>& samples) {
    Archive archive;
    archive(samples);
    return archive.finished();
}

std::vector<std::int16_t> read_sound(const PlanFolder& folder, const FilmPlan& plan) {
    Archive archive(folder.read(sound_file), (folder.path() / sound_file).string());
    std::vector<std::int16_t> samples;
    archive(samples);
    archive.expect_end();
    if (std::cmp_not_equal(samples.size(), samples_before(plan.frames(), plan.scene.film.fps)))
        archive.refuse("its length is not that of the film");
    return samples;
}

// The plan of the film that consists of one chunk only.
FilmPlan plan_of_chunk(const PlanFolder& folder, const FilmPlan& whole, const PlannedChunk& chunk) {
    FilmPlan plan = whole;
    const fs::path start = folder.path() / chunk.start;
    read_run(plan, folder.read(chunk.start), start.string());
    plan.segments = segments_of(whole, chunk);
    const std::vector<Tick>& ticks = plan.ticks();
    if (plan.segments.size() < 2 || whole.span.first + plan.segments.front() != chunk.first ||
        whole.span.first + plan.segments.back() != chunk.end || ticks.front().frame > chunk.first ||
        ticks.back().frame + 1 < chunk.end)
        throw SystemError(fmt::format("cannot read {}: it does not have the frames of chunk {}",
                                      start.string(), chunk.number));
    plan.span = {static_cast<int>(chunk.first), static_cast<int>(chunk.end)};
    return plan;
}

void join_chunks(const PlanFolder& folder, const FilmPlan& plan, FilmWriter& writer,
                 Progress& progress) {
    progress.begin("joining", static_cast<double>(plan.frames()));
    for (const PlannedChunk& chunk : folder.chunks()) {
        ChunkReader reader(folder.output(chunk), identity_of(folder, plan, chunk));
        const std::vector<int> segments = segments_of(plan, chunk);
        for (std::size_t k = 0; k + 1 < segments.size(); ++k) {
            throw_if_interrupted();
            const std::unique_ptr<FilmSegment> segment = writer.segment(segments[k]);
            reader.read(*segment);
            segment->join();
            progress.advance(segments[k + 1] - segments[k]);
        }
        reader.expect_end();
    }
    progress.finish();
}

fs::path poster_path(const fs::path& film) {
    const fs::path name = film.has_filename() ? film : film.parent_path();
    return name.parent_path() / (name.stem().string() + ".poster.png");
}

std::vector<std::uint8_t> poster_of(const PlanFolder& folder, const FilmPlan& whole,
                                    Progress& progress) {
    const double at = time_of_poster(whole.scene);
    const int frame = std::clamp(frame_nearest_to(whole.scene.film, timeline(whole.scene), at),
                                 whole.span.first, whole.span.end - 1);
    for (const PlannedChunk& chunk : folder.chunks())
        if (frame >= chunk.first && frame < chunk.end) {
            const FilmPlan plan = plan_of_chunk(folder, whole, chunk);
            return draw_still(plan, at, output_format("png"), progress).file();
        }
    throw std::logic_error("a frame that is in no chunk");
}

}  // namespace

std::vector<std::size_t> chunk_starts(const std::vector<int>& segments, int chunks) {
    const std::size_t count = segments.size() - 1;
    const std::size_t wanted = std::clamp<std::size_t>(static_cast<std::size_t>(chunks), 1, count);
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k <= wanted; ++k) starts.push_back(k * count / wanted);
    return starts;
}

FilmPlanReport plan_film(const Scene& scene, const FilmOptions& asked, const FilmDivision& division,
                         const fs::path& folder, bool force, Progress& progress) {
    const Stopwatch watch;
    const Json request = request_of(scene, asked, division);
    FilmPlanReport report;
    if (!force && is_planned(folder, request)) {
        const PlanFolder planned(folder);
        report.is_new = false;
        report.chunks = static_cast<int>(planned.chunks().size());
        report.frames = planned.read_contents(
            [](const Json& contents) { return whole_in<int>(contents.at("film").at("frames")); });
        return report;
    }
    FilmOptions options = asked;
    options.text = true;
    options.room.file = 0;  // a chunk of a large run begins with a state, which is smaller
    // Open the folder before the work, in case it cannot be written.
    std::optional<PlanWriter> writer;
    FilmPlan plan =
        prepare(scene, options, progress, [&](const FilmPlan&) { writer.emplace(folder); });
    const double simulated = watch.cpu();
    const OutputFormat& format = format_of_film(options.output);
    const double seconds = seconds_of_frame(plan, *format.film, options.quality, simulated);
    std::vector<PlannedChunk> chunks =
        chunks_of(plan, chunks_wanted(division, plan.frames(), seconds), seconds);
    StartWriter starts(plan, *format.film, options.quality, *writer, progress);
    starts.write(chunks);
    writer->write(plan_file, shared_bytes(plan, options));
    if (!plan.sound.empty()) writer->write(sound_file, sound_bytes(plan.sound));
    report.cut = starts.cut_words();  // called before commit(), because it draws, which may fail
    writer->commit({PlanKind::film, request, facts_of(plan, format)}, chunks);
    report.chunks = static_cast<int>(chunks.size());
    report.frames = plan.frames();
    report.passes = plan.passes;
    report.wall_seconds = watch.wall();
    return report;
}

bool render_chunk(const PlanFolder& folder, const PlannedChunk& chunk, const ChunkOptions& options,
                  Progress& progress) {
    if (!options.force && folder.is_done(chunk)) return false;
    const Stopwatch watch;
    const Json build = carom::to_json(film_build_facts(output_format(format_of_plan(folder))));
    if (!options.allow_mixed) folder.require_same_build(build);
    FilmOptions film;
    const FilmPlan whole = read_plan(folder, film);
    const FilmPlan plan = plan_of_chunk(folder, whole, chunk);
    film.take = [](const FilmWriter&) {};
    const std::unique_ptr<FilmWriter> encoder = film_writer(whole, film);
    if (!plan.colors.empty()) encoder->use_colors(plan.colors);
    ChunkWriter writer(folder.output(chunk), identity_of(folder, whole, chunk), *encoder);
    RenderReport report;
    draw_frames(plan, options.threads, writer, progress, report);
    throw_if_interrupted();
    writer.commit();
    folder.finish(chunk, build, watch.wall());
    return true;
}

RenderReport join_film(const PlanFolder& folder, const JoinOptions& asked, Progress& progress) {
    const Stopwatch watch;
    folder.require_all_done(asked.allow_mixed);
    FilmOptions options;
    const FilmPlan plan = read_plan(folder, options);
    options.output = asked.output;
    RenderReport report;
    report.path = asked.output;
    const std::unique_ptr<FilmWriter> writer = film_writer(plan, options);
    if (!plan.colors.empty()) writer->use_colors(plan.colors);
    const bool is_heard = has_sound(plan.scene, format_of_film(asked.output));
    if (is_heard) writer->add_sound(0, read_sound(folder, plan));
    join_chunks(folder, plan, *writer, progress);
    std::optional<AtomicFile> poster;
    if (asked.poster)
        poster.emplace(poster_path(asked.output)).write(poster_of(folder, plan, progress));
    commit_with_text(*writer, plan.text, files_wanted(asked.text, is_heard), asked.output,
                     poster ? &*poster : nullptr);
    report.frames = plan.frames();
    report.bytes = writer->bytes();
    report.wall_seconds = watch.wall();
    return report;
}

std::string format_of_plan(const PlanFolder& folder) {
    auto format = folder.read_contents(
        [](const Json& contents) { return contents.at("film").at("format").get<std::string>(); });
    const std::vector<std::string> formats = chunk_formats();
    if (std::ranges::find(formats, format) == formats.end())
        throw UsageError(fmt::format("{}: no film has the format of this plan; plan again",
                                     folder.path().string()));
    return format;
}

SceneSource source_of_plan(const PlanFolder& folder) {
    return folder.read_contents([](const Json& contents) {
        const Json& scene = contents.at("request").at("scene");
        return SceneSource{.path = name_of_utf8(scene.at("path").get<std::string>()),
                           .text = scene.at("text"),
                           .template_text = scene.at("template"),
                           .overrides = scene.at("overrides"),
                           .files = texts_from(scene.at("files"))};
    });
}

FilmOptions options_of_plan(const PlanFolder& folder) {
    return folder.read_contents([](const Json& contents) {
        const Json& request = contents.at("request");
        FilmOptions options;
        for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_})
            if (request.at("quality") == name_of(quality)) options.quality = quality;
        for (const auto& [name, time] : {std::pair{"from", &options.from}, {"to", &options.to}})
            if (!request.at(name).is_null()) *time = request.at(name).get<double>();
        return options;
    });
}

std::string scene_of_plan(const PlanFolder& folder) {
    const std::string path = folder.read_contents([](const Json& contents) {
        return name_of_utf8(contents.at("request").at("scene").at("path").get<std::string>());
    });
    return path == "<stdin>" ? std::string(standard_input) : path;  // as load_scene() calls it
}

}  // namespace carom
