// Fuzz target: a figure set with its scenes, as `carom check` reads it, and the same text as the
// template of a page in each page language.
#include "app/check/check_facts.h"
#include "app/figures/figure_pages.h"
#include "app/figures/set_loading.h"
#include "fuzz/fuzz.h"
#include "runs/own_files.h"

using namespace carom;

namespace {

constexpr const char* scene =
    "title: T\nbox: {size: [20, 15]}\ngas: [{name: a, count: 4, radius: 0.3, speed: 1}]\n"
    "run: {until: 2, events: [{at: 1, reverse: velocities}]}\nfilm: {seconds: 1, size: [160, "
    "120]}\n"
    "figures: [{name: a, kind: gas}, {name: b, kind: speed-histogram}]\n";

// The file of the set lies next to one scene and below another.
const std::filesystem::path& set_file() {
    static const std::filesystem::path path = [] {
        std::filesystem::create_directories(test::fuzz_folder() / "sets");
        for (const char* name : {"a.yaml", "sets/b.yaml"})
            std::ofstream(test::fuzz_folder() / name) << scene;
        return test::fuzz_folder() / "sets/set.yaml";
    }();
    return path;
}

void check_set() {
    const FigureSet set = load_set(set_file().string(), scene_resources(), {});
    for (const PageTemplate& page : set.pages) page_text(set, page, {}, {});
    refuse_same_names(set);
    const CheckedFile file{.path = "set.yaml", .is_set = true, .facts = facts_of(set)};
    check_json({&file, 1});
}

PageFields fields() {
    PageFields figure{.words = {{"name", "a"}, {"title", "<&$"}},
                      .formulated = {{"caption", "A $v^2$ & \\$"}},
                      .files = {{"picture", "a b.svg"}, {"svg", "a b.svg"}}};
    PageFields page{.words = {{"title", "T"}, {"language", "en"}}};
    page.lists["figures"] = {figure, figure};
    page.lists["sections"] = {{.words = {{"title", "S"}}, .lists = {{"figures", {figure}}}}};
    page.lists["films"] = {};
    return page;
}

}  // namespace

void test::fuzz(const std::uint8_t* data, std::size_t size) {
    const std::string text = test::fuzz_text(data, size);
    std::ofstream(set_file(), std::ios::binary) << text;
    test::succeeds(check_set);
    for (const PageKind kind : {PageKind::markdown, PageKind::html, PageKind::latex})
        test::succeeds([&] { filled_page({"page", text}, kind, fields()); });
}
