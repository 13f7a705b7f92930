#include "util/files/scratch_file.h"

#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "util/diagnostics.h"
#include "util/files/new_file.h"
#include "util/pending/temporary.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

// An empty $TMPDIR is none.
std::optional<fs::path> asked_folder() {
    const char* const asked = std::getenv("TMPDIR");
    if (asked == nullptr || *asked == '\0') return std::nullopt;
    return asked;
}

std::int64_t half_of_free(const fs::path& folder) {
    struct statvfs its = {};
    if (statvfs(folder.c_str(), &its) != 0) return 0;
    const double free = static_cast<double>(its.f_bavail) * static_cast<double>(its.f_frsize);
    constexpr double largest = 1e18;
    return static_cast<std::int64_t>(std::min(0.5 * free, largest));
}

}  // namespace

// /tmp may be in memory; /var/tmp is on a disk.
fs::path folder_for_scratch() {
    if (const auto asked = asked_folder()) return *asked;
    return access("/var/tmp", W_OK) == 0 ? "/var/tmp" : "/tmp";
}

void require_folder_for_scratch() {
    std::error_code error;
    if (fs::is_directory(folder_for_scratch(), error)) return;
    if (!error) error = std::make_error_code(std::errc::not_a_directory);
    const auto asked = asked_folder();
    throw SystemError(fmt::format("cannot write to the folder for temporary files{}: {}",
                                  asked ? fmt::format(" (TMPDIR is {})", asked->string()) : "",
                                  error.message()));
}

ScratchFile::ScratchFile(std::int64_t most) : most_(std::min(most, room())) {
    if (most_ <= 0) return;
    const TemporaryFile file = temporary_file(folder_for_scratch() / "scratch");
    descriptor_ = file.descriptor;
    // If that fails, it is removed by the next process that creates a temporary file there.
    if (!file.name.empty()) unlink(file.name.c_str());
}

ScratchFile::~ScratchFile() {
    if (descriptor_ >= 0) close(descriptor_);
}

std::int64_t ScratchFile::room() {
    return std::min(most_bytes, half_of_free(folder_for_scratch()));
}

std::optional<std::int64_t> ScratchFile::append(std::span<const std::byte> bytes) {
    const auto length = static_cast<std::int64_t>(bytes.size());
    if (descriptor_ < 0 || length > most_ - size_) return std::nullopt;
    if (write_at(descriptor_, size_, bytes) != 0) return std::nullopt;
    size_ += length;
    return size_ - length;
}

void ScratchFile::read(std::int64_t place, std::span<std::byte> to) const {
    const auto count = read_at(descriptor_, place, to);
    if (count && *count == to.size()) return;
    const int error = count ? EIO : errno;
    throw_system_error(
        fmt::format("cannot read a temporary file in {}: {}", folder_for_scratch().string(),
                    count ? "it is too short" : std::generic_category().message(error)),
        error);
}

}  // namespace carom
