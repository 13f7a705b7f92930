// Small scenes for the recipes of cluster/, and the program, which writes down what it is asked.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/test_root.h"

namespace carom::test {

inline const std::string program = CAROM_PROGRAM;
inline const std::filesystem::path recipes = checkout() / "cluster";

/// Whether all of these programs are there. Fails the test in CI, where they must be.
inline bool are_installed(std::initializer_list<const char*> names) {
    for (const std::string name : names) {
        if (is_installed(name)) continue;
        if (std::getenv("CI") != nullptr)
            FAIL_CHECK(name, " is not installed: ./dev setup full, or for Slurm ./dev test --slow");
        else
            MESSAGE(name, " is not installed: the recipes that need it are not tried");
        return false;
    }
    return true;
}

/// A folder with the scenes first.yaml, second.yaml and ensemble.yaml, and a `carom` that adds its
/// arguments to the file `asked`.
struct Workplace : TemporaryFolder {
    Workplace() {
        std::filesystem::create_directory(path() / "scenes");
        write("scenes/first.yaml",
              scene("count: 40, radius: 0.4, speed: 3", small + ", seconds: 4"));
        write("scenes/second.yaml",
              scene("count: 12, radius: 0.7, speed: 2", small + ", seconds: 2"));
        write("ensemble.yaml", scene("count: 20, radius: 0.4, speed: 2", small));
        write("carom", "#!/bin/sh\necho \"$@\" >>'" + (path() / "asked").string() + "'\nexec '" +
                           program + "' \"$@\"\n");
        std::filesystem::permissions(path() / "carom", std::filesystem::perms::owner_all);
    }

    /// A scene. Films of 4 seconds have 4 segments, those of 2 seconds 2: at most as many chunks.
    static std::string scene(const std::string& species, const std::string& film) {
        return "title: A small gas\nbox: {size: [16, 9]}\ngas: [{" + species +
               "}]\nrun: {until: 10}\nfilm: {" + film + ", panels: [energy-histogram]}\n";
    }

    std::string file(const std::string& name) const { return contents(path() / name); }
    bool has(const std::string& name) const { return std::filesystem::exists(path() / name); }

    /// What one process makes of the same scenes: one.mp4, one.gif, one.json, one.csv.
    void make_references() const {
        const Outcome made = shell(
            "set -e; exec >&2; '" + program + "' render scenes/first.yaml -o one.mp4 --quiet; '" +
                program + "' render scenes/second.yaml -o one.gif --quiet; '" + program +
                "' plan ensemble.yaml " + ensemble + " --chunks 1 -o one.sweep --quiet; '" +
                program + "' run one.sweep --quiet; '" + program +
                "' join one.sweep -o one.json --csv one.csv --quiet",
            path());
        REQUIRE_MESSAGE(made.exit_code == 0, made.err);
    }

    /// What carom was asked since the last time: lines that contain `part`, sorted.
    std::vector<std::string> asked(const std::string& part) const {
        std::istringstream lines(file("asked"));
        std::vector<std::string> found;
        for (std::string line; std::getline(lines, line);)
            if (line.find(part) != std::string::npos) found.push_back(line);
        std::ranges::sort(found);
        return found;
    }
    void forget_asked() const { std::filesystem::remove(path() / "asked"); }

    inline static const std::string small = "size: [320, 180]";
    inline static const std::string ensemble = "--seeds 1:6 --vary gas.0.radius=0.3:0.5:2";
};

/// `contents` of two files are the same, and there.
inline void check_same(const Workplace& place, const std::string& one, const std::string& other) {
    CAPTURE(one);
    CAPTURE(other);
    CHECK(place.has(one));
    CHECK_FALSE(place.file(other).empty());
    CHECK(place.file(one) == place.file(other));
}

}  // namespace carom::test
