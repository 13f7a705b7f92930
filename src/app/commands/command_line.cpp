#include "app/commands/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <new>
#include <set>
#include <string_view>
#include <system_error>

#include "app/command.h"
#include "app/commands/suggestions.h"
#include "app/commands/typed_words.h"
#include "app/manual/page_text.h"
#include "app/manual/shell_completions.h"
#include "app/output.h"
#include "scene/yaml/scalar.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"
#include "util/progress.h"
#include "util/text.h"

namespace carom {
namespace {

template <class Value>
CLI::Option& declare(CLI::App& app, const Option& option, Value* value) {
    return *app.add_option(flags_of(option), *value, option.meaning);
}

CLI::Option& declare(CLI::App& app, const Option& option, bool* value) {
    return *app.add_flag(flags_of(option), *value, option.meaning);
}

CLI::Option& declare(CLI::App& app, const Option& option, int* value) {
    const auto complaint = [most = option.most](const std::string& word) {
        int number = 0;
        const char* const end = word.data() + word.size();
        const auto [rest, error] = std::from_chars(word.data(), end, number);
        const bool is_right = error == std::errc{} && rest == end && number >= 1 && number <= most;
        return is_right
                   ? std::string()
                   : fmt::format("expected a whole number from 1 to {}, found `{}`", most, word);
    };
    return *app.add_option(flags_of(option), *value, option.meaning)->check(complaint);
}

// An option takes only one word per flag, so that a scene may follow it.
CLI::Option& declare(CLI::App& app, const Option& option, std::vector<std::string>* value) {
    CLI::Option& declared = *app.add_option(flags_of(option), *value, option.meaning);
    if (option.name.starts_with('-')) declared.allow_extra_args(false);
    return declared;
}

CLI::Option& declare(CLI::App& app, const Option& option, const CommaSeparated& list) {
    return *declare(app, option, list.words).delimiter(',')->transform([](const std::string& word) {
        return CLI::detail::trim_copy(word);
    });
}

CLI::Option& declare(CLI::App& app, const Option& option, const TakeValue& take) {
    return *app.add_option_function<std::string>(flags_of(option), take, option.meaning);
}

// "" where there is none.
std::string first_command_among(const std::vector<std::string>& words,
                                const std::vector<Command>& commands) {
    const auto first = std::ranges::find_first_of(words, commands, {}, {}, &Command::name);
    return first == words.end() ? "" : *first;
}

// If a diagnostic is about the value of an option that sets a key of the scene, makes it quote the
// option as it was typed.
void place_at_option(Diagnostic& diagnostic, const Option& option, const CLI::App& called) {
    const CLI::Option* const given =
        option.key.empty() ? nullptr : called.get_option_no_throw(flags_of(option));
    if (given == nullptr || given->empty()) return;
    const std::string& value = given->results().back();
    const std::string text = text_of_change(change_of(option.key, value));
    if (diagnostic.span.file != text) return;
    const SourceSpan in_change = diagnostic.span;
    show_at_option(diagnostic, flags_of(option), value);
    if (!text.ends_with("=" + value)) return;  // the value was rewritten as YAML: mark all of it
    SourceSpan& span = diagnostic.span;
    span.column =
        in_change.column + static_cast<int>(span.file.size()) - static_cast<int>(text.size());
    span.length = in_change.length;
}

SceneError as_typed(const SceneError& error, const Command& command, const CLI::App& called) {
    std::vector<Diagnostic> all;
    std::set<std::string> texts;
    for (Diagnostic one : error.diagnostics()) {
        for (const Option& option : command.options) place_at_option(one, option, called);
        if (texts.insert(to_text(one)).second) all.push_back(std::move(one));
    }
    return SceneError(std::move(all));
}

// The message about a mistake, with the known word of similar spelling, if there is one, as a
// suggestion.
std::string with_meant(const std::string& mistake, const std::string& word,
                       const std::vector<std::string>& known) {
    const auto meant = nearest_spelling(word, known);
    return meant ? fmt::format("{}; did you mean {}?", mistake, *meant) : mistake;
}

std::string other_choice(const std::string& word, const std::vector<std::string>& choices) {
    return with_meant(fmt::format("expected {}, found `{}`", listed(choices, "or"), word), word,
                      choices);
}

// The long options of a command, with their hyphens.
std::vector<std::string> flags_of(const CLI::App& command) {
    std::vector<std::string> flags;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    return flags;
}

// Throws UsageError if the scenes that a command is given contain what belongs to an option.
void refuse_words_of_options(const CLI::App& command) {
    const std::vector<std::string> flags = flags_of(command);
    for (const CLI::Option* option : command.get_options()) {
        if (!upper_case(option->get_name()).starts_with("SCENE")) continue;
        const std::vector<std::string>& words = option->results();
        for (const std::string& word : words) {
            std::error_code failed;
            if (word.ends_with('/') && word == words.front()) continue;  // perhaps a plan
            const std::string meant = option_of_word(word, flags);
            if (meant.empty() || std::filesystem::exists(word, failed)) continue;
            throw UsageError(fmt::format("{} is no scene: write carom {} {} {}", word,
                                         command.get_name(),
                                         word == words.front() ? "SCENE" : words.front(), meant));
        }
    }
}

// Declares a command, with options only if it is the one that is called: to declare those of all
// commands takes a millisecond.
void add_command(CLI::App& app, const Command& command, bool is_called) {
    CLI::App& declared = *app.add_subcommand(command.name, command.meaning);
    if (!is_called) return;
    for (const Option& option : command.options) {
        CLI::Option& its = std::visit(
            [&](const auto& value) -> CLI::Option& { return declare(declared, option, value); },
            option.value);
        if (!option.name.starts_with('-')) its.required(!option.name.starts_with('['));
        if (!option.choices.empty())
            its.check([choices = option.choices](const std::string& word) {
                return std::ranges::count(choices, word) > 0 ? std::string()
                                                             : other_choice(word, choices);
            });
    }
    declared.callback([&command, &declared] {
        try {
            refuse_words_of_options(declared);
            command.run();
        } catch (const SceneError& error) {
            throw as_typed(error, command, declared);
        }
    });
    declared.formatter_fn([&command](const CLI::App*, const std::string&, CLI::AppFormatMode) {
        return text_of(help_of(command));
    });
}

void refuse_unknown_command(const CLI::App& app, int argc, const char* const* argv) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    if (argc < 2) throw UsageError("a command is needed");
    const std::string word = argv[1];
    if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return;
    for (int i = 2; i < argc; ++i)
        if (std::ranges::find(names, argv[i]) != names.end())
            throw UsageError(fmt::format("the command comes first: carom {} {}", argv[i], word));
    if (word == "version") throw UsageError("there is no command `version`; write --version");
    const std::string commands = fmt::format("the commands are {}", fmt::join(names, ", "));
    throw UsageError(
        fmt::format("there is no command `{}`; {}", word, spelling_hint(word, names, commands)));
}

// "carom render SCENE...", of a command whose words are missing.
std::string call_of(const CLI::App& command) {
    std::string call = "carom " + command.get_name();
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_lnames().empty() || !option->get_snames().empty()) continue;
        std::string word = upper_case(option->get_name());
        if (option->get_items_expected_max() > 1) word = word.substr(0, word.size() - 1) + "...";
        call += " " + word;
    }
    return call;
}

// The message about the first word that a command does not take. The library keeps words after `--`
// in the program's object, not in that of the command.
std::string unexpected_word(const CLI::App& app, const CLI::App& command) {
    std::vector<std::string> words = command.remaining();
    if (&app != &command) std::ranges::copy(app.remaining(), std::back_inserter(words));
    std::erase(words, "--");
    if (words.empty())
        return fmt::format("carom {} needs more: write {}", command.get_name(), call_of(command));
    const auto flag = std::ranges::find_if(
        words, [](const std::string& word) { return word.starts_with("-") && word != "-"; });
    const std::string name = command.get_name();
    const std::string call = command.get_parent() == nullptr ? name : "carom " + name;
    const std::vector<std::string> flags = flags_of(command);
    if (flag == words.end()) {
        const std::string mistake =
            fmt::format("{} does not take the word {}", call, words.front());
        const std::string option = option_of_word(words.front(), flags);
        return option.empty() ? mistake : fmt::format("{}; write {}", mistake, option);
    }
    const std::string word = flag->substr(0, flag->find_first_of("=:"));
    const std::string mistake = fmt::format("{} has no option {}", call, word);
    const std::string hint = instead_of_flag(name, word, flags);
    return hint.empty() ? mistake : mistake + "; " + hint;
}

std::string number_wanted(const std::string& flag, const std::string& found) {
    const std::string hint = number_hint(Node{.kind = Node::Kind::scalar, .text = found});
    return fmt::format("{}: expected a number, found `{}`{}{}", flag, found,
                       hint.empty() ? "" : "; ", hint);
}

// The message about a mistake in the command line, and what to write instead.
std::string mistake_in(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> commands = app.get_subcommands();
    if (commands.empty())
        return fmt::format("{}; carom --help lists the commands", app.remaining().empty()
                                                                      ? "a command is needed"
                                                                      : unexpected_word(app, app));
    const CLI::App& command = *commands.front();
    const std::string help = fmt::format("; carom {} --help lists the options", command.get_name());
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
        return unexpected_word(app, command) + help;
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        const std::vector<std::string> others = command.remaining();
        if (others.empty())
            return fmt::format("carom {} needs more: write {}{}", command.get_name(),
                               call_of(command), help);
        if (others.front().ends_with(".yaml"))
            return fmt::format("{}; a file of that name is written ./{}",
                               unexpected_word(app, command), others.front());
        return unexpected_word(app, command) + help;
    }
    const std::string what = error.what();
    if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr)
        for (const CLI::Option* option : command.get_options())
            if (const std::string flag = option->get_name();
                what.ends_with(fmt::format(": {} = {}", flag, fmt::join(option->results(), ","))))
                return number_wanted(flag, fmt::format("{}", fmt::join(option->results(), " "))) +
                       help;
    const std::string flag = what.substr(0, what.find(':'));
    const CLI::Option* option = command.get_option_no_throw(flag);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr && option != nullptr) {
        if (option->results().size() > 1)
            return fmt::format("{} is given more than once: {}{}", flag,
                               fmt::join(option->results(), " and "), help);
        return fmt::format("{} needs a value: {}{}", flag, option->get_description(), help);
    }
    return what + help;
}

// Refuses empty values: an unset shell variable must not be read as the number 0, or as no file.
void refuse_empty_values(CLI::App& app) {
    const auto complaint = [](const std::string& value) {
        return std::string(value.empty() ? "the value is empty" : "");
    };
    for (CLI::App* command : app.get_subcommands({}))
        for (CLI::Option* option : command->get_options())
            if (!option->get_lnames().empty() && option->get_items_expected_max() > 0)
                option->check(complaint);
}

// Flushes standard output; throws if output was lost. It is no error if standard output was closed
// from the start.
void finish_standard_output() {
    if ((std::cout.flush() && std::fflush(stdout) == 0) || errno == EBADF) return;
    const int error = errno;
    if (error == EPIPE) throw ClosedPipe();
    throw_system_error("cannot write standard output: " + std::generic_category().message(error),
                       error);
}

// Parses the arguments. The library runs the named command at the end of parsing.
int parse_and_run(int argc, const char* const* argv, const std::vector<Command>& commands) {
    CLI::App app{"carom: lecture films of gases from scene files, without a screen", "carom"};
    app.set_version_flag("--version", "carom " CAROM_VERSION);
    app.require_subcommand(1);
    const std::string called = first_command_among({argv + 1, argv + argc}, commands);
    for (const Command& command : commands) add_command(app, command, command.name == called);
    app.formatter_fn([&commands](const CLI::App*, const std::string&, CLI::AppFormatMode) {
        return text_of(help_of(commands));
    });
    refuse_empty_values(app);
    refuse_unknown_command(app, argc, argv);
    try {
        std::vector<std::string> words = with_each_set({argv + 1, argv + argc});
        for (const Command& command : commands)
            if (command.name == called) fill_absent_values(words, command.options);
        std::ranges::reverse(words);  // the library expects them in reverse order
        app.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) throw UsageError(mistake_in(app, error));
        app.exit(error);  // the help, or the version
        finish_standard_output();
        return 0;
    }
    finish_standard_output();
    return 0;
}

// EX_TEMPFAIL of sysexits.h.
constexpr int exit_code_of_temporary_error = 75;

// What shells report of a program that the signal of a closed pipe has ended: `carom run --csv - |
// head` is no failure that a message would help with.
constexpr int exit_code_of_closed_pipe = 128 + SIGPIPE;

int complain(int code, const std::string& what) {
    print_to_stderr(what + "\n");
    return code;
}

// One line, whatever the words of the command line and the names of files hold.
int complain(int code, const std::exception& error) {
    return complain(code, "carom: " + printable(error.what()));
}

// A failure that was not expected where it happened, for example because the current folder was
// removed.
int complain_of_system(const std::system_error& error) {
    const auto* const of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error);
    const std::string path = of_file != nullptr ? of_file->path1().string() : "";
    const bool may_pass = is_transient(error.code().value());
    return complain(may_pass ? exit_code_of_temporary_error : 1,
                    fmt::format("carom: {}{}{}", printable(path), path.empty() ? "" : ": ",
                                error.code().message()));
}

// Uses only static storage: there may be no memory left to compose a message.
int complain_of_memory() noexcept {
    std::fflush(stderr);
    write_to_standard_error({"carom: not enough memory; ", state_of_outputs(),
                             "; a smaller picture or fewer particles need less\n"});
    return 1;
}

// Called by std::terminate: some library functions that are declared noexcept allocate memory
// (CLI11 when it compares names, nlohmann-json when it destroys lists).
[[noreturn]] void end_without_memory() {
    try {
        if (const std::exception_ptr error = std::current_exception())
            std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        _exit(complain_of_memory());
    } catch (...) {
    }
    std::abort();
}

// Runs the command and reports its errors. Lets std::bad_alloc pass, from the command or from
// reporting its error.
int run_and_complain(int argc, const char* const* argv) {
    try {
        const std::vector<Command> commands = all_commands();
        if (argc < 2)
            return complain(2, "carom: a command is needed\n\n" + text_of(help_of(commands)));
        return parse_and_run(argc, argv, commands);
    } catch (const SceneError& error) {
        return complain(2, error.what());
    } catch (const UsageError& error) {
        return complain(2, error);
    } catch (const Interrupted& stop) {
        return complain(130, stop);
    } catch (const ClosedPipe&) {
        return exit_code_of_closed_pipe;
    } catch (const TemporaryError& error) {
        return complain(exit_code_of_temporary_error, error);
    } catch (const SystemError& error) {
        return complain(1, error);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::system_error& error) {
        return complain_of_system(error);
    } catch (const std::exception& error) {
        return complain(1, fmt::format("carom: a mistake in carom itself ({}): please report it",
                                       printable(error.what())));
    }
}

}  // namespace

void say_when_memory_runs_out() { std::set_terminate(end_without_memory); }

int run_command_line(int argc, const char* const* argv) {
    say_when_memory_runs_out();
    if (argc > 1 && argv[1] == std::string_view(completing)) {
        print_candidates({argv + 2, argv + argc});
        return 0;
    }
    try {
        return run_and_complain(argc, argv);
    } catch (const std::bad_alloc&) {
        return complain_of_memory();
    }
}

void check_command_line(const std::vector<std::string>& words) {
    std::vector<Command> commands = all_commands();
    for (Command& command : commands)
        command.run = [values = command.run] {};  // keeps alive the destinations of option values
    std::vector<const char*> arguments{"carom"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    parse_and_run(static_cast<int>(arguments.size()), arguments.data(), commands);
}

}  // namespace carom
