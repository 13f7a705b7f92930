// carom schema: the JSON Schema of scenes, of figure sets, or of styles.
#include <memory>
#include <string>

#include "app/command.h"
#include "app/output.h"
#include "app/report/schema_json.h"

namespace carom {

namespace {

CommandText schema_text() {
    return {{"carom schema [--for scene|set|style]"},
            "Prints the JSON Schema of scenes, of figure sets or of styles, with which editors "
            "complete keys and underline mistakes.",
            {{"carom schema > scene.schema.json", "save it beside your scenes"},
             {"carom schema --for set > set.schema.json", "the schema of figure sets"},
             {"carom schema --for scene", "prints the schema of scenes"}}};
}

}  // namespace

Command schema_command() {
    const auto what = std::make_shared<std::string>("scene");
    return {
        "schema",
        "print the JSON Schema of scenes, for editors",
        {{"--for", "scene, set for figure sets, or style", what.get(), {"scene", "set", "style"}}},
        [what] {
            Output("-").write(*what == "set"     ? set_schema_json()
                              : *what == "style" ? style_schema_json()
                                                 : scene_schema_json());
        },
        schema_text()};
}

}  // namespace carom
