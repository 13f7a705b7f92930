// Which files belong to a plan, and are carom's.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "runs/json.h"

namespace carom {

inline constexpr const char* format_of_plans = "carom-plan";
inline constexpr std::int64_t most_json_bytes = 64 << 20;

/// The names of everything that a plan and its chunks have in their folder.
inline constexpr std::array<std::string_view, 6> names_in_plan{
    "plan.json", "film.plan", "film.sound", "summary.json", "starts", "chunks"};

/// Whether a JSON file of this name was written by carom: plan.json, the summary of a sweep, or the
/// manifest of a chunk.
bool is_from_carom(const Json& contents, const std::string& name);

/// Throws UsageError if the folder contains a file that belongs to no plan of carom, SystemError
/// if a file that must tell cannot be read.
void refuse_other_files(const std::filesystem::path& folder);

/// Throws UsageError if there is a scene in the folder of a plan: chunks are made from the files
/// that plan.json lists, so that a scene beside it, which somebody may have edited, would have no
/// effect.
void refuse_scenes_in(const std::filesystem::path& folder);

}  // namespace carom
