// The player of a film is written by the filter of pandoc and by the extension of Jupyter: both
// have the same elements with the same attributes.
#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "e2e/in_documents.h"

using namespace carom::test;

namespace {

using Attributes = std::map<std::string, std::string>;

// The elements of the first video, each with its attributes; of addresses, of words that the
// document chooses, and of classes it matters only that they are there.
std::vector<std::pair<std::string, Attributes>> player_in(const std::string& html) {
    const std::size_t begin = html.find("<video"), end = html.find("</video>");
    REQUIRE(begin < end);
    REQUIRE(end != html.npos);
    std::string video = html.substr(begin, end - begin);
    const std::string data = "=\"data:";  // too long for expressions of the standard library
    for (std::size_t at = video.find(data); at != video.npos; at = video.find(data, at + 1)) {
        const std::size_t from = at + data.size();
        video.erase(from, video.find('"', from) - from);
    }
    const std::regex element("<([a-z]+)((?: [a-z-]+(?:=\"[^\"]*\")?)*)>"),
        attribute(" ([a-z-]+)(?:=\"([^\"]*)\")?");
    const std::set<std::string> own{"src", "poster", "aria-label"};
    std::vector<std::pair<std::string, Attributes>> elements;
    for (std::sregex_iterator at(video.begin(), video.end(), element), none; at != none; ++at) {
        auto& [name, attributes] = elements.emplace_back((*at)[1].str(), Attributes{});
        const std::string all = (*at)[2].str();
        for (std::sregex_iterator one(all.begin(), all.end(), attribute); one != none; ++one)
            if (const std::string key = (*one)[1].str(); key != "class")
                attributes[key] = own.contains(key) ? "its own" : (*one)[2].str();
    }
    return elements;
}

}  // namespace

TEST_CASE("the players of pandoc and of Jupyter have the same elements") {
    if (!is_installed("pandoc")) {
        MESSAGE("pandoc is not installed: its player is not compared");
        return;
    }
    const ExampleDocuments example;
    example.write("one.md", "![Words](gas.yaml)\n");
    const Outcome page = example.call({"pandoc", "one.md", "-L", "../pandoc/carom.lua"});
    CAPTURE(page.err);
    REQUIRE(page.exit_code == 0);
    const Outcome notebook =
        example.call({"/usr/bin/python3", "-c",
                      "import sys\nsys.path.insert(0, '../jupyter')\nimport carom_jupyter\n"
                      "print(carom_jupyter.film('gas.yaml')._repr_html_())"});
    CAPTURE(notebook.err);
    REQUIRE(notebook.exit_code == 0);
    const auto player = player_in(page.out);
    CHECK(player == player_in(notebook.out));

    REQUIRE(player.size() == 5);
    CHECK(player[0].first == "video");
    const Attributes video{{"controls", ""},        {"playsinline", ""},
                           {"preload", "metadata"}, {"style", "max-width:100%"},
                           {"poster", "its own"},   {"aria-label", "its own"}};
    CHECK(player[0].second == video);
    CHECK(player[1].second == Attributes{{"src", "its own"}, {"type", "video/mp4"}});
    for (std::size_t i = 2; i < player.size(); ++i) {
        const std::string kind = std::vector{"captions", "chapters", "descriptions"}[i - 2];
        Attributes track{{"kind", kind}, {"src", "its own"}, {"srclang", "en"}, {"label", kind}};
        if (kind == "captions") track["default"] = "";
        CHECK(player[i].second == track);
    }
}
