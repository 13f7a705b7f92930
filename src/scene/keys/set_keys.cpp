// The keys of figure sets.
#include <algorithm>
#include <utility>

#include "scene/keys/key_table.h"

namespace carom::keys {
namespace {

using std::string;
using std::vector;

Section set_scene() {
    return complete(
        {.name = "an item of `scenes`",
         .keys = {
             required({"scene",
                       "The scene's file, relative to the set; it may lie in the folder above the "
                       "set's.",
                       {text(1, most_title_letters)}}),
             left_to("the scene's",
                     {"title", "Its title in the set.", {text(1, most_title_letters)}}),
             left_to("the scene's",
                     {"description", "The words under it.", {lines(1, most_letters)}}),
             left_to("all of the scene", {"figures",
                                          "The names of the figures that are shown, in this order.",
                                          {list_of({text(1, most_name_letters)}, 1, most_figures,
                                                   "a list of names")}})}});
}

// A figure whose runs are those of several scenes.
Section comparison() {
    const Section run = complete(
        {.name = "an item of a comparison's `scenes`",
         .keys = {required({"scene",
                            "The scene's file, relative to the set; it may lie in the folder above "
                            "the set's.",
                            {text(1, most_title_letters)}}),
                  left_to("the scene's title",
                          {"label", "Its name in the figure.", {text(1, most_name_letters)}}),
                  changes()}});
    Form file = text(1, most_title_letters);
    file.phrase = "the path of a scene";
    vector<Key> keys;
    for (const Key& key : figure().keys) {
        const bool left_out = key.name == "seeds" || key.name == "test" || key.name == "strip" ||
                              key.name == "compare" || key.name == "numbers" ||
                              key.name == "words" || key.name == "reference";
        if (left_out) continue;
        keys.push_back(key);
        std::erase_if(keys.back().with, [](const string& kind) {
            return std::ranges::find(compared(), kind) == compared().end();
        });
        if (key.name != "kind") continue;
        keys.back().forms = {one_of(compared())};
        keys.push_back(
            required({"scenes",
                      "The scenes whose runs it shows in one panel with shared axes and a key.",
                      {list_of({file, mapping(run)}, 2, most_compared, "a list of scenes")}}));
    }
    return complete(
        {.name = "a comparison", .keys = std::move(keys), .choices = {{{"at", "over"}}}});
}

}  // namespace

Section figure_set() {
    const Form page = text(1, most_title_letters);
    const Form format = one_of({"svg", "pdf", "png", "csv"});
    Form file = text(1, most_title_letters);
    file.phrase = "the path of a scene";
    return complete(
        {.name = "a figure set",
         .keys = {
             required({"title", "The title of its pages.", {text(1, most_title_letters)}}),
             left_to("none",
                     {"description", "What the set shows, in words.", {lines(1, most_letters)}}),
             required(
                 {"scenes",
                  "The scenes whose figures it holds, in the order of the pages' sections.",
                  {list_of({file, mapping(set_scene())}, 1, most_set_scenes, "a list of scenes")}}),
             left_to(
                 "none",
                 {"comparisons",
                  "Figures of several scenes in one panel, in the last section of the pages.",
                  {list_of({mapping(comparison())}, 1, most_figures, "a list of comparisons")}}),
             otherwise("html",
                       {"template",
                        "The pages: `markdown`, `html`, `latex`, or a template beside the set, a "
                        "file that ends in .md, .html or .tex; or a list of these.",
                        {page, list_of({page}, 1, 3, "a list of templates")}}),
             left_to("all", {"formats",
                             "The kinds of files of its figures.",
                             {list_of({format}, 1, 4, "a list of formats")}})}});
}

}  // namespace carom::keys
