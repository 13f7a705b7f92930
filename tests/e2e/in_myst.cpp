// Scenes in documents of MyST Markdown, by the plugin in integrations/myst. Skipped where ./dev
// setup full has not installed mystmd from npm, or Node.js is older than 20, which it is built for.
// Themes of its pages come from a server, and are not tried.
#include <fmt/format.h>

#include <cstdlib>

#include "e2e/in_documents.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

const fs::path myst = root / "build/npm/node_modules/.bin/myst";

bool has_myst() {
    const std::string version = run({"node", "--version"}).out;  // v20.1.2
    const bool is_new = version.starts_with("v") && std::atoi(version.c_str() + 1) >= 20;
    if (is_new && fs::exists(myst)) return true;
    MESSAGE("mystmd or Node.js 20 is not installed (./dev setup full): the plugin is not tried");
    return false;
}

// page.md in a format, as `name`.
Outcome made(const ExampleDocuments& example, const std::string& format, const std::string& name) {
    return example.call(
        {myst.string(), "build", "page.md", "--" + format, "--force", "--ci", "-o", name});
}

}  // namespace

TEST_CASE("a MyST document has the film, the picture and the figure of the example") {
    if (!has_myst()) return;
    const ExampleDocuments example;
    const Outcome outcome = made(example, "jats", "page.xml");
    CAPTURE(outcome.out);
    REQUIRE(outcome.exit_code == 0);
    const std::string page = example.text("page.xml");
    CHECK(has(page, "<caption>\n<p>One fast disk meets <italic>forty</italic> slow ones</p>"));
    CHECK(has(page, "<alt-text>A fast disk flies into forty slow ones."));
    CHECK(has(page, "<alt-text>Most disks are slow, and none is much faster"));
    CHECK(has(page, "<xref ref-type=\"fig\" rid=\"figure-1\">Figure\u00a01</xref>"));
    CHECK(has(page, "<xref ref-type=\"fig\" rid=\"figure-2\">Figure\u00a02</xref>"));
    CHECK(has(page, "mime-subtype=\"mp4\""));
    CHECK(has(page, "mime-subtype=\"svg\""));
    std::size_t pictures = 0;
    for (const auto& file : fs::directory_iterator(example.path("files"))) {
        CHECK(fs::file_size(file) > 1000);
        ++pictures;
    }
    CHECK(pictures == 3);
    const std::string film = example.media(".mp4").at(0);
    const auto written = fs::last_write_time(example.path("carom-media/" + film));
    made(example, "md", "again.md");
    CHECK(has(example.text("again.md"), "[Transcript of the film]("));
    CHECK(has(example.text("again.md"), ":placeholder: carom-media/"));
    CHECK(fs::last_write_time(example.path("carom-media/" + film)) == written);
    CHECK(example.media(".mp4").size() == 1);
}

TEST_CASE("a hostile MyST document is refused by the plugin, or its words are words") {
    if (!has_myst()) return;
    const ExampleDocuments example;
    std::string page = "# Hostile\n\n";
    std::size_t names = 0;
    for (const std::string& name : hostile_names) {
        if (has(name, "`")) continue;  // no code block then
        page += fmt::format("```{{carom}} {}\n```\n\n", name);
        ++names;
    }
    const std::vector<std::string> options{":at: 1; touch pwned", ":theme: $(touch pwned)",
                                           ":kind: ../x", ":at: 99"};
    for (const std::string& option : options)
        page += fmt::format("```{{carom}} gas.yaml\n{}\n```\n\n", option);
    page +=
        "```{carom} gas.yaml\n:kind: gas\n:alt: \"\\\"><script>pwned()</script>\"\n"
        "Words\n```\n";
    example.write("page.md", page);
    const Outcome outcome = made(example, "jats", "page.xml");
    CAPTURE(outcome.out);
    CHECK_FALSE(fs::exists(example.path("pwned")));
    const std::string said = outcome.out + outcome.err;
    std::size_t refused = 0;
    for (std::size_t at = 0; (at = said.find("carom: a scene is named by", at)) != said.npos; ++at)
        ++refused;
    CHECK(refused == names);
    CHECK(has(said, "carom: :at: \"1; touch pwned\": expected a simulated time"));
    CHECK(has(said, "carom: :theme: \"$(touch pwned)\": expected light, dark or print"));
    CHECK(has(said, "carom: :kind: \"../x\": expected the kind of a figure"));
    CHECK(has(said, "--at 99: the scene runs from 0 to 4"));
    CHECK(has(example.text("page.xml"), "pwned()"));
    CHECK_FALSE(has(example.text("page.xml"), "<script"));
}
