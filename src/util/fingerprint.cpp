#include "util/fingerprint.h"

#include <fmt/format.h>

// Compiled in, so that what links this module needs no library for it.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <fstream>
#include <memory>
#include <vector>

namespace carom {
namespace {

std::string digits(const XXH128_hash_t& hash) {
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

}  // namespace

std::string fingerprint(std::string_view bytes) {
    return digits(XXH3_128bits(bytes.data(), bytes.size()));
}

std::optional<std::string> fingerprint_of_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream file(path, std::ios::binary);
    const std::unique_ptr<XXH3_state_t, FreeState> state{XXH3_createState()};
    if (!file || !state) return std::nullopt;
    XXH3_128bits_reset(state.get());
    std::vector<char> buffer(1 << 18);
    while (file) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        XXH3_128bits_update(state.get(), buffer.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (!file.eof()) return std::nullopt;
    return digits(XXH3_128bits_digest(state.get()));
}

}  // namespace carom
