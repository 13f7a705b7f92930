// Every sentence of the library's scenes makes a claim that is measured, or is listed in
// without_claim.txt.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "captions/claims.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "support/library.h"
#include "support/resources.h"

namespace carom::test {

// The bounds of a number that cannot be measured are missed, too, unless 0 lies between them.
void check(const std::vector<SceneClaims>& table) {
    for (const SceneClaims& claims : table) {
        CAPTURE(claims.scene);
        const Course& run = course(claims.scene);
        for (const Claim& claim : claims.claims) {
            CAPTURE(claim.words);
            double measured = 0.0;
            CHECK_NOTHROW(measured = claim.measured.of(run));
            CHECK(measured >= claim.bounds.least);
            CHECK(measured <= claim.bounds.most);
        }
    }
}

namespace {

std::vector<std::string> texts_of(const Scene& scene) {
    std::vector<std::string> texts{scene.subtitle, scene.description, scene.film.end_card};
    for (const Caption& caption : scene.captions) texts.push_back(caption.words);
    for (const Callout& callout : scene.film.callouts) texts.push_back(callout.words);
    for (const PanelSpec& panel : scene.film.panels)
        if (const PanelKind& kind = kind_of(panel); kind.text) texts.push_back(kind.text(panel));
    for (const FigureSpec& figure : scene.figures) texts.push_back(figure.caption.value_or(""));
    return texts;
}

// Sentences end with a full stop before a capital letter or a digit; white space is one space.
void add_sentences(const std::string& text, std::vector<std::string>& sentences) {
    std::istringstream words(text);
    std::string sentence;
    for (std::string word; words >> word;) {
        const bool ends = sentence.ends_with('.') && word.find_first_of(
                                                         "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                         "0123456789") == 0;
        if (ends) sentences.push_back(sentence), sentence.clear();
        sentence += (sentence.empty() ? "" : " ") + word;
    }
    if (!sentence.empty()) sentences.push_back(sentence);
}

using Sentences = std::map<std::string, std::vector<std::string>>;  // by the names of scenes

Sentences sentences_of_library() {
    Sentences all;
    for (const auto& file : library_files()) {
        std::vector<std::string>& sentences = all[file.stem().string()];
        for (const std::string& text : texts_of(load_scene(file, resources())))
            add_sentences(text, sentences);
    }
    return all;
}

// The file has the name of each scene in brackets and then a sentence in each line.
Sentences sentences_without_claim() {
    Sentences all;
    std::ifstream file(checkout() / "tests/captions/without_claim.txt");
    std::string scene;
    for (std::string line; std::getline(file, line);)
        if (line.starts_with('['))
            scene = line.substr(1, line.size() - 2);
        else if (!line.empty())
            all[scene].push_back(line);
    return all;
}

std::vector<std::vector<SceneClaims>> claims_of_library() {
    return {claims_of_classics(), claims_of_gaslab(), claims_of_others(), claims_of_beads(),
            claims_of_space()};
}

bool is_in(const std::vector<std::string>& sentences, const std::string& words) {
    return std::ranges::any_of(sentences, [&](const std::string& sentence) {
        return sentence.find(words) != std::string::npos;
    });
}

}  // namespace

TEST_CASE("captions are measured for the time at which they are shown") {
    for (const auto& table : claims_of_library())
        for (const SceneClaims& claims : table) {
            const Scene scene = load_scene(library_file(claims.scene), resources());
            for (const Claim& claim : claims.claims) {
                std::optional<double> shown_from;
                for (const Caption& caption : scene.captions)
                    if (caption.words.find(claim.words) != std::string::npos)
                        shown_from = caption.at;
                CAPTURE(claims.scene);
                CAPTURE(claim.words);
                CHECK(shown_from == claim.shown_from);
            }
        }
}

TEST_CASE("every sentence of a scene is measured, or known to claim nothing") {
    Sentences all = sentences_of_library();
    Sentences without = sentences_without_claim();
    std::map<std::string, std::vector<std::string>> claimed;
    for (const auto& table : claims_of_library())
        for (const SceneClaims& claims : table)
            for (const Claim& claim : claims.claims) {
                claimed[claims.scene].push_back(claim.words);
                CAPTURE(claims.scene);
                CAPTURE(claim.words);
                CHECK_MESSAGE(is_in(all[claims.scene], claim.words), "no scene has these words");
            }
    for (const auto& [scene, sentences] : all)
        for (const std::string& sentence : sentences) {
            CAPTURE(scene);
            CAPTURE(sentence);
            const bool is_measured =
                std::ranges::any_of(claimed[scene], [&](const std::string& words) {
                    return sentence.find(words) != std::string::npos;
                });
            const bool is_listed = std::ranges::count(without[scene], sentence) > 0;
            CHECK_MESSAGE(is_measured != is_listed,
                          "measure what it claims, or list it in without_claim.txt");
        }
    for (const auto& [scene, sentences] : without)
        for (const std::string& sentence : sentences) {
            CAPTURE(scene);
            CAPTURE(sentence);
            CHECK_MESSAGE(std::ranges::count(all[scene], sentence) > 0, "no scene has it");
        }
}

}  // namespace carom::test
