// The figures of a folder for programs: their captions, and the list of what carom wrote there.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/figures/figure_folder.h"
#include "app/figures/figure_set.h"

namespace carom {

/// captions.json: UTF-8, ends in a newline.
std::string captions_json(const std::string& title, std::span<const SetFigure> figures);

std::string manifest_json(const Manifest& manifest);

/// Nothing if it is no such text.
std::optional<Manifest> read_manifest(std::string_view text);

}  // namespace carom
