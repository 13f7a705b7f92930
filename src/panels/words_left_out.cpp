#include "panels/words_left_out.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "draw/text.h"
#include "panels/frame.h"

namespace carom {
namespace {

// Markup without tags and with the letters that it writes as names.
std::string plain(std::string_view markup) {
    constexpr std::array<std::pair<std::string_view, char>, 3> letters{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}}};
    std::string words;
    while (!markup.empty()) {
        const auto* letter = std::ranges::find_if(
            letters, [&](const auto& one) { return markup.starts_with(one.first); });
        if (markup.front() == '<') {
            markup.remove_prefix(std::min(markup.size(), markup.find('>') + 1));
        } else if (letter != letters.end()) {
            words += letter->second;
            markup.remove_prefix(letter->first.size());
        } else {
            words += markup.front();
            markup.remove_prefix(1);
        }
    }
    return words;
}

}  // namespace

std::vector<std::string> words_left_out(const TextLog& log) {
    std::vector<std::string> names;
    for (const std::string& markup : log.left_out) {
        std::string name = "the words “" + plain(markup) + "” of a plot";
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
}

std::vector<std::string> words_left_out(const PanelSet& panels, const Tick& tick) {
    const TextLog log;
    FramePainter(panels).paint({tick, {}, 0});
    return words_left_out(log);
}

}  // namespace carom
