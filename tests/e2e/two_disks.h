// A scene whose film is of a few frames, for tests of files and not of what they show.
#pragma once

#include <string>

namespace carom::test {

inline const std::string two_disks =
    "title: Two disks\nbox: {size: [8, 6]}\ngas: [{count: 2, radius: 0.5, speed: 1}]\n"
    "run: {until: 1}\nfilm: {seconds: 0.4, fps: 15, panels: [temperature]}\n";

}  // namespace carom::test
