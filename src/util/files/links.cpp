#include "util/files/links.h"

#include <cerrno>
#include <system_error>

#include "util/files/new_file.h"
#include "util/pending/temporary.h"

namespace carom {

namespace fs = std::filesystem;

fs::path behind_links(const fs::path& path) {
    constexpr int most = 40;  // as many links as the system follows
    fs::path target = path;
    std::error_code error;
    for (int i = 0; fs::is_symlink(fs::symlink_status(target, error)); ++i) {
        if (i == most) throw_unwritable(path, ELOOP);
        target = folder_of(target) / fs::read_symlink(target, error);
        if (error) throw_unwritable(path, error.value());
    }
    return target;
}

bool is_taken(const fs::path& path) {
    std::error_code error;
    return fs::exists(fs::symlink_status(path, error));
}

}  // namespace carom
