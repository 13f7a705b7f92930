#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/film_tags.h"
#include "support/numbered_film.h"

using namespace carom;
using namespace carom::test;

TEST_CASE("a WebM is the same bytes whatever threads encoded its segments, for every quality") {
    const FilmFolder folder;
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        write_film(folder.path() / "one.webm", small_film(quality));
        write_film(folder.path() / "many.webm", small_film(quality), true);
        CHECK(contents(folder.path() / "one.webm") == contents(folder.path() / "many.webm"));
    }
}

TEST_CASE("ffprobe sees a tagged VP9 film of constant rate, with a key frame at every joint") {
    const FilmFolder folder;
    VideoSettings settings = small_film();
    settings.metadata = {{"title", "One hot particle — 293 K"}, {"seed", "18446744073709551615"}};
    for (const Quality quality : {Quality::draft, Quality::standard, Quality::final_}) {
        CAPTURE(int(quality));
        settings.quality = quality;
        write_film(folder.webm(), settings);
        const nlohmann::json all = probe(folder.webm());
        const nlohmann::json& stream = all["streams"][0];
        check_film_tags(all, 30);
        CHECK(all["format"]["format_name"].get<std::string>().find("webm") != std::string::npos);
        CHECK(stream["codec_name"] == "vp9");
        CHECK(stream["profile"] == "Profile 0");
        CHECK(std::stod(all["format"]["duration"].get<std::string>()) ==
              doctest::Approx(total / 30.0).epsilon(0.001));
        const nlohmann::json& tags = all["format"]["tags"];
        CHECK(tags["title"] == "One hot particle — 293 K");
        CHECK(tags["SEED"] == "18446744073709551615");
        CHECK_FALSE(tags.contains("creation_time"));

        // WebM counts in milliseconds.
        std::vector<int> keys;
        int count = 0;
        for (const nlohmann::json& item : all["packets_and_frames"]) {
            if (item["type"] != "packet") continue;
            CHECK(std::abs(item["pts"].get<double>() - count * 1000.0 / 30.0) <= 0.5);
            if (item["flags"].get<std::string>()[0] == 'K') keys.push_back(count);
            ++count;
        }
        CHECK(count == total);
        CHECK(keys == std::vector<int>{0, 7, 27, 40, 41});
    }
}

TEST_CASE("the index of a WebM stands before the pictures") {
    const FilmFolder folder;
    write_film(folder.webm(), small_film());
    const std::string bytes = contents(folder.webm());
    const std::string index = "\x1c\x53\xbb\x6b";
    const std::size_t cluster = bytes.find("\x1f\x43\xb6\x75");
    CHECK(bytes.starts_with("\x1a\x45\xdf\xa3"));
    CHECK(cluster != std::string::npos);
    CHECK(bytes.find(index) < cluster);  // named in the list of what the file holds
    CHECK(bytes.find(index) < bytes.rfind(index, cluster));
    CHECK(folder.names().size() == 1);
}

TEST_CASE("a WebM whose write fails, early or late, is one clear error and harms nothing") {
    const FilmFolder folder;
    check_failing_writes(folder.webm(), small_film(Quality::draft), 600'000);
    CHECK(folder.names().size() == 1);
}
