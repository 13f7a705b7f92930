#include "util/fingerprint.h"

#include <fmt/format.h>

// Compiled in, so that what links this module needs no library for it.
#define XXH_INLINE_ALL
#include <xxhash.h>

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

}  // namespace carom
