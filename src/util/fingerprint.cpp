#include "util/fingerprint.h"

#include <fmt/format.h>

// Compiled in, so that what links this module needs no library for it.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fstream>
#include <vector>

namespace carom {
namespace {

std::string digits(const XXH128_hash_t& hash) {
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string fingerprint(std::string_view bytes) {
    return digits(XXH3_128bits(bytes.data(), bytes.size()));
}

struct GrowingFingerprint::State {
    XXH3_state_t hash;  // aligned as it asks for
};

GrowingFingerprint::GrowingFingerprint() : state_(std::make_unique<State>()) {
    XXH3_128bits_reset(&state_->hash);
}

GrowingFingerprint::~GrowingFingerprint() = default;

void GrowingFingerprint::add(std::string_view bytes) {
    XXH3_128bits_update(&state_->hash, bytes.data(), bytes.size());
}

std::string GrowingFingerprint::digits() const {
    return carom::digits(XXH3_128bits_digest(&state_->hash));
}

std::optional<std::string> fingerprint_of_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    GrowingFingerprint all;
    std::vector<char> buffer(1 << 18);
    while (file) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        all.add({buffer.data(), static_cast<std::size_t>(file.gcount())});
    }
    if (!file.eof()) return std::nullopt;
    return all.digits();
}

}  // namespace carom
