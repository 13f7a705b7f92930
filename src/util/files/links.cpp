#include "util/files/links.h"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include "util/diagnostics.h"
#include "util/pending/temporary.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
    throw_system_error(
        fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(error)),
        error);
}

}  // namespace

fs::path behind_links(const fs::path& path) {
    constexpr int most = 40;  // as the system follows
    fs::path target = path;
    std::error_code error;
    for (int i = 0; fs::is_symlink(fs::symlink_status(target, error)); ++i) {
        if (i == most) fail(path, ELOOP);
        target = folder_of(target) / fs::read_symlink(target, error);
        if (error) fail(path, error.value());
    }
    return target;
}

}  // namespace carom
