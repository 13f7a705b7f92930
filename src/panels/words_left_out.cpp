#include "panels/words_left_out.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "draw/text.h"
#include "panels/frame.h"

namespace carom {
std::vector<std::string> words_left_out(const TextLog& log) {
    std::vector<std::string> names;
    for (const std::string& words : log.left_out) {
        std::string name = "the words “" + words + "” of a plot";
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
}

std::vector<std::string> words_without_room(const PanelSet& panels,
                                            const std::vector<Tick>& ticks) {
    FramePainter painter(panels);
    std::vector<std::string> all = painter.cut_words();
    const TextLog log;
    painter.paint({ticks[ticks.size() / 2], {}, 0});
    std::ranges::move(words_left_out(log), std::back_inserter(all));
    return all;
}

}  // namespace carom
