// Base64 encoding, for files embedded in HTML pages.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// Encodes bytes in Base64 (RFC 4648, with padding).
std::string base64(std::string_view bytes);

/// A data: URL that contains a file of a media type ("video/mp4").
std::string data_address(std::string_view type, std::string_view bytes);

}  // namespace carom
