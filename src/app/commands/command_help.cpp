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
#include "app/manual/shell_completions.h"
#include "app/output.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct HelpArguments {
    std::string command;
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

void help(const HelpArguments& arguments) {
    if (!arguments.files.empty()) return write_manual(arguments.files);
    const std::vector<Command> commands = all_commands();
    if (arguments.command.empty()) return show_pages(text_of(page_of(commands)));
    const auto found = std::ranges::find(commands, arguments.command, &Command::name);
    if (found != commands.end()) return show_pages(text_of(page_of(*found)));
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.name);
    throw UsageError("there is no command `" + arguments.command + "`; " +
                     spelling_hint(arguments.command, names, "the commands are " + listed(names)));
}

CommandText help_text() {
    return {{"carom help [COMMAND]", "carom help --files FOLDER"},
            "Shows the manual of a command or, without one, of the program; on a terminal with "
            "$PAGER, if that is set. If carom is installed, man carom and man carom-render show "
            "the same.",
            {{"carom help", "the manual of the program"},
             {"carom help render", "the manual of carom render"},
             {"carom help --files share/",
              "writes man pages and completions, as they are "
              "installed"}}};
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
    return {"help",
            "show the manual of a command",
            {{"[command]", "the command; default: the program", &arguments->command},
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
