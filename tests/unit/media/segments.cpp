// Segments that are encoded in one process and joined in another.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "support/numbered_film.h"
#include "util/archive.h"

using namespace carom;
using namespace carom::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::uint32_t> greys() {
    std::vector<std::uint32_t> palette;
    for (std::uint32_t level = 0; level < 256; ++level)
        palette.push_back(0xff000000u | 0x10101u * level);
    return palette;
}

std::unique_ptr<FilmWriter> writer_of(const fs::path& path, const VideoSettings& settings) {
    auto writer = film_writer(path, settings, total);
    writer->use_colors(greys());
    return writer;
}

// Each segment by a writer of its own, the last one first, as bytes.
std::vector<std::string> segments_encoded_apart(const fs::path& path,
                                                const VideoSettings& settings) {
    std::vector<std::string> segments(lengths.size());
    for (std::size_t k = lengths.size(); k-- > 0;) {
        const int first = std::accumulate(lengths.begin(), lengths.begin() + long(k), 0);
        const auto writer = writer_of(path, settings);
        Archive archive;
        encode(*writer, settings, first, lengths[k])->archive(archive);
        segments[k] = archive.finished();
    }
    return segments;
}

void join(const fs::path& path, const VideoSettings& settings,
          const std::vector<std::string>& segments) {
    const auto writer = writer_of(path, settings);
    int first = 0;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        Archive archive(segments[k], "segment");
        const auto segment = writer->segment(first);
        segment->archive(archive);
        archive.expect_end();
        segment->join();
        first += lengths[k];
    }
    writer->commit();
}

}  // namespace

TEST_CASE("segments that were encoded by other writers join to the very same film") {
    const FilmFolder folder;
    for (const std::string ending : {".mp4", ".webm", ".gif", "/"})
        for (const bool transparent : {false, true}) {
            if (transparent && ending != ".webm") continue;
            CAPTURE(ending);
            CAPTURE(transparent);
            VideoSettings settings = small_film();
            settings.transparent = transparent;
            settings.metadata = {{"title", "T"}};
            const auto path = [&](const std::string& name) {
                return folder.path() / (name + (transparent ? "-alpha" : "") + ending);
            };
            write_film(path("direct"), settings, false, greys());
            const std::vector<std::string> apart =
                segments_encoded_apart(path("elsewhere"), settings);
            CHECK_FALSE(fs::exists(path("elsewhere")));
            join(path("joined"), settings, apart);
            CHECK((all_bytes(path("direct")) == all_bytes(path("joined"))));
        }
}

TEST_CASE("a segment that was encoded with other parameters is refused") {
    const FilmFolder folder;
    VideoSettings other = small_film();
    other.width = 336;
    const std::vector<std::string> segments =
        segments_encoded_apart(folder.path() / "other.mp4", other);
    CHECK_THROWS_WITH_AS(join(folder.film(), small_film(), segments),
                         "cannot read segment: it was encoded with other parameters", SystemError);
    CHECK_FALSE(fs::exists(folder.film()));
}
