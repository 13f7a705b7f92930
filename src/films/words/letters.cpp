#include "films/words/letters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "draw/text.h"
#include "panels/registry.h"
#include "scene/keys/numbers_in_words.h"
#include "scene/panel_kind.h"
#include "scene/scene.h"
#include "util/formula/formula.h"

namespace carom {
namespace {

// Adds only the words inside a formula: its other letters come from a fixed set and are not
// checked.
void add_words(const formula::Parts& parts, std::string& words) {
    for (const formula::Part& part : parts) {
        words += part.words;
        for (const formula::Parts* inner :
             {&part.body, &part.below, &part.above_index, &part.below_index})
            add_words(*inner, words);
    }
}

std::string plain(const std::string& text) {
    std::string words;
    for (const formula::Span& span : formula::spans_of(with_usual_numbers(text))) {
        if (span.is_formula)
            add_words(formula::parsed(span.text), words);
        else
            words += span.text;
    }
    return words;
}

// Collects all texts of a scene that are drawn as they are written.
class Words {
  public:
    void add(const Scene& scene) {
        all += scene.title + scene.subtitle;
        for (const Species& species : scene.gas.species) all += species.name;
        for (const SpeciesLook& look : scene.looks) all += look.label;
        for (const std::string& name : scene.gas.box.surfaces.names()) all += name;
        for (const Mark& mark : scene.marks) all += mark.words;
        for (const Caption& caption : scene.captions) all += plain(caption.words);
        add(scene.film);
        for (const FigureSpec& figure : scene.figures) {
            add(figure.panel);
            for (const ComparedRun& run : figure.compare) all += run.label;
        }
    }

    std::string all;

  private:
    void add(const Film& film) {
        for (const PanelSpec& panel : film.panels) add(panel);
        for (const Callout& callout : film.callouts) all += plain(callout.words);
        all += plain(film.end_card);
        for (const std::string& label : film.runs.labels()) all += label;
        for (const ComparedRun& run : film.runs.others)
            if (run.scene) add(*run.scene);
    }

    void add(const PanelSpec& panel) {
        const PanelKind& kind = kind_of(panel);
        all += panel.title.value_or("");
        if (kind.text) all += plain(kind.text(panel));
        for (const NamedRegion& region : places_of(panel).regions) all += region.name;
        if (!kind.names) return;
        for (const std::string& name : kind.names(panel)) all += name;
    }
};

void require_letters_of(std::string words, const std::string& path) {
    require_font();
    std::erase(words, '\n');  // a paragraph break, not a letter
    std::vector<std::string> missing = missing_letters(words);
    if (missing.empty()) return;
    constexpr std::size_t most = 12;
    const bool more = missing.size() > most;
    if (more) missing.resize(most);
    throw MissingLetters(path,
                         fmt::format("no font on this machine has {}{}", fmt::join(missing, " "),
                                     more ? " and more letters" : ""));
}

}  // namespace

MissingLetters::MissingLetters(const std::string& scene, const std::string& letters)
    : SystemError(fmt::format("{}: {}: {}", scene, letters, hint)),
      path(scene),
      what_is_missing(letters) {}

void require_letters(const Scene& scene) {
    Words words;
    words.add(scene);
    require_letters_of(std::move(words.all), scene.source.path);
}

void require_letters(const std::string& words, const std::string& path) {
    require_letters_of(words, path);
}

}  // namespace carom
