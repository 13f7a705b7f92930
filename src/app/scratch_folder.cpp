#include "app/scratch_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "util/diagnostics.h"
#include "util/files/scratch_file.h"
#include "util/pending/temporary.h"

namespace carom {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    const auto asked = asked_folder_for_scratch();
    const fs::path folder = asked.value_or("/tmp");
    std::error_code error;
    if (!fs::is_directory(folder, error)) {
        if (!error) error = std::make_error_code(std::errc::not_a_directory);
        throw SystemError(fmt::format("cannot write to the folder for temporary files{}: {}",
                                      asked ? fmt::format(" (TMPDIR is {})", asked->string()) : "",
                                      error.message()));
    }
    std::string name = (folder / "carom.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        const int cause = errno;
        throw_system_error(
            fmt::format("cannot write {}: {}", name, std::generic_category().message(cause)),
            cause);
    }
    path_ = name;
}

ScratchFolder::ScratchFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw_system_error(
            fmt::format("cannot create the folder {}: {}", folder.string(), error.message()),
            error.value());
    TemporaryFile made = temporary_folder(folder / "scratch");
    if (made.descriptor < 0) {
        const int cause = errno;
        throw_system_error(fmt::format("cannot write {}: {}", folder.string(),
                                       std::generic_category().message(cause)),
                           cause);
    }
    path_ = std::move(made.name);
    lock_ = made.descriptor;
}

ScratchFolder::~ScratchFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
    if (lock_ >= 0) close(lock_);
}

}  // namespace carom
