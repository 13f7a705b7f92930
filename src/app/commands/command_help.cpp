// carom help: the manual, made from the table of commands; carom completions: the scripts by which
// shells complete. Both are written for installation too.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "app/command.h"
#include "app/manual/page.h"
#include "app/manual/page_text.h"
#include "app/manual/pager.h"
#include "app/manual/roff.h"
#include "app/manual/scene_pages.h"
#include "app/manual/shell_completions.h"
#include "app/output.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct HelpArguments {
    std::string command, topic;
    std::string files;
};

void write_whole(const fs::path& path, const std::string& text) {
    Output output(path.string());
    output.write(text);
    output.commit();
}

// Writes the manual pages and completions as they are installed below share/.
void write_manual(const fs::path& share) {
    const std::vector<Command> commands = all_commands();
    const auto write_page = [&](const ManualPage& page) {
        write_whole(share / "man/man1" / (page.name + ".1"), roff_of(page));
    };
    write_page(page_of(commands));
    for (const Command& command : commands) write_page(page_of(command));
    write_whole(share / "bash-completion/completions/carom", completion_script("bash"));
    write_whole(share / "zsh/site-functions/_carom", completion_script("zsh"));
    write_whole(share / "fish/vendor_completions.d/carom.fish", completion_script("fish"));
}

ManualPage page_of_language(const HelpArguments& asked) {
    if (asked.command == "panel")
        return asked.topic.empty() ? page_of_panels() : page_of_panel(asked.topic);
    return asked.topic.empty() ? page_of_scene() : page_of_scene(asked.topic);
}

void help(const HelpArguments& arguments) {
    if (!arguments.files.empty()) return write_manual(arguments.files);
    const std::vector<Command> commands = all_commands();
    if (arguments.command.empty()) return show_pages(text_of(page_of(commands)));
    if (arguments.command == "panel" || arguments.command == "scene")
        return show_pages(text_of(page_of_language(arguments)));
    const auto found = std::ranges::find(commands, arguments.command, &Command::name);
    if (found != commands.end() && !arguments.topic.empty())
        throw UsageError("carom help " + arguments.command + " does not take the word " +
                         arguments.topic);
    if (found != commands.end()) return show_pages(text_of(page_of(*found)));
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.name);
    const std::string all = "the commands are " + listed(names);
    names.insert(names.end(), {"panel", "scene"});
    throw UsageError("there is no command `" + arguments.command + "`; " +
                     spelling_hint(arguments.command, names, all));
}

CommandText help_text() {
    return {{"carom help [COMMAND]", "carom help panel [KIND]", "carom help scene [SECTION|KEY]",
             "carom help --files FOLDER"},
            "Shows the manual of a command or, without one, of the program; on a terminal with "
            "$PAGER, if that is set. If carom is installed, man carom and man carom-render show "
            "the same.\n\ncarom help panel lists the panels of films and figures, or shows one "
            "with its keys; carom help scene shows the keys of a scene, of one of its sections, "
            "or one key.",
            {{"carom help render", "the manual of carom render"},
             {"carom help panel speed-histogram", "what this panel shows, and its keys"},
             {"carom help scene film", "the keys of `film`, with their values and defaults"}}};
}

CommandText completions_text() {
    return {{"carom completions bash|zsh|fish"},
            "Prints a script with which the shell completes commands, options, scenes, templates, "
            "kinds of figures, and the keys of --set. If carom is installed, so is the script, and "
            "the shell finds it by itself.",
            {{"carom completions bash > ~/.local/share/bash-completion/completions/carom",
              "for bash, for one user"},
             {"carom completions zsh > ~/.zfunc/_carom", "for zsh, if ~/.zfunc is in fpath"},
             {"carom completions fish > ~/.config/fish/completions/carom.fish", "for fish"}}};
}

}  // namespace

Command help_command() {
    const auto arguments = std::make_shared<HelpArguments>();
    return {
        "help",
        "show the manual of a command",
        {{"[command]", "the command, panel or scene; default: the program", &arguments->command},
         {"[topic]", "a kind of panel; a section, a key or the path of a key in scenes",
          &arguments->topic},
         {"--files FOLDER",
          "write the man pages, and completions for bash, zsh and fish, into this folder",
          &arguments->files}},
        [arguments] { help(*arguments); },
        help_text()};
}

Command completions_command() {
    const auto shell = std::make_shared<std::string>();
    return {"completions",
            "print completions for a shell",
            {{"shell", "bash, zsh or fish", shell.get(), {"bash", "zsh", "fish"}}},
            [shell] { Output("-").write(completion_script(*shell)); },
            completions_text()};
}

}  // namespace carom
