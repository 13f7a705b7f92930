// Several films as one.
#include "app/film/join.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "app/film/film_text.h"
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
        void join() override {}
        GreyWriter& writer;
        int frame;
    };
    std::unique_ptr<FilmSegment> segment(int first) override {
        return std::make_unique<Segment>(*this, first);
    }
    void commit() override {}
    std::int64_t bytes() const override { return 0; }
};

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
