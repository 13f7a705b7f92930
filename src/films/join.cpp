#include "films/join.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/text.h"
#include "films/first_pass.h"
#include "panels/layout.h"
#include "scene/time/timeline.h"
#include "sound/rate.h"
#include "util/interrupt.h"
#include "util/stopwatch.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double fade_seconds = 0.3;  // at the end of a film, and at the beginning of the next
constexpr double title_seconds = 4.0;

// Fades the frames of a segment at the ends of its part by drawing the background over them.
class FadingSegment : public FilmSegment {
  public:
    FadingSegment(std::unique_ptr<FilmSegment> inner, const JoinedPart& part, int first)
        : inner_(std::move(inner)), part_(part), next_(first) {}

    void add(const Canvas& frame) override {
        const double cover = cover_of(part_, next_);
        const bool is_begin = 2 * next_++ < part_.frames;
        if (cover <= 0.0) return inner_->add(frame);
        Canvas covered = FramePainter::blank(part_.film);
        covered.restore(frame);
        covered.fill_all(with_alpha(is_begin ? part_.before : part_.ground, cover));
        inner_->add(covered);
    }
    void finish() override { inner_->finish(); }
    void archive(Archive& archive) override { inner_->archive(archive); }
    void join() override { inner_->join(); }

  private:
    std::unique_ptr<FilmSegment> inner_;
    const JoinedPart& part_;
    int next_;
};

class PartWriter : public FilmWriter {
  public:
    PartWriter(FilmWriter& whole, JoinedPart part) : whole_(whole), part_(std::move(part)) {}
    void add_sound(std::int64_t first, std::span<const std::int16_t> samples) override {
        whole_.add_sound(samples_before(part_.first, part_.film.fps) + first, samples);
    }
    std::unique_ptr<FilmSegment> segment(int first) override {
        return std::make_unique<FadingSegment>(whole_.segment(part_.first + first), part_, first);
    }
    void settle() override {}
    void commit() override {}
    std::string name() const override { return whole_.name(); }
    std::int64_t bytes() const override { return 0; }

  private:
    FilmWriter& whole_;
    JoinedPart part_;
};

// The title card as a part, in the style of the first film.
JoinedPart title_part(const Film& film) {
    const int frames = static_cast<int>(std::lround(title_seconds * film.fps));
    return {.frames = frames,
            .fading = std::min(static_cast<int>(std::lround(fade_seconds * film.fps)), frames / 2),
            .comes_in = false,
            .ground = page_color(film),
            .film = film};
}

// The parts of the scenes, beginning at frame `first`.
std::vector<JoinedPart> parts_of(const std::vector<Scene>& scenes, int first) {
    std::vector<JoinedPart> parts;
    const bool has_title = first > 0;
    for (const Scene& scene : scenes) {
        const Film& film = scene.film;
        const int frames = frame_count(film);
        const int fading = static_cast<int>(std::lround(fade_seconds * film.fps));
        parts.push_back({.first = first,
                         .frames = frames,
                         .fading = std::min(fading, frames / 2),
                         .comes_in = has_title || !parts.empty(),
                         .goes_out = parts.size() + 1 < scenes.size(),
                         .before = parts.empty() ? page_color(film) : parts.back().ground,
                         .ground = page_color(film),
                         .film = film});
        first += frames;
    }
    return parts;
}

// Appends a text file. The first line, which says what the file is, is kept only once.
void append(std::string& all, const std::string& more) {
    all += all.empty() ? more : more.substr(more.find('\n') + 1);
}

// The beginning of the transcript: what the joined film is.
std::string transcript_head(const std::vector<Scene>& scenes, const JoinedTitle& title,
                            const std::vector<JoinedPart>& parts, const OutputFormat& format) {
    const JoinedPart& last = parts.back();
    const double seconds = double(last.first + last.frames) / last.film.fps;
    std::string text;
    if (!title.title.empty()) text = title.title + "\n\n";
    if (!title.words.empty()) text += title.words + "\n\n";
    const bool is_heard =
        std::ranges::any_of(scenes, [&](const Scene& scene) { return has_sound(scene, format); });
    const Language language = scenes.front().film.language;
    text += (is_heard ? say(language, "A film of {} with sound, in {} parts:", clock_text(seconds),
                            parts.size())
                      : say(language, "A silent film of {}, in {} parts:", clock_text(seconds),
                            parts.size())) +
            "\n";
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += fmt::format("\n{}  {}", clock_text(double(parts[i].first) / last.film.fps),
                            scenes[i].title);
    return text + "\n";
}

void append(FilmText& all, const FilmText& more) {
    append(all.captions, more.captions);
    append(all.descriptions, more.descriptions);
    all.transcript += (all.transcript.empty() ? "" : "\n\n") + more.transcript;
}

// One chapter for each scene. The title card belongs to the first chapter.
std::vector<FilmChapter> chapters_of(const std::vector<Scene>& scenes,
                                     const std::vector<JoinedPart>& parts) {
    std::vector<FilmChapter> chapters;
    for (std::size_t i = 0; i < parts.size(); ++i)
        chapters.push_back(
            {i == 0 ? 0 : parts[i].first, parts[i].first + parts[i].frames, scenes[i].title});
    return chapters;
}

std::string webvtt_of(const std::vector<FilmChapter>& chapters, double fps) {
    std::vector<Cue> cues;
    for (const FilmChapter& chapter : chapters)
        cues.push_back({chapter.first / fps, chapter.end / fps, chapter.title});
    return webvtt(cues);
}

// A plan of `frames` frames with what all parts have in common.
FilmPlan plan_of_all(const std::vector<Scene>& scenes, int frames) {
    FilmPlan all;
    all.scene.film = scenes.front().film;
    for (const Scene& scene : scenes) {
        if (scene.film.sound) all.scene.film.sound = scene.film.sound;
        if (!scene.film.has_recipe) all.scene.film.has_recipe = false;
    }
    all.span = {0, frames};
    all.starts.emplace_back();
    return all;
}

// A writer for a film of all parts; its metadata contain all that is needed to make it again,
// unless one of the scenes keeps that to itself.
std::unique_ptr<FilmWriter> writer_of_all(const std::vector<Scene>& scenes,
                                          const JoinedTitle& title, const FilmOptions& options,
                                          const std::vector<JoinedPart>& parts) {
    std::vector<std::string> titles;
    FilmPlan all = plan_of_all(scenes, parts.back().first + parts.back().frames);
    for (const Scene& scene : scenes) {
        titles.push_back(scene.title);
        all.scene.source.text += (titles.size() > 1 ? "---\n" : "") + scene.source.text;
        all.scene.description += (titles.size() > 1 ? "\n" : "") + scene.description;
    }
    all.scene.title =
        title.title.empty() ? listed(scenes.front().film.language, titles) : title.title;
    if (!title.words.empty()) all.scene.description = title.words;
    all.scene.seed = scenes.front().seed;
    all.scene.source.overrides = scenes.front().source.overrides;
    return film_writer(all, options, chapters_of(scenes, parts));
}

void write_title(FilmWriter& whole, const JoinedPart& part, const JoinedTitle& title) {
    Canvas card = FramePainter::blank(part.film);
    draw_title(card, part.film, title);
    const auto writer = writer_of_part(whole, part);
    const std::unique_ptr<FilmSegment> segment = writer->segment(0);
    for (int i = 0; i < part.frames; ++i) segment->add(card);
    segment->finish();
    segment->join();
}

}  // namespace

double cover_of(const JoinedPart& part, int frame) {
    const auto cover = [&](int from_end) {
        return part.fading > 0 ? std::max(0.0, 1.0 - (from_end + 0.5) / part.fading) : 0.0;
    };
    return std::max(part.comes_in ? cover(frame) : 0.0,
                    part.goes_out ? cover(part.frames - 1 - frame) : 0.0);
}

std::unique_ptr<FilmWriter> writer_of_part(FilmWriter& whole, const JoinedPart& part) {
    return std::make_unique<PartWriter>(whole, part);
}

void draw_title(Canvas& canvas, const Film& film, const JoinedTitle& title) {
    canvas.fill_all(page_color(film));
    const Theme& theme = theme_of(film);
    const double width = film.size.width, unit = Grid(film).unit();
    const TextStyle large{.size = 3.4 * unit,
                          .weight = 600,
                          .color = theme.ink,
                          .align = Align::center,
                          .tabular = false,
                          .max_width = 0.84 * width,
                          .fonts = theme.fonts};
    TextStyle small = large;
    small.size = 1.6 * unit;
    small.weight = 400;
    small.color = theme.muted;
    constexpr std::size_t most_lines = 6;
    constexpr double line = 1.35;
    const auto heading = wrapped(title.title, large, most_lines);
    const auto rest = wrapped(title.words, small, most_lines);
    const double height = line * (large.size * static_cast<double>(heading.size()) +
                                  small.size * static_cast<double>(rest.size()));
    double y = 0.5 * (film.size.height - height);
    const auto write = [&](const std::vector<std::string>& lines, const TextStyle& style) {
        for (const std::string& words : lines) {
            draw_text(canvas, {0.5 * width, y + style.size}, escape_markup(words), style);
            y += line * style.size;
        }
    };
    write(heading, large);
    write(rest, small);
}

double seconds_of_title(const JoinedTitle& title) {
    return title.title.empty() ? 0.0 : title_seconds;
}

double bytes_of_title(const std::vector<Scene>& scenes, const JoinedTitle& title,
                      const FilmOptions& options) {
    if (title.title.empty()) return 0.0;
    FilmOptions its = options;
    its.take = [](const FilmWriter&) {};
    const JoinedPart card = title_part(scenes.front().film);
    const std::unique_ptr<FilmWriter> writer = film_writer(plan_of_all(scenes, card.frames), its);
    write_title(*writer, card, title);
    writer->settle();
    return static_cast<double>(writer->bytes());
}

RenderReport render_joined(const std::vector<Scene>& scenes, const JoinedTitle& title,
                           const FilmOptions& options, Progress& progress) {
    const Stopwatch watch;
    const JoinedPart card = title_part(scenes.front().film);
    const bool has_card = !title.title.empty();
    const std::vector<JoinedPart> parts = parts_of(scenes, has_card ? card.frames : 0);
    std::unique_ptr<FilmWriter> writer;
    RenderReport report;
    FilmText text;
    text.chapters = webvtt_of(chapters_of(scenes, parts), scenes.front().film.fps);
    text.transcript = transcript_head(scenes, title, parts, format_of_film(options.output));
    bool hears = false;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        FilmOptions own = options;
        own.joined_at = static_cast<double>(parts[i].first) / scenes[i].film.fps;
        const FilmPlan plan = prepare(scenes[i], own, progress);
        if (!writer) {
            writer = writer_of_all(scenes, title, options, parts);
            if (has_card) write_title(*writer, card, title);
        }
        const auto part = writer_of_part(*writer, parts[i]);
        if (!plan.sound.empty()) part->add_sound(0, plan.sound);
        report.lacks_sound = report.lacks_sound || (scenes[i].film.sound && plan.sound.empty());
        hears = hears || !plan.sound.empty();
        draw_frames(plan, options.threads, *part, progress, report);
        append(text, plan.text);
    }
    if (has_card) report.frames += card.frames;
    throw_if_interrupted();
    report.path = options.output;
    report.simulate_seconds = watch.cpu();
    finish_film(*writer, text, files_wanted(options.text, hears), options, report);
    report.wall_seconds = watch.wall();
    return report;
}

}  // namespace carom
