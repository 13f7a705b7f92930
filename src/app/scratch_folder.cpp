#include "app/scratch_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

#include "util/diagnostics.h"

namespace carom {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "carom.XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr)
        throw SystemError(
            fmt::format("cannot write {}: {}", name,
                        error ? error.message() : std::generic_category().message(errno)));
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
}

}  // namespace carom
