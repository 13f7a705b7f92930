// A scene of which every pixel is known by arithmetic: one disk at rest.
#pragma once

#include <string>

namespace carom::test {

inline const std::string still_life = R"(title: One disk at rest
box: {size: [40, 30]}
gas:
  - {name: a, count: 1, radius: 6, position: [10, 20], color: "#56b4e9"}
run: {until: 1}
film: {seconds: 2, fps: 25, size: [640, 360], theme: light, color_by: species,
       template: lecture, panels: [{kind: text, words: One}]}
)";

}  // namespace carom::test
