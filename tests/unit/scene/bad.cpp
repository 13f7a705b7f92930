// Every bad scene with its whole message: tests/scenes_bad/NAME.yaml gives exactly NAME.txt.
// CAROM_UPDATE_MESSAGES=1 writes the messages as carom gives them; read the difference before it is
// committed.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "panels/registry.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "support/bad_scenes.h"
#include "support/files.h"
#include "support/test_root.h"

using carom::test::contents;
namespace fs = std::filesystem;

namespace {

std::string message_of(const fs::path& scene) {
    try {
        carom::load_scene(scene, {"templates", carom::panel_kinds()});
    } catch (const carom::SceneError& error) {
        return std::string{error.what()} + "\n";
    }
    return "no error\n";
}

}  // namespace

TEST_CASE("a bad scene is refused with its whole message") {
    fs::current_path(carom::test::checkout());
    const std::vector<fs::path> scenes = carom::test::bad_scenes();
    CHECK(scenes.size() >= 60);
    for (const fs::path& scene : scenes) {
        CAPTURE(scene.string());
        const fs::path expected = fs::path{scene}.replace_extension(".txt");
        if (std::getenv("CAROM_UPDATE_MESSAGES") != nullptr)
            std::ofstream(expected) << message_of(scene);
        CHECK(message_of(scene) == contents(expected));
    }
}

TEST_CASE("every expected message has its scene") {
    fs::current_path(carom::test::checkout());
    for (const auto& entry : fs::directory_iterator("tests/scenes_bad")) {
        CAPTURE(entry.path().string());
        CHECK(fs::exists(fs::path{entry.path()}.replace_extension(".yaml")));
    }
}

TEST_CASE("what cannot be read is named with the cause") {
    fs::current_path(carom::test::checkout());
    CHECK(
        message_of("scenes/none.yaml") ==
        "scenes/none.yaml: error: cannot be read: No such file or directory\n  hint: name a scene, "
        "for instance scenes/a-hundred-never-overlap.yaml\n");
    CHECK(message_of("scenes") ==
          "scenes: error: cannot be read: it is a folder\n  hint: name a file in it, for instance "
          "scenes/a-hundred-never-overlap.yaml\n");
    CHECK(message_of("/dev/zero") == "/dev/zero: error: cannot be read: it is no ordinary file\n");
}
