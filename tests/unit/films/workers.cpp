#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "films/in_order.h"
#include "films/render.h"
#include "films/segment_workers.h"
#include "support/file_size_limit.h"
#include "support/process.h"
#include "support/scene_text.h"
#include "util/interrupt.h"

using namespace carom;
using carom::test::contents;
using carom::test::TemporaryFolder;

namespace {

Scene small_scene(int disks, double seconds, const std::string& size = "128, 72") {
    return test::scene_from(
        "title: T\nbox: {size: [400, 300]}\ngas: [{count: " + std::to_string(disks) +
        ", radius: 0.3, speed: 1}]\nrun: {until: 3}\nfilm: {seconds: " + std::to_string(seconds) +
        ", size: [" + size + "], panels: []}\n");
}

RenderReport render_with(const Scene& scene, const std::filesystem::path& path, int threads) {
    Progress silent(Progress::Form::silent, "");
    return render(scene, {.output = path, .quality = Quality::draft, .threads = threads}, silent);
}

// A film that stands still at its first frame, handed to workers in segments of so many frames.
class StillFilm {
  public:
    explicit StillFilm(const Scene& scene)
        : scene_(scene),
          simulation_(scene.gas, scene.run),
          panels_(scene, simulation_.particles(), simulation_.sample()),
          tick_(timeline(scene).front()),
          advanced_(simulation_.advance_to(0.0)) {
        panels_.survey(tick_, simulation_.sample(), advanced_);
        panels_.fix_axes();
    }

    VideoSettings settings() const {
        return {.width = scene_.film.size.width,
                .height = scene_.film.size.height,
                .fps = 30,
                .quality = Quality::draft,
                .metadata = {}};
    }

    void make(const std::filesystem::path& path, int segment, int threads) {
        const int frames = frame_count(scene_.film);
        const auto writer = film_writer(path, settings(), frames);
        Progress silent(Progress::Form::silent, "");
        SegmentWorkers workers(panels_, segment_starts(frames, segment), threads, *writer, silent);
        for (int i = 0; i < frames; ++i) workers.frame(frame());
        workers.finish();
    }

    FrameData frame() { return panels_.frame_data(tick_, simulation_.sample(), advanced_); }
    const PanelSet& panels() const { return panels_; }

  private:
    const Scene& scene_;
    Simulation simulation_;
    PanelSet panels_;
    Tick tick_;
    AdvanceResult advanced_;
};

}  // namespace

TEST_CASE("seconds are told as on a clock") {
    CHECK(clock_text(7.2) == "0:07");
    CHECK(clock_text(754.0) == "12:34");
    CHECK(clock_text(3723.0) == "1:02:03");
}

TEST_CASE("films of two frames, of fewer segments than workers and of many particles are made") {
    const TemporaryFolder folder;
    for (const auto& [disks, seconds, threads] :
         {std::tuple{5, 0.07, 4}, std::tuple{5, 9.0, 16}, std::tuple{20000, 3.0, 2}}) {
        const Scene scene = small_scene(disks, seconds);
        const RenderReport report = render_with(scene, folder.path() / "film.mp4", threads);
        CHECK(report.frames == frame_count(scene.film));
        CHECK(report.bytes == static_cast<std::int64_t>(std::filesystem::file_size(report.path)));
    }
}

TEST_CASE("an interruption stops workers that have all their frames") {
    const TemporaryFolder folder;
    const Scene scene = small_scene(5, 9.0);
    StillFilm film(scene);
    set_interrupted(true);
    CHECK_THROWS_AS(film.make(folder.path() / "film.mp4", 5, 2), Interrupted);
    set_interrupted(false);
    CHECK(folder.names().empty());
}

TEST_CASE("a worker's error reaches the caller") {
    const TemporaryFolder folder;
    const Scene scene = small_scene(5, 2.0);
    StillFilm film(scene);
    VideoSettings wrong = film.settings();  // another size than the frames have
    wrong.width = wrong.height = 0;
    const auto writer = film_writer(folder.path() / "film.mp4", wrong, 1);
    Progress silent(Progress::Form::silent, "");
    SegmentWorkers workers(film.panels(), {0, 1}, 1, *writer, silent);
    workers.frame(film.frame());  // an encoder begins with its first frame
    CHECK_THROWS_AS(workers.finish(), std::exception);
}

TEST_CASE("values are handed on in order, and none after one that could not be") {
    InOrder<std::string> words;
    std::string line;
    const auto say = [&line](const std::string& word) { line += word + " "; };
    words.add(2, "three", say);
    words.add(0, "one", say);
    CHECK(line == "one ");
    words.add(1, "two", say);
    CHECK(line == "one two three ");
    CHECK(words.next() == 3);

    const auto refuse = [](const std::string&) { throw std::runtime_error("full"); };
    words.add(4, "five", say);
    CHECK_THROWS_AS(words.add(3, "four", refuse), std::runtime_error);
    words.add(5, "six", say);
    CHECK(line == "one two three ");
}

TEST_CASE("a film that cannot be written to its end stops all workers, wherever they are") {
    const TemporaryFolder folder;
    const Scene scene = small_scene(2000, 1.0, "640, 360");
    StillFilm film(scene);
    // As with a full disk, some segments, of one frame each, are written before one is not.
    {
        const test::FileSizeLimit small(10'000);
        for (int round = 0; round < 10; ++round)
            CHECK_THROWS_AS(film.make(folder.path() / "film.mp4", 1, 8), SystemError);
    }
    CHECK(folder.names().empty());
}
