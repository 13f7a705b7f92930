// All that a frame says in another language than English is in that language, or the scene's own.
#include "util/language.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "draw/text.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "support/library.h"
#include "support/resources.h"
#include "support/scene_text.h"
#include "support/share_of_cases.h"
#include "support/shot.h"
#include "support/test_root.h"
#include "util/text.h"

using namespace carom;
using test::Shot;

namespace {

std::string without_markup(const std::string& markup) {
    static const std::regex tag("<[^>]*>"), entity("&(lt|gt|amp|quot|#39|apos);");
    return std::regex_replace(std::regex_replace(markup, tag, ""), entity, " ");
}

// Runs of letters, of two at least: what is shorter is a symbol or a number.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words(1);
    for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
        end = next_code_point(text, at);
        const auto lead = static_cast<unsigned char>(text[at]);
        const std::string letter = text.substr(at, end - at);
        const bool is_latin =
            std::isalpha(lead) != 0 || (lead >= 0xC3 && lead <= 0xC9 && letter != "×");
        if (is_latin)
            words.back() += letter;
        else if (!words.back().empty())
            words.emplace_back();
    }
    std::erase_if(words, [](const std::string& word) { return word.size() < 2; });
    return words;
}

std::set<std::string> words_in(Language language) {
    std::set<std::string> known;
    for (const phrases::Row& row : phrases::all())
        for (const std::string& word :
             words_of(without_markup(std::string(row[static_cast<std::size_t>(language)])))) {
            known.insert(word);
            known.insert(capitalised(word));
        }
    return known;
}

void add_own_words(const Scene& scene, std::set<std::string>& known) {
    const auto add = [&](const std::string& text) {
        for (const std::string& word : words_of(text)) {
            known.insert(word);
            known.insert(capitalised(word));
        }
    };
    add(scene.title + " " + scene.subtitle + " " + scene.film.end_card);
    for (const Caption& caption : scene.captions) add(caption.words);
    for (const Mark& mark : scene.marks) add(mark.words);
    for (const Species& species : scene.gas.species) add(species.name);
    for (const SpeciesLook& look : scene.looks) add(look.label);
    for (const Callout& callout : scene.film.callouts) add(callout.words);
    for (const PanelSpec& panel : scene.film.panels) {
        const PanelKind& kind = kind_of(panel);
        add(panel.title.value_or("") + " " + (kind.text ? kind.text(panel) : ""));
    }
    for (const std::string& name : scene.gas.box.surfaces.names()) add(name);
}

// The lines of three frames: at the start, in the middle, at the end.
std::vector<std::string> lines_of(const Scene& scene) {
    const Shot film(scene);
    FramePainter painter(*film.panels);
    std::vector<std::string> lines;
    painter.paint(film.frames.front());  // the ground is drawn once
    const TextLog log;
    FramePainter logged(*film.panels);
    for (const std::size_t k : {std::size_t{0}, film.frames.size() / 2, film.frames.size() - 1})
        logged.paint(film.frames[k]);
    for (const DrawnLine& line : log.lines) lines.push_back(without_markup(line.markup));
    return lines;
}

Scene library_scene(const std::string& name, const std::string& language) {
    return load_scene(test::library_file(name), test::resources(),
                      {"film.language=" + language, "film.fps=2", "film.size=[1280, 720]",
                       "run.precision=double"});
}

}  // namespace

TEST_CASE("frames speak the scene's language, and write its numbers") {
    for (const char* name :
         {"one-hot-particle", "mixed-masses", "single-collision", "heat-flow", "tonks-gas",
          "equal-masses-in-one-dimension", "reversal-precision", "gas-under-a-weight"}) {
        for (const auto& spoken : {std::pair{Language::german, "de"}, {Language::spanish, "es"}}) {
            const Language language = spoken.first;
            const char* const code = spoken.second;
            const Scene scene = library_scene(name, code);
            std::set<std::string> known = words_in(language);
            add_own_words(scene, known);
            for (const std::string& line : lines_of(scene)) {
                const std::string of = name;
                CAPTURE(of);
                CAPTURE(line);
                for (const std::string& word : words_of(line))
                    CHECK_MESSAGE(known.contains(word), "not in ", code, ": ", word);
                static const std::regex point("[0-9]\\.[0-9]");
                CHECK_FALSE(std::regex_search(line, point));
            }
        }
    }
}

TEST_CASE("words that carom writes have room in every language") {
    int number = 0;
    for (const char* name :
         {"brownian-motion", "entropy-reversed", "free-expansion", "free-gas", "second-law"})
        for (const char* code : {"en", "de", "fr", "es"}) {
            if (number++ % test::every_nth(1, 3) != 0) continue;
            const Scene scene = library_scene(name, code);
            const Shot film(scene, 40);
            FramePainter painter(*film.panels);
            const TextLog log;
            for (const std::size_t k : {std::size_t{0}, film.frames.size() - 1})
                painter.paint(film.frames[k]);
            for (const DrawnLine& line : log.lines)
                CHECK_FALSE_MESSAGE(line.is_cut, name, ", ", code, ": ", line.markup);
        }
}

TEST_CASE("a caption that carom makes is in the scene's language, the scene's words are not") {
    const Scene scene = test::scene_from(
        "title: Own words\nbox: {size: [40, 30.5]}\ngas: [{count: 3, radius: 0.5, speed: 1.5}]\n"
        "run: {until: 4, events: [{at: 2, reverse: velocities}]}\nfilm: {language: de}\n");
    CHECK(scene.title == "Own words");
    CHECK(scene.description ==
          "3 Scheiben, mit Geschwindigkeit 1,5, starten in einem Kasten von 40 mal 30,5 mit festen "
          "Wänden und stoßen elastisch. Zur Zeit 2 werden alle Geschwindigkeiten umgekehrt.");
}
