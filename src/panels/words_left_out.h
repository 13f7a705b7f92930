// The words of plots that find no place where they touch nothing, and are not drawn.
#pragma once

#include <string>
#include <vector>

namespace carom {

class PanelSet;
class TextLog;
struct Tick;

/// Those that were noted while a log was kept, each once: "the words “...” of a plot".
std::vector<std::string> words_left_out(const TextLog& log);

/// Likewise the words of levels that stand in a key, away from their line: “...”.
std::vector<std::string> words_in_keys(const TextLog& log);

/// What a film has no room for: FramePainter::cut_words(), and the words that its plots leave out
/// in all frames with the panels of the frame in the middle. The axes must be fixed. No log may be
/// kept meanwhile.
std::vector<std::string> words_without_room(const PanelSet& panels, const std::vector<Tick>& ticks);

}  // namespace carom
