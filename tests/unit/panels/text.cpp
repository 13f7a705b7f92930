// Panels of words: as large as they fit, whole, and refused where they do not.
#include "draw/text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "panels/frame.h"
#include "panels/layout.h"
#include "panels/words/text_panel.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

std::string joined(const SetWords& set) {
    std::string text;
    for (const std::string& line : set.lines) text += (text.empty() ? "" : " ") + line;
    return text;
}

Scene scene_of(const std::string& panels) {
    return test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 4, speed: 1}]\nrun: {until: 4}\n"
        "film: {seconds: 1, fps: 4, size: [640, 360], template: lecture, panels: [" +
        panels + "]}\n");
}

std::string words_of(std::size_t count) {
    std::string words = "words";
    while (count-- > 1) words += " words";
    return words;
}

std::string complaint(const std::string& panels) {
    try {
        refuse_long_words(scene_of(panels));
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("words are set whole, inside their place, the larger the fewer they are") {
    double last = 1e9;
    for (const std::size_t count : {2U, 12U, 24U, 40U, 55U}) {
        const std::string words = words_of(count);
        const auto set = set_words(words, 240.0, 120.0, 10.0);
        REQUIRE(set);
        CHECK(joined(*set) == words);
        CHECK(height_of(*set) <= 120.0);
        for (const std::string& line : set->lines)
            CHECK(measure_text(line, {.size = set->size, .color = {}, .tabular = false}).width <=
                  240.0);
        CHECK(set->size <= last);
        last = set->size;
    }
    CHECK(last < 20.0);
    CHECK(set_words(words_of(2), 240.0, 100.0, 10.0)->size == 20.0);
}

TEST_CASE("words that no step of size makes room for are not set") {
    CHECK(!set_words(words_of(200), 240.0, 100.0, 10.0));
    CHECK(!set_words(std::string(600, 'w'), 240.0, 100.0, 10.0));
}

TEST_CASE("words become smaller before one of them is broken") {
    // The first word alone is wider than a line at 20 pixels.
    const std::string word = "thermodynamically reversible";
    const auto set = set_words(word, 150.0, 100.0, 10.0);
    REQUIRE(set);
    CHECK(set->size < 20.0);
    CHECK(set->lines == std::vector<std::string>{"thermodynamically", "reversible"});
    // Longer than a line at any size: broken.
    CHECK(set_words(std::string(60, 'w'), 240.0, 100.0, 10.0)->lines.size() > 1);
}

TEST_CASE("lines end where they are ended, and paragraphs stand apart") {
    const auto set = set_words("one\ntwo\n\nthree", 240.0, 100.0, 10.0);
    REQUIRE(set);
    CHECK(set->lines == std::vector<std::string>{"one", "two", "", "three"});
}

TEST_CASE("a line break in a formula is a space") {
    const auto set = set_words("where $r\n^2$ falls\nto $\\sigma^2$", 240.0, 100.0, 10.0);
    REQUIRE(set);
    CHECK(set->lines == std::vector<std::string>{"where $r ^2$ falls", "to $\\sigma^2$"});
    const std::string panel = R"({kind: text, words: "where $r\n^2$ falls"})";
    CHECK(complaint(panel).empty());
}

TEST_CASE("words are refused by the place that a panel has in the picture, beside a narrow box") {
    const auto complaint_in = [](const std::string& box) -> std::string {
        const Scene scene =
            test::scene_from("title: T\nbox: {size: " + box +
                             "}\ngas: [{count: 4, speed: 1}]\nrun: {until: 4}\n"
                             "film: {seconds: 1, fps: 4, panels: [{kind: text, words: \"" +
                             words_of(50) + "\"}]}\n");
        refuse_long_words(scene);  // by the template they fit
        try {
            test::Shot shot(scene, 1);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    };
    CHECK(complaint_in("[66, 30]").empty());
    CHECK(complaint_in("[44, 30]").find("do not fit") != std::string::npos);
}

TEST_CASE("a film with words that do not fit is refused with their place") {
    const std::string few = "{kind: text, words: \"" + words_of(20) + "\"}";
    const std::string many = "{kind: text, title: T, words: \"" + words_of(60) + "\"}";
    CHECK(complaint(few).empty());
    CHECK(complaint(many).empty());  // alone it has all the places
    const std::string message = complaint(few + ", temperature, " + many);
    CHECK(message.find("test:5:") == 0);
    CHECK(message.find("these `words` do not fit into the panel's place at any size") !=
          std::string::npos);
    CHECK_THROWS_AS(test::Shot(scene_of(few + ", temperature, " + many)), SceneError);
}

TEST_CASE("words are no markup") {
    const test::Shot film(scene_of("{kind: text, words: 'a < b & <b>c</b>'}"));
    FramePainter painter(*film.panels);
    Canvas canvas({640, 360}, VectorFormat::svg, {"T", "D"});
    CHECK_NOTHROW(painter.paint_on(canvas, film.frames.front()));
    // As wide as all its letters: markup would have lost some.
    const auto set = set_words("a < b & <b>c</b>", 500.0, 100.0, 10.0);
    REQUIRE(set);
    CHECK(set->lines.front() == "a < b & <b>c</b>");
}

TEST_CASE("a formula makes its line as high as it is, and stands in the middle where it is alone") {
    const auto words = set_words("one\ntwo", 240.0, 200.0, 10.0);
    const auto formula = set_words("one\n$\\frac{a}{b}$", 240.0, 200.0, 10.0);
    REQUIRE(words);
    REQUIRE(formula);
    CHECK(formula->size == words->size);
    CHECK(formula->lines == std::vector<std::string>{"one", "$\\frac{a}{b}$"});
    CHECK(height_of(*formula) > height_of(*words) + 0.5 * words->size);

    const test::Shot film(scene_of("{kind: text, words: \"one\\n$x^2$\"}"));
    FramePainter painter(*film.panels);
    TextLog log;
    painter.paint(film.frames.front());
    const auto line = [&](const std::string& markup) {
        const auto found = std::ranges::find(log.lines, markup, &DrawnLine::markup);
        REQUIRE(found != log.lines.end());
        return found->ink;
    };
    CHECK(line("$x^2$").x > line("one").x + 1.5 * line("one").width);
}

TEST_CASE("a caption with a high formula stays in its line") {
    const Scene scene = test::scene_from(
        "title: T\nbox: {size: [40, 30]}\ngas: [{count: 4, speed: 1}]\nrun: {until: 4, events: "
        "[{at: 0, caption: '$\\frac12 m\\sqrt{\\langle v^2\\rangle}$'}]}\n"
        "film: {seconds: 4, fps: 4, size: [640, 360]}\n");
    const test::Shot film(scene);
    FramePainter painter(*film.panels);
    TextLog log;
    painter.paint(film.frames[8]);
    const auto drawn =
        std::ranges::find(log.lines, scene.captions.front().words, &DrawnLine::markup);
    REQUIRE(drawn != log.lines.end());
    const Rect line = Grid(scene.film.layout, scene.film.size).place(*scene.film.layout.caption);
    CHECK(drawn->ink.y > line.y - 1.0);
    CHECK(drawn->ink.bottom() < line.bottom() + 1.0);
}
