#include "app/film/webvtt.h"

#include <fmt/format.h>

#include <cmath>

namespace carom {
namespace {

std::string stamp(double seconds) {
    const auto milliseconds = static_cast<long long>(std::llround(1000.0 * seconds));
    return fmt::format("{:02}:{:02}:{:02}.{:03}", milliseconds / 3'600'000,
                       milliseconds / 60'000 % 60, milliseconds / 1000 % 60, milliseconds % 1000);
}

// What would begin a tag or an escape, and an empty line, which would end the cue. "-->" needs no
// more: its ">" is escaped.
std::string escaped(const std::string& words) {
    std::string text;
    for (const char letter : words) {
        if (letter == '\n' && (text.empty() || text.back() == '\n')) continue;
        if (letter == '&')
            text += "&amp;";
        else if (letter == '<')
            text += "&lt;";
        else if (letter == '>')
            text += "&gt;";
        else
            text += letter;
    }
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

}  // namespace

std::string webvtt(const std::vector<Cue>& cues) {
    std::string file = "WEBVTT\n";
    for (const Cue& cue : cues) {
        const std::string words = escaped(cue.words), start = stamp(cue.start),
                          end = stamp(cue.end);
        if (!words.empty() && start < end)
            file += fmt::format("\n{} --> {}\n{}\n", start, end, words);
    }
    return file;
}

}  // namespace carom
