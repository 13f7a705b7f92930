// Bytes as letters, for files inside of pages.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// Base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

}  // namespace carom
