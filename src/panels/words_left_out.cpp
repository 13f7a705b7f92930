#include "panels/words_left_out.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "draw/text.h"
#include "panels/frame.h"

namespace carom {
namespace {

std::vector<std::string> each_once(const std::vector<std::string>& all, const std::string& before,
                                   const std::string& after) {
    std::vector<std::string> names;
    for (const std::string& words : all) {
        std::string name = before;
        name += words + after;
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
}

}  // namespace

std::vector<std::string> words_left_out(const TextLog& log) {
    return each_once(log.left_out, "the words “", "” of a plot");
}

std::vector<std::string> words_in_keys(const TextLog& log) {
    return each_once(log.in_keys, "“", "” has no room beside its line");
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
