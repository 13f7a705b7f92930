// Fingerprints of texts and files, to tell whether they are what they were. Not for secrets.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace carom {

/// 32 hexadecimal digits: XXH3 of 128 bits, the same on every machine.
std::string fingerprint(std::string_view bytes);

/// Of what is in a file; nothing if it is no ordinary file or cannot be read.
std::optional<std::string> fingerprint_of_file(const std::filesystem::path& path);

}  // namespace carom
