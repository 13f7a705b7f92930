#include "scene/yaml/file_text.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "scene/limits.h"
#include "util/files/input_file.h"
#include "util/files/one_use_paths.h"
#include "util/interrupt.h"

namespace carom {

namespace fs = std::filesystem;

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
    errors.add(name, "cannot be read: " + std::generic_category().message(errno));
    return std::nullopt;
}

// A failure that may pass is no mistake of the user.
std::optional<std::string> file_text(const fs::path& path, const Source& name, Errors& errors) {
    InputFile file(path);
    if (file.is_open()) {
        keep_source(path);
        std::string text(most_file_bytes.count() + 1, '\0');
        text.resize(file.read(text));
        return text;
    }
    if (file.may_pass()) file.require_open();
    errors.add(name, "cannot be read: " + file.problem());
    return std::nullopt;
}

bool is_plain_name(const std::string& name) {
    return name.find_first_of("/\\") == std::string::npos && !name.starts_with('.');
}

}  // namespace carom
