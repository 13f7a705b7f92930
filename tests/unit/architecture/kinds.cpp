// A kind of panel is named only in the file that declares it: what others must know of it is a
// property that it declares (scene/panel_kind.h).
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "support/test_root.h"

namespace fs = std::filesystem;

namespace {

// Texts by their paths in src/.
std::map<std::string, std::string> sources() {
    const fs::path folder = carom::test::checkout() / "src";
    std::map<std::string, std::string> texts;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path());
        texts[fs::relative(entry.path(), folder).string()] =
            std::string(std::istreambuf_iterator<char>(file), {});
    }
    return texts;
}

// Kinds by the file that declares each.
std::map<std::string, std::string> declared_kinds(const std::map<std::string, std::string>& texts) {
    const std::regex declaration(R"re(PanelKind (\w+)_kind\(\) \{[^}]*?\.name = "([a-z-]+)")re");
    std::map<std::string, std::string> files;
    for (const auto& [file, text] : texts)
        for (std::sregex_iterator found(text.begin(), text.end(), declaration), none; found != none;
             ++found) {
            const std::string name = (*found)[2];
            CAPTURE(name);
            std::string function = name;
            std::ranges::replace(function, '-', '_');
            CHECK((*found)[1] == function);
            CHECK(files.emplace(name, file).second);
        }
    return files;
}

// Names that are also keys of scenes, quantities, or words of captions.
const std::set<std::string> ordinary_words{
    "entropy",         "gas",   "monitors",    "piston", "positions", "pressure", "profile",
    "return-distance", "sweep", "temperature", "text"};

// A name where a kind is compared, looked up or made; for one that means nothing else, anywhere.
std::regex use_of(const std::string& name) {
    const std::string quoted = '"' + name + '"';
    if (!ordinary_words.contains(name)) return std::regex(quoted);
    return std::regex(R"re(kind\)?\s*(==|!=)\s*)re" + quoted + "|" + quoted +
                      R"re(\s*(==|!=)\s*[\w.>-]*kind\b|\.kind\s*=\s*)re" + quoted +
                      R"re(|kind_of\([^;]*)re" + quoted + R"re(|panel_of(<\w+>)?\()re" + quoted);
}

}  // namespace

TEST_CASE("a kind of panel is named only in the file that declares it") {
    const std::map<std::string, std::string> texts = sources();
    const std::map<std::string, std::string> files = declared_kinds(texts);
    CHECK(files.size() >= 36);
    for (const auto& [name, its] : files) {
        const std::regex use = use_of(name);
        for (const auto& [file, text] : texts) {
            if (file == its || file == "util/phrases.inc") continue;
            CAPTURE(file);
            CAPTURE(name);
            CHECK_FALSE(std::regex_search(text, use));
        }
    }
}

TEST_CASE(
    "every kind of panel is in the list of all kinds, and declared in the file of its panel") {
    const std::map<std::string, std::string> texts = sources();
    const std::string& list = texts.at("panels/registry.cpp");
    for (const auto& [name, file] : declared_kinds(texts)) {
        CAPTURE(name);
        std::string function = name;
        std::ranges::replace(function, '-', '_');
        CHECK(list.find(function + "_kind()") != std::string::npos);
        CHECK(file.starts_with("panels/"));
    }
    const std::regex listed(R"(\w+_kind\(\))");
    CHECK(std::distance(std::sregex_iterator(list.begin(), list.end(), listed), {}) ==
          static_cast<std::ptrdiff_t>(declared_kinds(texts).size()));
}
