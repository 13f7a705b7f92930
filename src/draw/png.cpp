#include "draw/png.h"

#include <zlib.h>

#include <cassert>
#include <string>
#include <string_view>

namespace carom {
namespace {

using Bytes = std::vector<std::uint8_t>;

void append(Bytes& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(number >> shift & 0xFFU);
}

void append(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

// The keyword, not compressed, without a language tag or a translated keyword.
Bytes text_chunk(std::string_view keyword, std::string_view text) {
    Bytes body;
    append(body, "iTXt");
    append(body, keyword);
    body.insert(body.end(), 5, 0);
    append(body, text);
    Bytes chunk;
    append(chunk, static_cast<std::uint32_t>(body.size() - 4));
    chunk.insert(chunk.end(), body.begin(), body.end());
    append(chunk, static_cast<std::uint32_t>(crc32_z(0, body.data(), body.size())));
    return chunk;
}

}  // namespace

Bytes with_words(Bytes png, const PictureWords& words) {
    constexpr std::ptrdiff_t after_header = 8 + 25;  // the signature, and the chunk IHDR
    assert(static_cast<std::ptrdiff_t>(png.size()) > after_header);
    Bytes chunks;
    const auto add = [&](std::string_view keyword, const std::string& text) {
        if (text.empty()) return;
        const Bytes chunk = text_chunk(keyword, text);
        chunks.insert(chunks.end(), chunk.begin(), chunk.end());
    };
    add("Title", words.title);
    add("Description", words.description);
    add("Source", words.origin);
    png.insert(png.begin() + after_header, chunks.begin(), chunks.end());
    return png;
}

}  // namespace carom
