#include "app/manual/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "util/joined.h"

namespace carom {
namespace {

// "-o, --output FILM".
std::string term_of(const Option& option) {
    const std::string word = word_of(option);
    std::string flags = flags_of(option);
    if (!flags.starts_with('-')) return word;
    if (const std::size_t comma = flags.find(','); comma != std::string::npos)
        flags.insert(comma + 1, " ");
    return word.empty() ? flags : flags + " " + word;
}

std::vector<Definition> definitions_of(const std::vector<Option>& options) {
    std::vector<Definition> definitions;
    for (const Option& option : options) definitions.push_back({term_of(option), option.meaning});
    definitions.push_back({"-h, --help", "print the options and some examples"});
    return definitions;
}

ManualSection examples_of(const Command& command) {
    ManualSection section{.title = "Examples", .long_terms = true};
    for (const Example& example : command.text.examples)
        section.definitions.push_back({example.call, example.meaning});
    return section;
}

std::vector<Definition> definitions_of(const std::vector<Command>& commands) {
    std::vector<Definition> definitions;
    for (const Command& command : commands) definitions.push_back({command.name, command.meaning});
    return definitions;
}

std::vector<std::string> paragraphs_in(const std::string& text) {
    std::vector<std::string> paragraphs;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find("\n\n", begin), text.size());
        paragraphs.push_back(text.substr(begin, end - begin));
        begin = end + 2;
    }
    return paragraphs;
}

ManualSection exit_codes() {
    return {.title = "Exit status",
            .definitions = {
                {"0", "done"},
                {"1", "the work failed, and trying again will not help"},
                {"2", "the command line, the scene or the set is wrong; nothing was written"},
                {"75", "the work failed and may succeed when it is tried again"},
                {"130", "interrupted; what was finished stays"}}};
}

std::vector<Definition> files() {
    return {{"out/", "where results go unless -o says otherwise"},
            {"share/carom/scenes/",
             "the scenes that come with carom, and the JSON Schema of "
             "scenes, below the folder that carom is installed in"},
            {"share/carom/templates/", "layouts of films, styles, and pages of figures"},
            {"share/carom/cluster/", "recipes for Snakemake and Slurm"},
            {"share/doc/carom/", "manual and changelog"}};
}

std::vector<Definition> environment() {
    return {
        {"PAGER", "the program with which carom help shows its pages on a terminal; unset: none"},
        {"SLURM_CPUS_PER_TASK", "the most cores to use, unless --threads says otherwise"},
        {"TMPDIR",
         "where temporary files go; default: /tmp, and /var/tmp for the frames of a large run"}};
}

const std::vector<std::string> program_calls{"carom COMMAND [options]", "carom help [COMMAND]",
                                             "carom help panel [KIND]",
                                             "carom help scene [SECTION|KEY]", "carom --version"};

const std::string program_summary = "lecture films and figures of gases from scene files";

}  // namespace

ManualPage page_of(const Command& command) {
    return {"carom-" + command.name,
            command.meaning,
            {{.title = "Synopsis", .calls = command.text.synopsis},
             {.title = "Description", .paragraphs = paragraphs_in(command.text.description)},
             {.title = "Options", .definitions = definitions_of(command.options)},
             examples_of(command),
             exit_codes(),
             {.title = "See also", .paragraphs = {"carom(1)"}}}};
}

ManualPage page_of(const std::vector<Command>& commands) {
    std::string pages;
    for (const Command& command : commands)
        pages += fmt::format("{}carom-{}(1)", pages.empty() ? "" : ", ", command.name);
    return {
        "carom",
        program_summary,
        {{.title = "Synopsis", .calls = program_calls},
         {.title = "Description",
          .paragraphs =
              {"carom simulates gases of hard spheres in space, of hard disks in a plane, and of "
               "rods and points on a line, with exact collision times. From a scene, a YAML "
               "file of a few lines, it makes a film, figures for print, or tables of numbers. "
               "It needs no screen.",
               "The same scene and seed give the same film on any number of cores. Mistakes in "
               "a scene are reported before the work starts, all at once, each with its line. "
               "carom new writes a scene to start from; share/carom/scenes has others."}},
         {.title = "Commands", .definitions = definitions_of(commands)},
         {.title = "Files", .definitions = files()},
         {.title = "Environment", .definitions = environment()},
         exit_codes(),
         {.title = "See also", .paragraphs = {pages}}}};
}

ManualPage help_of(const Command& command) {
    return {"carom " + command.name,
            command.meaning,
            {{.title = "Usage", .calls = command.text.synopsis},
             {.title = "Options", .definitions = definitions_of(command.options)},
             examples_of(command),
             {.title = "More", .calls = {"carom help " + command.name}}}};
}

ManualPage help_of(const std::vector<Command>& commands) {
    return {"carom",
            program_summary,
            {{.title = "Usage", .calls = program_calls},
             {.title = "Commands", .definitions = definitions_of(commands)},
             {.title = "Options",
              .definitions = {{"-h, --help", "print this"}, {"--version", "print the version"}}},
             {.title = "More", .calls = {"carom COMMAND --help", "carom help COMMAND"}}}};
}

}  // namespace carom
