// Bytes as letters, for files inside of pages.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// Base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

/// A file of a media type ("video/mp4") as an address that contains it.
std::string data_address(std::string_view type, std::string_view bytes);

}  // namespace carom
