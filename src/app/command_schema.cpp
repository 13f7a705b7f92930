// carom schema: the JSON Schema of scenes.
#include "app/command.h"
#include "app/output.h"
#include "app/schema_json.h"

namespace carom {

void add_schema(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("schema", "print the JSON Schema of scenes, for editors");
    command.callback([] { Output("-").write(scene_schema_json()); });
}

}  // namespace carom
