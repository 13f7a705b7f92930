#include "scene/yaml/file_text.h"

#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>

#include "scene/limits.h"
#include "util/files/one_use_paths.h"
#include "util/interrupt.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string cause(int error) { return std::generic_category().message(error); }

}  // namespace

// Reads up to one byte over the limit, so that the reader then refuses the text.
std::optional<std::string> text_of(std::FILE& file, const Source& name, Errors& errors) {
    constexpr std::size_t block = 65'536;
    const std::size_t most = most_file_bytes.count() + 1;
    std::string text;
    while (text.size() < most) {
        const std::size_t size = text.size(), wanted = std::min(block, most - size);
        text.resize(size + wanted);
        const std::size_t got = std::fread(text.data() + size, 1, wanted, &file);
        text.resize(size + got);
        if (got == wanted) continue;
        if (std::ferror(&file) == 0 || errno != EINTR) break;
        throw_if_interrupted();  // a terminal or pipe that sends nothing must not hold Ctrl-C
        std::clearerr(&file);
    }
    if (std::ferror(&file) == 0) return text;
    errors.add(name, "cannot be read: " + cause(errno));
    return std::nullopt;
}

// Refuses devices and pipes that are given as paths: their text may never end.
std::optional<std::string> file_text(const fs::path& path, const Source& name, Errors& errors) {
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    std::string reason;
    if (fs::is_directory(status))
        reason = "it is a folder";
    else if (fs::exists(status) && !fs::is_regular_file(status))
        reason = "it is no ordinary file";
    else if (const File file{std::fopen(path.c_str(), "rb")}) {
        keep_source(path);
        return text_of(*file, name, errors);
    } else
        reason = cause(errno);
    errors.add(name, "cannot be read: " + reason);
    return std::nullopt;
}

bool is_plain_name(const std::string& name) {
    return name.find_first_of("/\\") == std::string::npos && !name.starts_with('.');
}

}  // namespace carom
