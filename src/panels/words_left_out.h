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

/// Those that are the same in all frames with the panels of a frame. The axes must be fixed. No
/// log may be kept meanwhile.
std::vector<std::string> words_left_out(const PanelSet& panels, const Tick& tick);

}  // namespace carom
