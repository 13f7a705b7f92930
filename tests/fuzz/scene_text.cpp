// Fuzz target: the text of a scene, as `carom check` reads it. It is loaded, described and its cost
// estimated, or it is rejected.
#include "app/check/check_facts.h"
#include "films/words/letters.h"
#include "fuzz/fuzz.h"
#include "panels/words/text_panel.h"
#include "runs/own_files.h"
#include "scene/describe.h"

using namespace carom;

namespace {

void check(const std::string& text, Wanted wanted) {
    static const SceneResources resources = scene_resources();
    const Scene scene = load_scene_text(text, "scene.yaml", resources, {}, wanted);
    if (describe(scene).empty()) std::abort();
    if (wanted == Wanted::film) refuse_long_words(scene);
    require_letters(scene);
    std::optional<CheckedFilm> film;
    if (wanted == Wanted::film) film = CheckedFilm{.formats = formats_with_costs()};
    const CheckedFile file{.path = "scene.yaml", .facts = facts_of(scene, film)};
    if (check_table({&file, 1}).empty() || check_json({&file, 1}).empty()) std::abort();
}

}  // namespace

void test::fuzz(const std::uint8_t* data, std::size_t size) {
    const std::string text = test::fuzz_text(data, size);
    for (const Wanted wanted : {Wanted::film, Wanted::figures, Wanted::physics})
        test::succeeds([&] { check(text, wanted); });
}
