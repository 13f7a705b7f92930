// The texts of units are made in one place, from what a number is, so that a scene in other units
// needs no other words anywhere else.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "support/test_root.h"

namespace fs = std::filesystem;

TEST_CASE("no text of a unit is written but where a quantity gives it") {
    const std::map<std::string, std::string> allowed{
        {"physics/units/quantity.cpp", "makes them"},
        {"panels/plots/speed_classes.cpp", "per cent in a title, in all languages"},
    };
    const std::string base = "(length|mass|time)", power = R"((\^[\d.]+)?)";
    const std::regex unit(
        base + R"(\^[\d.])" + "|^(1|" + base + power + ")/" + base + power + "$|mass" + power +
        " length|" +
        R"(\w.* \((1|count|number|per cent|length|mass|time|speed|energy)\)|\{\} \(per cent\))" +
        "|energy/(area|volume)|contact distances");
    const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re"), comment(R"(^\s*//)");
    const fs::path source = carom::test::checkout() / "src";
    std::map<std::string, std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) {
            if (std::regex_search(line, comment)) continue;
            line = std::regex_replace(line, std::regex("///?<? .*"), "");
            for (std::sregex_iterator at(line.begin(), line.end(), literal), end; at != end; ++at) {
                const std::string text = (*at)[1];
                if (std::regex_search(text, unit))
                    found.emplace(fs::relative(entry.path(), source).string(), text);
            }
        }
    }
    for (const auto& [name, text] : found) {
        CAPTURE(name);
        CAPTURE(text);
        CHECK(allowed.contains(name));
    }
    for (const auto& [name, reason] : allowed) {
        CAPTURE(name);
        CHECK(found.contains(name));
    }
}
