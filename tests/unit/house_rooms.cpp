// The house keeps its walls: includes go down only, and each third-party header has its one door.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const std::map<std::string, std::set<std::string>> allowed_rooms{
    {"util", {}},
    {"physics", {"util"}},
    {"stats", {"util", "physics"}},
    {"scene", {"util", "physics"}},
    {"draw", {"util"}},
    {"panels", {"util", "physics", "stats", "scene", "draw"}},
    {"media", {"util", "draw"}},
    {"figures", {"util", "physics", "stats", "scene", "draw", "panels"}},
    {"app", {"util", "physics", "stats", "scene", "draw", "panels", "media", "figures"}},
};

// What scene/ may know of physics/: its plain types, and what is known of them without a
// simulation.
const std::set<std::string> plain_physics{"physics/gas.h", "physics/jam.h", "physics/lattice.h",
                                          "physics/run.h", "physics/wire_squeeze.h"};

struct Door {
    std::regex header;
    std::set<std::string> files;  // that may include it; a trailing slash means the whole room
};

const std::vector<Door> doors{
    {std::regex("mpfr.*|boost/.*"), {"physics/multiprecision.h"}},
    {std::regex("yaml-cpp/.*"), {"scene/yaml.cpp"}},
    {std::regex("cairo.*"), {"draw/canvas.cpp", "draw/text.cpp"}},
    {std::regex("(pango|fontconfig)/.*"), {"draw/text.cpp"}},
    {std::regex("glib\\.h"), {"draw/markup.cpp"}},
    {std::regex("xxhash.*"), {"app/fingerprint.cpp"}},
    {std::regex("pugixml.*"), {"draw/svg.cpp"}},
    {std::regex("zlib.*"), {"draw/png.cpp"}},
    {std::regex("lib(av|sw).*"),
     {"media/libav.h", "media/video_writer.cpp", "media/gif_palette.cpp", "media/base64.cpp"}},
    {std::regex("CLI/.*"), {"app/command.h"}},
    {std::regex("nlohmann/.*"),
     {"app/run_json.cpp", "app/check_json.cpp", "app/schema_json.cpp", "app/figures_json.cpp"}},
    {std::regex("Eigen/.*"), {"physics/", "stats/", "scene/", "panels/", "figures/"}},
    {std::regex("unsupported/Eigen/.*"), {"stats/goodness.cpp"}},
    {std::regex("fmt/.*"),
     {"util/", "physics/", "stats/", "scene/", "draw/", "panels/", "media/", "figures/", "app/"}},
};

struct Include {
    std::string file;    // room/name
    std::string header;  // as written
    bool quoted;
};

std::vector<Include> includes() {
    const fs::path source = fs::path(CAROM_TEST_ROOT) / "src";
    const std::regex line(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<Include> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string text; std::getline(file, text);)
            if (std::regex_search(text, match, line))
                found.push_back(
                    {fs::relative(entry.path(), source).string(), match[2], match[1] == "\""});
    }
    return found;
}

std::string room(const std::string& path) { return path.substr(0, path.find('/')); }

bool is_own(const std::string& header) { return allowed_rooms.contains(room(header)); }

// Headers of C and POSIX, with their folders; all others with a slash or .h are third-party.
bool is_system(const std::string& header) {
    static const std::set<std::string> posix{"fcntl.h", "unistd.h", "sys/stat.h", "sys/mman.h",
                                             "sys/resource.h"};
    return posix.contains(header) || header.find_first_of("/.") == std::string::npos;
}

bool through_its_door(const Include& include) {
    for (const Door& door : doors)
        if (std::regex_match(include.header, door.header))
            return door.files.contains(include.file) ||
                   door.files.contains(room(include.file) + "/");
    return false;
}

}  // namespace

TEST_CASE("a room includes only rooms below it") {
    const std::vector<Include> all = includes();
    CHECK(all.size() > 100);
    for (const Include& include : all) {
        if (!is_own(include.header)) continue;
        CAPTURE(include.file);
        CAPTURE(include.header);
        const std::string here = room(include.file);
        REQUIRE(allowed_rooms.contains(here));
        CHECK((here == room(include.header) ||
               allowed_rooms.at(here).contains(room(include.header))));
        if (here == "scene" && room(include.header) == "physics")
            CHECK(plain_physics.contains(include.header));
    }
}

TEST_CASE("a third-party header is included only by the file that is its door") {
    for (const Include& include : includes()) {
        if (is_own(include.header) || (!include.quoted && is_system(include.header))) continue;
        CAPTURE(include.file);
        CAPTURE(include.header);
        CHECK(through_its_door(include));
    }
}
