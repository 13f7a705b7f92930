#include "app/commands/suggestions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "media/formats.h"
#include "util/text.h"

namespace carom {
namespace {

// What users are likely to try, and what to write instead: in the hint of a command, or the flag
// that is meant, where the command has it.
struct OtherFlag {
    std::string command, flag, hint;
};
const std::vector<OtherFlag> other_flags{
    {"run", "-o", "samples go to --csv PATH, statistics to --json PATH"},
    {"run", "--output", "samples go to --csv PATH, statistics to --json PATH"},
    {"run", "--seeds", "several runs are a sweep: carom plan SCENE --seeds 1:100"},
    {"run", "--vary", "several runs are a sweep: carom plan SCENE --vary KEY.PATH=LOW:HIGH:COUNT"},
    {"new", "-o", "give the name without an option: carom new NAME"},
    {"new", "--output", "give the name without an option: carom new NAME"},
    {"schema", "-o", "send it to a file: carom schema > scene.schema.json"},
    {"schema", "--output", "send it to a file: carom schema > scene.schema.json"},
    {"still", "--width", "carom figure SCENE --kind gas --width 8cm draws a figure"},
    {"still", "--kind", "carom figure SCENE --kind KIND draws a figure"},
    {"carom", "-v", "did you mean --version?"},
    {"carom", "-V", "did you mean --version?"},
    {"render", "--sound", "--set film.sound=collisions adds sound"},
    {"figures", "--width", "carom figure SCENE --kind KIND --width 8cm draws a figure so wide"},
    {"render", "--at", "carom still SCENE --at T draws one frame"},
    {"render", "--time", "carom still SCENE --at T draws one frame"},
    {"figures", "--kind", "carom figure SCENE --kind KIND draws a figure that is not listed"},
    {"figures", "--at", "carom figure SCENE --kind KIND --at T draws a figure of that time"},
    {"", "--until", "the end of the run is --set run.until=T"},
    {"", "--duration", "the end of the run is --set run.until=T, the film's length film.seconds=S"},
    {"", "--dry-run", "carom check SCENE says what a scene contains and costs"},
    {"", "--config", "the scene file holds all values; --set KEY.PATH=VALUE changes one"},
    {"", "--overwrite", "files that carom wrote are replaced without being asked"},
    {"", "-y", "files that carom wrote are replaced without being asked"},
};
const std::vector<std::pair<std::string, std::string>> meant_flags{
    {"--time", "--at"},
    {"-t", "--at"},
    {"--out", "--output"},
    {"-f", "--format"},
    {"-f", "--formats"},
    {"-j", "--threads"},
    {"--jobs", "--threads"},
    {"--cores", "--threads"},
    {"--workers", "--threads"},
    {"-q", "--quiet"},
    {"--silent", "--quiet"},
    {"-s", "--size"},
    {"--resolution", "--size"},
    {"--width", "--size"},
    {"--height", "--size"},
    {"--size", "--width"},
    {"--length", "--seconds"},
    {"--rate", "--fps"},
    {"--framerate", "--fps"},
    {"-r", "--fps"},
    {"--crf", "--quality"},
    {"--bitrate", "--max-size"},
    {"--mute", "--no-sound"},
    {"--no-audio", "--no-sound"},
    {"--no-metadata", "--no-recipe"},
    {"--lang", "--language"},
    {"-l", "--language"},
    {"-D", "--set"},
    {"--param", "--set"},
    {"--override", "--set"},
    {"--color", "--theme"},
    {"--transparent", "--ground"},
    {"--background", "--ground"},
    {"--start", "--from"},
    {"--end", "--to"},
    {"--type", "--kind"},
    {"--name", "--only"},
    {"--verbose", "--timings"},
    {"-v", "--timings"},
    {"-n", "--seeds"},
    {"--runs", "--seeds"},
    {"--sweep", "--vary"},
    {"--random-seed", "--seed"},
};

}  // namespace

std::string instead_of_flag(const std::string& command, const std::string& flag,
                            const std::vector<std::string>& flags) {
    for (const OtherFlag& other : other_flags)
        if (other.command == command && other.flag == flag) return other.hint;
    for (const auto& [tried, meant] : meant_flags)
        if (tried == flag && std::ranges::count(flags, meant) > 0)
            return fmt::format("did you mean {}?", meant);
    for (const OtherFlag& other : other_flags)
        if (other.command.empty() && other.flag == flag && std::ranges::count(flags, "--quiet") > 0)
            return other.hint;
    const auto near = nearest_spelling(flag, flags);
    return near ? fmt::format("did you mean {}?", *near) : "";
}

std::string option_of_word(const std::string& word, const std::vector<std::string>& flags) {
    const std::size_t sign = word.find_first_of("=:");
    if (sign != std::string::npos && sign > 0) {  // fps=30, gas.0.count=50
        const std::string flag = "--" + word.substr(0, sign);
        if (std::ranges::count(flags, flag) > 0) return flag + " " + word.substr(sign + 1);
        if (word[sign] == '=' && std::ranges::count(flags, "--set") > 0) return "--set " + word;
    }
    const std::string ending = ending_of(word);
    std::string flag;
    for (const char* kind : {"csv", "json", "xyz"})
        if (ending == fmt::format(".{}", kind)) flag = fmt::format("--{}", kind);
    if (std::ranges::count(flags, flag) > 0) return fmt::format("{} {}", flag, word);
    const bool is_picture = std::ranges::any_of(
        output_formats(), [&](const OutputFormat& one) { return ending == "." + one.name; });
    const bool is_output = std::ranges::count(flags, "--output") > 0;
    return is_output && (is_picture || word.ends_with('/')) ? "-o " + word : "";
}

}  // namespace carom
