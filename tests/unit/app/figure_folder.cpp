// A folder of figures: what it takes for its own, wherever the writing was cut off.
#include "app/figures/figure_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"
#include "util/diagnostics.h"

using namespace carom;
namespace fs = std::filesystem;

namespace {

NewFile file_of(const std::string& name, const std::string& text) {
    return {name, {text.begin(), text.end()}, "a", "from " + text};
}

// A film that consists of these bytes.
class FinishedFilm : public FilmWriter {
  public:
    explicit FinishedFilm(std::string bytes) : bytes_(std::move(bytes)) {}
    std::unique_ptr<FilmSegment> segment(int /*first*/) override { return nullptr; }
    std::int64_t bytes() const override { return static_cast<std::int64_t>(bytes_.size()); }
    void copy(const std::function<void(std::string_view)>& take) const override { take(bytes_); }
    void settle() override {}
    void commit() override {}
    std::string name() const override { return ""; }

  private:
    std::string bytes_;
};

const std::vector<std::string> both{"a.svg", "b.svg"};

}  // namespace

TEST_CASE("a link in the place of a file, or of a folder above it, is not followed") {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "figures";
    folder.write("elsewhere.mp4", "mine");
    fs::create_directories(path / "films");
    fs::create_symlink("../../elsewhere.mp4", path / "films/a.mp4");
    FigureFolder figures(path, "scene.yaml");
    CHECK(figures.foreign(std::vector<std::string>{"films/a.mp4"}).size() == 1);
    figures.write(FinishedFilm("film"), "films/a.mp4", "inputs");
    CHECK_FALSE(fs::is_symlink(path / "films/a.mp4"));
    CHECK(test::contents(path / "films/a.mp4") == "film");
    CHECK(figures.is_current("films/a.mp4", "inputs"));

    fs::create_directory(folder.path() / "other");
    fs::create_symlink("../other", path / "more");
    CHECK_THROWS_WITH_AS(figures.write(FinishedFilm("film"), "more/b.mp4", "inputs"),
                         doctest::Contains("link"), SystemError);
    CHECK(fs::is_empty(folder.path() / "other"));
    CHECK(test::contents(folder.path() / "elsewhere.mp4") == "mine");
}

TEST_CASE("a folder that was cut off while it was written knows what is in it") {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "figures";
    {
        FigureFolder figures(path, "scene.yaml");
        figures.write(std::vector{file_of("a.svg", "old a"), file_of("b.svg", "old b")});
        figures.save();
    }
    // The work ends between a file and its neighbour: a new a.svg, the old b.svg, no list of them.
    fs::remove(path / "b.svg");
    fs::create_directory(path / "b.svg");
    {
        FigureFolder figures(path, "scene.yaml");
        const std::vector files{file_of("a.svg", "new a"), file_of("b.svg", "new b")};
        CHECK_THROWS_AS(figures.write(files), SystemError);
    }
    fs::remove(path / "b.svg");
    folder.write("figures/b.svg", "old b");
    CHECK(test::contents(path / "a.svg") == "new a");
    FigureFolder figures(path, "scene.yaml");
    CHECK(figures.foreign(both).empty());
    CHECK_FALSE(figures.is_current("a.svg", "from new a"));  // not sure of: made again
    CHECK(figures.is_current("b.svg", "from old b"));
    figures.write(std::vector{file_of("a.svg", "new a"), file_of("b.svg", "new b")});
    figures.save();
    CHECK(figures.is_current("a.svg", "from new a"));
    CHECK(test::contents(path / "figures.json").find("coming") == std::string::npos);
}

TEST_CASE("the first files of a folder are known too, and no others") {
    const test::TemporaryFolder folder;
    fs::create_directories(folder.path() / "b.svg");
    {
        FigureFolder figures(folder.path(), "scene.yaml");
        const std::vector files{file_of("a.svg", "a"), file_of("b.svg", "b")};
        CHECK_THROWS_AS(figures.write(files), SystemError);
    }
    fs::remove(folder.path() / "b.svg");
    folder.write("b.svg", "mine");
    const FigureFolder figures(folder.path(), "scene.yaml");
    CHECK(figures.foreign(both) == std::vector<std::string>{"b.svg"});
    folder.write("a.svg", "");
    CHECK(figures.foreign(both) == both);
}

TEST_CASE("a film is known before it is there") {
    const test::TemporaryFolder folder;
    fs::create_directories(folder.path() / "film.mp4");  // nothing can take its place
    folder.write("film.mp4/mine", "");
    {
        FigureFolder figures(folder.path(), "scene.yaml");
        CHECK_THROWS_AS(figures.write(FinishedFilm("frames"), "film.mp4", "x"), SystemError);
    }
    fs::remove_all(folder.path() / "film.mp4");
    folder.write("film.mp4", "frames");
    FigureFolder figures(folder.path(), "scene.yaml");
    CHECK(figures.foreign(std::vector<std::string>{"film.mp4"}).empty());
    figures.write(FinishedFilm("other frames"), "film.mp4", "x");
    CHECK(figures.is_current("film.mp4", "x"));
    CHECK(test::contents(folder.path() / "film.mp4") == "other frames");
}
