#include "util/files/one_use_paths.h"

#include <fmt/format.h>

#include <mutex>
#include <set>
#include <system_error>

#include "util/diagnostics.h"
#include "util/pending/temporary.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

struct Uses {
    std::mutex mutex;
    std::set<std::string> sources, outputs;
};

Uses& uses() {
    static Uses all;
    return all;
}

// Returns the path with links followed, even if nothing exists there yet; empty if that fails.
std::string place_of(const fs::path& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    if (error) return "";
    const fs::path place = fs::weakly_canonical(absolute, error);
    return error ? "" : place.string();
}

[[noreturn]] void refuse_source(const fs::path& path) {
    throw UsageError(
        fmt::format("{}: this would overwrite a file that the work is read from; name another file",
                    path.string()));
}

}  // namespace

void keep_source(const fs::path& path) {
    const std::string place = place_of(path);
    if (place.empty()) return;
    const std::scoped_lock lock(uses().mutex);
    if (uses().outputs.contains(place)) refuse_source(path);
    uses().sources.insert(place);
}

// A link in the place of the file itself is replaced, not followed.
OutputPath::OutputPath(const fs::path& path, const fs::path& target)
    : place_(place_of(folder_of(target))) {
    if (!place_.empty()) place_ = (fs::path(place_) / target.filename()).string();
    if (place_.empty()) return;
    const std::scoped_lock lock(uses().mutex);
    if (uses().sources.contains(place_)) refuse_source(path);
    if (!uses().outputs.insert(place_).second)
        throw UsageError(fmt::format(
            "{}: two outputs would be written to this file; name another for one of them",
            path.string()));
}

OutputPath::~OutputPath() {
    if (place_.empty()) return;
    const std::scoped_lock lock(uses().mutex);
    uses().outputs.erase(place_);
}

}  // namespace carom
