// The core as another program meets it: installed, found by CMake, built and run. The program is
// the one that docs/library.md shows.
#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/relative.h"
#include "support/test_root.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// The block of docs/library.md between ```LANGUAGE and ``` that contains `word`.
std::string block_of_manual(const std::string& language, const std::string& word) {
    const std::string text = contents(carom::test::checkout() / "docs/library.md");
    const std::string open = "```" + language + "\n", close = "```\n";
    for (std::size_t begin = text.find(open); begin != std::string::npos;
         begin = text.find(open, begin)) {
        begin += open.size();
        const std::string block = text.substr(begin, text.find(close, begin) - begin);
        if (block.find(word) != std::string::npos) return block;
    }
    return "";
}

// Frees what the core has allocated: Eigen, were it left alone, would align arrays for the user's
// processor and free what was aligned for another.
const std::string frees_arrays = R"(
[[maybe_unused]] const bool placed = [] {
    carom::Gas gas;
    gas.box.size = {9.0, 9.0};
    gas.species = {{.name = "", .count = 9}};
    return carom::place(gas).first.count() == 9;
}();
)";

// A file that includes each installed header, so that none needs one that was not installed.
std::string all_headers(const fs::path& include) {
    std::string text;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(include))
        if (entry.is_regular_file())
            text += "#include <" + fs::relative(entry.path(), include).string() + ">\n";
    return text;
}

}  // namespace

TEST_CASE("the manual's program builds from an installed core and is right") {
    const std::string cmake = block_of_manual("cmake", "find_package(carom");
    const std::string program = block_of_manual("cpp", "carom::Simulation");
    REQUIRE_FALSE(cmake.empty());
    REQUIRE_FALSE(program.empty());

    const TemporaryFolder folder;
    const fs::path installed = folder.path() / "installed", source = folder.path() / "source";
    Outcome outcome =
        run({"cmake", "--install", CAROM_BUILD_FOLDER, "--prefix", installed.string()});
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);
    for (const std::string recipe : {"slurm-array.sh", "attempt.sh", "profiles/slurm/job-state.sh"})
        CHECK((fs::status(installed / "share/carom/cluster" / recipe).permissions() &
               fs::perms::owner_exec) != fs::perms::none);
    for (const std::string file :
         {"carom/cluster/Snakefile", "man/man1/carom.1", "man/man1/carom-render.1",
          "bash-completion/completions/carom", "zsh/site-functions/_carom",
          "fish/vendor_completions.d/carom.fish"}) {
        CAPTURE(file);
        CHECK(fs::exists(installed / "share" / file));
    }
    fs::create_directory(source);
    std::ofstream(source / "CMakeLists.txt")
        << cmake
        << "target_sources(collision_rate PRIVATE headers.cpp)\n"
           "add_executable(every_call every_call.cpp)\n"
           "target_link_libraries(every_call PRIVATE carom::physics)\n";
    fs::copy_file(checkout() / "tests/install/program/every_call.cpp", source / "every_call.cpp");
    std::ofstream(source / "collision_rate.cpp") << program;
    std::ofstream(source / "headers.cpp") << all_headers(installed / "include") << frees_arrays;

    outcome = run(
        {"cmake", "-S", source.string(), "-B", "build", "-G", "Ninja",
         "-DCMAKE_PREFIX_PATH=" + installed.string(),
         std::string("-DCMAKE_CXX_COMPILER=") + CAROM_CXX_COMPILER,
         std::string("-DCMAKE_CXX_FLAGS=-march=native -Werror -Wall -Wextra ") + CAROM_CXX_FLAGS},
        folder.path());
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);
    outcome = run({"cmake", "--build", "build"}, folder.path());
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.out);
    outcome = run({"build/every_call"}, folder.path());
    CHECK_MESSAGE(outcome.exit_code == 0, outcome.out);
    outcome = run({"build/collision_rate"}, folder.path());
    REQUIRE_MESSAGE(outcome.exit_code == 0, outcome.err);

    double rate = 0.0, enskog = 0.0;
    REQUIRE(std::sscanf(outcome.out.c_str(), "rate %lf, Enskog %lf", &rate, &enskog) == 2);
    // packing 0.2011, temperature 1 but for the drawing of 1000 velocities
    CHECK(enskog == relative(1.295, 0.1));
    // 128,000 collisions: their number is good to 0.3 %
    CHECK(rate == relative(enskog, 0.012));
}

TEST_CASE("what was installed is removed, and nothing else") {
    const TemporaryFolder folder;
    const fs::path installed = folder.path() / "installed";
    REQUIRE(
        run({"cmake", "--install", CAROM_BUILD_FOLDER, "--prefix", installed.string()}).exit_code ==
        0);
    REQUIRE(fs::exists(installed / "bin/carom"));
    std::ofstream(installed / "share/carom/scenes/mine.yaml") << "mine";
    const fs::path script = checkout() / "cmake/uninstall.cmake";
    const std::string manifest =
        "MANIFEST=" + (fs::path(CAROM_BUILD_FOLDER) / "install_manifest.txt").string();
    const Outcome outcome = run({"cmake", "-D", manifest, "-P", script.string()});
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    std::vector<std::string> left;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(installed))
        if (!entry.is_directory()) left.push_back(entry.path().string());
    CHECK(left == std::vector{(installed / "share/carom/scenes/mine.yaml").string()});
    CHECK_FALSE(fs::exists(installed / "include/carom"));
    CHECK(run({"cmake", "-D", manifest, "-P", script.string()}).exit_code != 0);
}
