// carom schema: the JSON Schema of scenes, or of figure sets.
#include <memory>
#include <string>

#include "app/command.h"
#include "app/output.h"
#include "app/report/schema_json.h"

namespace carom {

void add_schema(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("schema", "print the JSON Schema of scenes, for editors");
    const auto what = std::make_shared<std::string>("scene");
    command.add_option("--for", *what, "scene, or set: a figure set")
        ->check(CLI::IsMember({"scene", "set"}));
    command.callback(
        [what] { Output("-").write(*what == "set" ? set_schema_json() : scene_schema_json()); });
}

}  // namespace carom
