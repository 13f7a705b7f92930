#include "media/base64.h"

extern "C" {
#include <libavutil/base64.h>
}

#include <cstdint>
#include <limits>
#include <stdexcept>

namespace carom {

std::string base64(std::string_view bytes) {
    constexpr std::size_t most = std::numeric_limits<int>::max() / 4 * 3 - 6;
    if (bytes.size() > most) throw std::length_error("too long for base64");
    const auto size = static_cast<int>(bytes.size());
    std::string text(static_cast<std::size_t>(AV_BASE64_SIZE(size)), '\0');
    av_base64_encode(text.data(), static_cast<int>(text.size()),
                     reinterpret_cast<const std::uint8_t*>(bytes.data()), size);
    text.pop_back();  // the end of a C string
    return text;
}

}  // namespace carom
