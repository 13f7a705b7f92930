// Several films as one.
#include "films/join.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "draw/text.h"
#include "films/words/film_text.h"
#include "support/files.h"
#include "support/process.h"
#include "support/scene_text.h"

using namespace carom;

namespace {

// Keeps a grey of each frame, by its number.
class GreyWriter : public FilmWriter {
  public:
    std::vector<int> greys = std::vector<int>(100, -1);

    struct Segment : FilmSegment {
        Segment(GreyWriter& to, int at) : writer(to), frame(at) {}
        void add(const Canvas& canvas) override {
            writer.greys.at(static_cast<std::size_t>(frame++)) =
                static_cast<int>(canvas.pixels().data[0] & 0xFF);
        }
        void archive(carom::Archive&) override {}
        void join() override {}
        GreyWriter& writer;
        int frame;
    };
    std::unique_ptr<FilmSegment> segment(int first) override {
        return std::make_unique<Segment>(*this, first);
    }
    void settle() override {}
    void commit() override {}
    std::string name() const override { return "greys"; }
    std::int64_t bytes() const override { return 0; }
};

Scene small_scene(const std::string& title) {
    return test::scene_from("title: " + title +
                            "\nbox: {size: [40, 30]}\ngas: [{count: 4, speed: 1}]\n"
                            "run: {until: 2}\nfilm: {seconds: 2, fps: 5, size: [160, 96]}\n");
}

}  // namespace

TEST_CASE("a film in another fades out of the one before and into its own ground") {
    Film film;
    film.size = {64, 64};
    const JoinedPart part{.first = 50,
                          .frames = 40,
                          .fading = 10,
                          .before = rgb(0x000000),
                          .ground = rgb(0xFFFFFF),
                          .film = film};
    GreyWriter whole;
    const auto writer = writer_of_part(whole, part);
    Canvas grey = FramePainter::blank(film);
    grey.fill_all(rgb(0x808080));
    for (const int first : {0, 25}) {
        const auto segment = writer->segment(first);
        for (int i = first; i < (first == 0 ? 25 : 40); ++i) segment->add(grey);
    }
    CHECK(whole.greys[49] == -1);
    CHECK(whole.greys[90] == -1);
    CHECK(whole.greys[50] < 10);
    CHECK(whole.greys[89] > 245);
    for (std::size_t i = 51; i < 60; ++i) CHECK(whole.greys[i] > whole.greys[i - 1]);
    for (std::size_t i = 60; i < 80; ++i) CHECK(whole.greys[i] == 0x80);
    for (std::size_t i = 81; i < 90; ++i) CHECK(whole.greys[i] > whole.greys[i - 1]);
}

TEST_CASE("the first film does not come in, and the last one does not go out") {
    JoinedPart part{.frames = 40, .fading = 10, .comes_in = false};
    CHECK(cover_of(part, 0) == 0.0);
    CHECK(cover_of(part, 39) > 0.9);
    part.comes_in = true;
    part.goes_out = false;
    CHECK(cover_of(part, 0) > 0.9);
    CHECK(cover_of(part, 39) == 0.0);
}

TEST_CASE("the words of a film in another count from its beginning there, under its title") {
    const Scene scene = test::scene_from(
        "title: A second gas\nbox: {size: [40, 30]}\ngas: [{count: 9, speed: 1}]\n"
        "run: {until: 4, events: [{at: 0, caption: Words}]}\nfilm: {seconds: 8, fps: 10}\n");
    const Simulation start(scene.gas, scene.run);
    const std::vector<Tick> ticks = timeline(scene);
    const FilmText text = FilmTextMaker(scene, {0, 80}, ticks, start.particles(), 30.0).text();
    CHECK(text.captions == "WEBVTT\n\n00:00:30.000 --> 00:00:38.000\nWords\n");
    CHECK(text.chapters == "WEBVTT\n\n00:00:30.000 --> 00:00:38.000\nA second gas\n");
    CHECK(text.transcript.find("\n0:30  ") != std::string::npos);
}

TEST_CASE("the title of a joined film stands in the middle of its card, whole") {
    Film film;
    film.size = {640, 360};
    Canvas card = FramePainter::blank(film);
    TextLog log;
    draw_title(card, film, {"A course on gases", "From one fast disk to a curve"});
    REQUIRE(log.lines.size() == 2);
    for (const DrawnLine& line : log.lines) {
        CHECK_FALSE(line.is_cut);
        CHECK(std::abs(line.ink.x + 0.5 * line.ink.width - 320.0) < 4.0);
        CHECK(line.ink.y > 60.0);
        CHECK(line.ink.bottom() < 300.0);
    }
    CHECK(log.lines[0].size > log.lines[1].size);
}

TEST_CASE("a joined film has a card, chapters, and a transcript with its length") {
    const test::TemporaryFolder folder;
    FilmOptions options;
    options.output = folder.path() / "course.mp4";
    options.text = true;
    Progress progress(Progress::Form::silent, "");
    const RenderReport report = render_joined({small_scene("One"), small_scene("Two")},
                                              {"A course", "In two parts"}, options, progress);
    CHECK(report.frames == 20 + 10 + 10);
    CHECK(test::contents(folder.path() / "course.transcript.txt")
              .starts_with("A course\n\nIn two parts\n\nA silent film of 0:08, in 2 parts:\n\n"
                           "0:04  One\n0:06  Two\n"));
    CHECK(test::contents(folder.path() / "course.chapters.vtt") ==
          "WEBVTT\n\n00:00:00.000 --> 00:00:06.000\nOne\n\n00:00:06.000 --> 00:00:08.000\nTwo\n");
    if (!test::is_installed("ffprobe")) return;
    const std::string chapters = test::run({"ffprobe", "-v", "error", "-show_entries",
                                            "chapter=start_time,end_time:chapter_tags=title", "-of",
                                            "csv=p=0", (folder.path() / "course.mp4").string()},
                                           folder.path())
                                     .out;
    CHECK(chapters == "0.000000,6.000000,One\n6.000000,8.000000,Two\n");
}

TEST_CASE("what the card of a joined film takes is known before") {
    const test::TemporaryFolder folder;
    const std::vector<Scene> scenes{small_scene("One"), small_scene("Two")};
    const JoinedTitle title{"A course on gases", "From one fast disk to a curve"};
    Progress progress(Progress::Form::silent, "");
    for (const char* name : {"film.mp4", "film.webm", "frames/"}) {
        CAPTURE(name);
        FilmOptions options;
        options.output = folder.path() / "plain" / name;
        const auto bytes = [&](const JoinedTitle& its) {
            return static_cast<double>(render_joined(scenes, its, options, progress).bytes);
        };
        const double plain = bytes({});
        options.output = folder.path() / "titled" / name;
        const double card = bytes_of_title(scenes, title, options);
        CHECK(card > 0.0);
        CHECK(std::abs(std::log(card / (bytes(title) - plain))) < std::log(1.5));
        CHECK(bytes_of_title(scenes, {}, options) == 0.0);
    }
    CHECK(seconds_of_title(title) == 4.0);
    CHECK(seconds_of_title({}) == 0.0);
}

TEST_CASE("a joined film that does not fit is not written") {
    const test::TemporaryFolder folder;
    FilmOptions options;
    options.output = folder.write("course.mp4", "earlier");
    options.text = true;
    options.most_bytes = 100.0;
    Progress progress(Progress::Form::silent, "");
    const RenderReport report =
        render_joined({small_scene("One"), small_scene("Two")}, {}, options, progress);
    CHECK(report.bytes > 100);
    CHECK(render(small_scene("One"), options, progress).bytes > 100);
    CHECK(folder.names() == std::vector<std::string>{"course.mp4"});
    CHECK(test::contents(options.output) == "earlier");
}
