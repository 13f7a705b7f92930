#include "util/fingerprint.h"

#include <fmt/format.h>

// Compiled in, so that what links this module needs no library for it.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "util/diagnostics.h"

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
    const auto refuse = [&] {
        const int reason = errno;
        throw_system_error(fmt::format("cannot read {}: {}", path.string(),
                                       std::generic_category().message(reason)),
                           reason);
    };
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file && errno == ENOENT) return std::nullopt;  // removed meanwhile
    if (!file) refuse();
    GrowingFingerprint all;
    std::vector<char> buffer(1 << 18);
    while (file) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        all.add({buffer.data(), static_cast<std::size_t>(file.gcount())});
    }
    if (!file.eof()) refuse();
    return all.digits();
}

}  // namespace carom
