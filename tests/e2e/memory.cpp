// The memory of films, as carom check names it and as the system counts it.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;
using nlohmann::json;

namespace {

// The largest of all programs that were run here so far, bytes.
double largest_peak() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

struct Case {
    std::string size, format, more;
};

}  // namespace

#ifndef __SANITIZE_ADDRESS__  // whose own memory is many times that
TEST_CASE("a film takes at most the memory that carom check names, and at least a quarter of it") {
    const TemporaryFolder folder;
    double named = 0.0;
    // Each needs more than those before, whose peaks are counted too.
    for (const Case& one : {Case{"320x180", "mp4", ""},
                            {"1280x720", "mp4", "--quality final"},
                            {"1280x720", "webm", ""},
                            {"1920x1080", "gif", ""},
                            {"3840x2160", "mp4", "--quality final"}}) {
        CAPTURE(one.size);
        CAPTURE(one.format);
        const std::string options = fmt::format(" '{}' --size {} --set film.seconds=2 ",
                                                library_scene("mixed-masses"), one.size);
        const Outcome check = shell("'" + program + "' check --json" + options, folder.path());
        REQUIRE(check.exit_code == 0);
        const json rough = json::parse(check.out).at(0).at("film").at("rough");
        const double bytes = rough.at("formats").at(one.format).at("memory_bytes");
        CHECK(bytes > named);
        named = bytes;
        const Outcome render =
            shell(fmt::format("'{}' render --quiet --threads {} -o film.{} {} {}", program,
                              rough.at("cores").get<int>(), one.format, one.more, options),
                  folder.path());
        REQUIRE(render.exit_code == 0);
        CHECK(largest_peak() <= named);
        CHECK(largest_peak() >= 0.25 * named);
    }
}
#endif
