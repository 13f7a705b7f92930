// Pages: what placeholders become, and how mistakes in a template are told.
#include "figures/page.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "support/files.h"
#include "support/test_root.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

std::string filled(const std::string& text, const PageFields& fields,
                   PageKind kind = PageKind::html) {
    return filled_page({"page.html", text}, kind, fields);
}

PageFields two_figures() {
    PageFields one, two, page;
    one.words = {{"name", "a"}, {"caption", "A & B"}, {"title", "inner"}};
    one.files = {{"csv", "a b.csv"}};
    two.words = {{"name", "b"}, {"caption", ""}, {"title", "inner"}};
    two.files = {{"csv", ""}};
    page.words = {{"title", "outer"}};
    page.lists["figures"] = {one, two};
    page.lists["films"] = {};
    return page;
}

std::string message(const std::string& text) {
    try {
        filled(text, {});
    } catch (const SceneError& error) {
        std::string all;
        for (const Diagnostic& one : error.diagnostics()) all += to_text(one) + "\n";
        return all;
    }
    return "";
}

}  // namespace

TEST_CASE("placeholders become words, lists and nothing") {
    const PageFields page = two_figures();
    CHECK(filled("{{title}}: {{#figures}}[{{name}} {{title}}]{{/figures}}", page) ==
          "outer: [a inner][b inner]");
    CHECK(filled("{{#figures}}{{#csv}}{{csv}};{{/csv}}{{^csv}}none{{/csv}}{{/figures}}", page) ==
          "a%20b.csv;none");
    CHECK(filled("{{^films}}no film{{/films}}{{#films}}film{{/films}}", page) == "no film");
    CHECK(filled("a{{! says nothing }}b", page) == "ab");
    CHECK(filled("{{{title}}}", page, PageKind::latex) == "{outer}");
}

TEST_CASE("the program's words have the language of the item around them, or of the page") {
    PageFields page = two_figures();
    page.language = Language::german;
    page.lists["figures"][0].language = Language::spanish;
    CHECK(filled("{{_Figure}}{{#figures}} {{_Figure}}{{/figures}}", page) ==
          "Abbildung Figura Abbildung");
    CHECK(filled("{{_Figure}}", {}) == "Figure");
}

TEST_CASE("a line with nothing but the tag of a list leaves no line") {
    CHECK(filled("{{#figures}}\n- {{name}}\n{{/figures}}\nend\n", two_figures()) ==
          "- a\n- b\nend\n");
    CHECK(filled("{{! words }}\nx\n", two_figures()) == "x\n");
}

TEST_CASE("mistakes in a template are told with their place") {
    CHECK(message("<p>\n{{#figures}}{{captoin}}{{/figures}}") ==
          "page.html:2:13: error: `captoin` is no placeholder in `figures`\n"
          "    2 | {{#figures}}{{captoin}}{{/figures}}\n"
          "      |             ^\n"
          "  hint: did you mean `caption`?\n");
    CHECK(message("{{caption}}").find("`caption` is no placeholder of a page") !=
          std::string::npos);
    CHECK(message("{{figures}}").find("`figures` is a list") != std::string::npos);
    CHECK(message("{{#figures}}").find("`figures` is not closed") != std::string::npos);
    CHECK(message("{{/figures}}").find("`figures` is closed, and is not open here") !=
          std::string::npos);
    CHECK(message("x {{title").find("1:3: error: a placeholder that is not closed") !=
          std::string::npos);
    CHECK(message("{{}}").find("is no placeholder of a page") != std::string::npos);
    CHECK(message("{{#figures}}\n{{#figures}}").find("2:1: error: `figures` is inside itself") !=
          std::string::npos);
    CHECK(message("<p>\nGr\xFCn").starts_with("page.html:2:3: error: byte 0xFC is not UTF-8"));
}

TEST_CASE("a template of many stretches takes time and memory as its size") {
    const auto repeated = [](const std::string& text, int count) {
        std::string all;
        while (count-- > 0) all += text;
        return all;
    };
    // One in another: without an end to it, each would keep the names of all around it.
    for (const char* tag : {"figures", "title"}) {
        const std::string open = repeated("{{#" + std::string(tag) + "}}", 100'000);
        CHECK(message(open).find("more than 24 levels, one in another") != std::string::npos);
    }
    CHECK(filled(repeated("{{#title}}", 24) + "x" + repeated("{{/title}}", 24),
                 {.words = {{"title", "T"}}}) == "x");
    // Beside one another: what is not shown needs no hint.
    CHECK(message(repeated("{{ttile}}", 100'000)).find("`title`") != std::string::npos);
}

TEST_CASE("the templates of pages know their placeholders, and the manual knows all") {
    const std::filesystem::path root = carom::test::checkout();
    for (const auto& entry : std::filesystem::directory_iterator(root / "templates/documents")) {
        CAPTURE(entry.path().string());
        CHECK_NOTHROW(filled(test::contents(entry.path()), {}));
    }
    const std::string manual = test::contents(root / "docs/figures.md");
    for (const auto& [list, names] : placeholders())
        for (const std::string& name : names) {
            CAPTURE(name);
            CHECK(manual.find("`" + name + "`") != std::string::npos);
        }
}
