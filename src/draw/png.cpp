#include "draw/png.h"

#include <zlib.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(number >> shift & 0xFFU);
}

void append(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

Bytes chunk(std::string_view type, const Bytes& data) {
    Bytes named;
    append(named, type);
    named.insert(named.end(), data.begin(), data.end());
    Bytes whole;
    append(whole, static_cast<std::uint32_t>(data.size()));
    whole.insert(whole.end(), named.begin(), named.end());
    append(whole, static_cast<std::uint32_t>(crc32_z(0, named.data(), named.size())));
    return whole;
}

// The keyword, not compressed, without a language tag or a translated keyword.
Bytes text_chunk(std::string_view keyword, std::string_view text) {
    Bytes data;
    append(data, keyword);
    data.insert(data.end(), 5, 0);
    append(data, text);
    return chunk("iTXt", data);
}

Bytes after_header(Bytes png, const Bytes& chunks) {
    constexpr std::ptrdiff_t header = 8 + 25;  // the signature, and the chunk IHDR
    assert(static_cast<std::ptrdiff_t>(png.size()) > header);
    png.insert(png.begin() + header, chunks.begin(), chunks.end());
    return png;
}

}  // namespace

Bytes with_resolution(Bytes png, double dots_per_inch) {
    constexpr double inches_in_a_metre = 1.0 / 0.0254;
    const auto dots = static_cast<std::uint32_t>(std::lround(dots_per_inch * inches_in_a_metre));
    Bytes data;
    append(data, dots);  // across
    append(data, dots);  // up
    data.push_back(1);   // in a metre
    return after_header(std::move(png), chunk("pHYs", data));
}

Bytes with_words(Bytes png, const PictureWords& words) {
    Bytes chunks;
    const auto add = [&](std::string_view keyword, const std::string& text) {
        if (text.empty()) return;
        const Bytes added = text_chunk(keyword, text);
        chunks.insert(chunks.end(), added.begin(), added.end());
    };
    add("Title", words.title);
    add("Description", words.description);
    add("Source", words.origin);
    return after_header(std::move(png), chunks);
}

}  // namespace carom
