// The keys of style files, and the style of a scene.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/figure_spec.h"
#include "scene/keys/binding.h"
#include "scene/style/style.h"
#include "scene/yaml/node.h"

namespace carom {

/// The table of keys of a style file.
const FixedTable<Style>& style_table();

/// Returns whether a file is a style: a mapping with keys of styles only; false if it cannot be
/// read.
bool is_style(const std::filesystem::path& path);

/// Reads a style from a parsed file. `families` as in StyleCheck. Reports errors at their places in
/// the file, and returns null if it is no style at all.
std::shared_ptr<const Style> read_style(Node& root, const std::string& path,
                                        const std::function<std::vector<std::string>()>& families,
                                        Errors& errors);

/// Gives a figure the style, and its theme and width unless the mapping that the figure was read
/// from gives others. Null: no style.
void take_style(FigureSpec& figure, const Node& mapping, const std::shared_ptr<const Style>& style);

}  // namespace carom
