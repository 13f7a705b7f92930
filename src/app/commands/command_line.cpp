#include "app/commands/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <new>
#include <system_error>

#include "app/command.h"
#include "app/progress.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/text.h"

namespace carom {
namespace {

template <class Value>
CLI::Option& declare(CLI::App& app, const Option& option, Value* value) {
    return *app.add_option(option.name, *value, option.meaning);
}

CLI::Option& declare(CLI::App& app, const Option& option, bool* value) {
    return *app.add_flag(option.name, *value, option.meaning);
}

CLI::Option& declare(CLI::App& app, const Option& option, int* value) {
    constexpr int most = 1024;
    return *app.add_option(option.name, *value, option.meaning)->check(CLI::Range(1, most));
}

// Behind a flag one word only, so that a scene may stand behind it.
CLI::Option& declare(CLI::App& app, const Option& option, std::vector<std::string>* value) {
    CLI::Option& declared = *app.add_option(option.name, *value, option.meaning);
    if (option.name.starts_with('-')) declared.allow_extra_args(false);
    return declared;
}

CLI::Option& declare(CLI::App& app, const Option& option, const CommaSeparated& list) {
    return *declare(app, option, list.words).delimiter(',')->transform([](const std::string& word) {
        return CLI::detail::trim_copy(word);
    });
}

CLI::Option& declare(CLI::App& app, const Option& option, const TakeValue& take) {
    return *app.add_option_function<std::string>(option.name, take, option.meaning);
}

void add_command(CLI::App& app, const Command& command) {
    CLI::App& declared = *app.add_subcommand(command.name, command.meaning);
    for (const Option& option : command.options) {
        CLI::Option& its = std::visit(
            [&](const auto& value) -> CLI::Option& { return declare(declared, option, value); },
            option.value);
        if (!option.name.starts_with('-')) its.required();
        if (!option.choices.empty()) its.check(CLI::IsMember(option.choices));
    }
    declared.callback(command.run);
}

void refuse_unknown_command(const CLI::App& app, int argc, const char* const* argv) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (argc < 2) throw UsageError("a command is needed\n\n" + app.help());
    const std::string word = argv[1];
    if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return;
    const std::string commands = fmt::format("the commands are {}", fmt::join(names, ", "));
    throw UsageError(
        fmt::format("there is no command `{}`; {}", word, spelling_hint(word, names, commands)));
}

// Of a flag that the command does not have: the one that is meant.
std::string meant_flag(const CLI::App& app) {
    for (const CLI::App* command : app.get_subcommands())
        for (const std::string& word : command->remaining()) {
            std::vector<std::string> flags;
            for (const CLI::Option* option : command->get_options())
                for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
            const auto meant = nearest_spelling(word.substr(0, word.find('=')), flags);
            if (word.starts_with("-") && meant) return *meant;
        }
    return "";
}

// A variable of a shell that is not set must not be taken for the number 0, or for no file.
void refuse_empty_values(CLI::App& app) {
    const auto complaint = [](const std::string& value) {
        return std::string(value.empty() ? "the value is empty" : "");
    };
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options())
            if (!option->get_lnames().empty() && option->get_items_expected_max() > 0)
                option->check(complaint);
}

// Of what a command has printed there, and of the help; that it was closed is no error.
void finish_standard_output() {
    if ((std::cout.flush() && std::fflush(stdout) == 0) || errno == EBADF) return;
    const int error = errno;
    throw_system_error("cannot write standard output: " + std::generic_category().message(error),
                       error);
}

// The command that is named does its work at the end of parsing.
int parse_and_run(int argc, const char* const* argv) {
    CLI::App app{"carom: lecture films of gases from scene files, without a screen", "carom"};
    app.set_version_flag("--version", "carom " CAROM_VERSION);
    app.require_subcommand(1);
    for (const auto command :
         {render_command, still_command, figures_command, run_command, plan_command, join_command,
          check_command, new_command, schema_command})
        add_command(app, command());
    refuse_empty_values(app);
    refuse_unknown_command(app, argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        if (const std::string meant = meant_flag(app); code != 0 && !meant.empty())
            say(fmt::format("Did you mean {}?\n", meant));
        finish_standard_output();
        return code == 0 ? 0 : 2;
    }
    finish_standard_output();
    return 0;
}

// EX_TEMPFAIL of sysexits.h.
constexpr int exit_code_of_temporary_error = 75;

int complain(int code, const std::string& what) {
    say(what + "\n");
    return code;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
    try {
        return parse_and_run(argc, argv);
    } catch (const SceneError& error) {
        return complain(2, error.what());
    } catch (const UsageError& error) {
        return complain(2, fmt::format("carom: {}", error.what()));
    } catch (const Interrupted& stop) {
        return complain(130, fmt::format("carom: {}", stop.what()));
    } catch (const TemporaryError& error) {
        return complain(exit_code_of_temporary_error, fmt::format("carom: {}", error.what()));
    } catch (const std::bad_alloc&) {
        return complain(1,
                        "carom: not enough memory; a smaller picture or fewer particles need less");
    } catch (const std::exception& error) {
        return complain(1, fmt::format("carom: {}", error.what()));
    }
}

}  // namespace carom
