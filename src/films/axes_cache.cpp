#include "films/axes_cache.h"

#include <fmt/format.h>

#include <memory>
#include <system_error>
#include <utility>

#include "scene/scene.h"
#include "util/diagnostics.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"
#include "util/fingerprint.h"
#include "util/progress.h"
#include "util/text.h"
#include "works/build_facts.h"

namespace carom {
namespace {

// Fingerprint of all that determines what the first pass finds. Paths are left out: a copy of a
// scene has the same axes.
std::string fingerprint_of(const SceneSource& source) {
    GrowingFingerprint all;
    const auto add = [&](const std::string& text) {
        all.add(std::to_string(text.size()) + ":");  // so that the boundaries between parts count
        all.add(text);
    };
    for (const auto& [name, value] : physics_build_facts()) add(value);
    add(source.text);
    add(source.template_text);
    for (const std::string& value : source.overrides) add(value);
    for (const auto& [path, text] : source.files) add(text);
    return all.digits();
}

}  // namespace

RunBits bits_of(const Scene& scene) {
    RunBits bits;
    for (const Scene* run : scenes_of_film(scene)) bits.push_back(run->run.bits);
    return bits;
}

Scene with_bits(Scene scene, const RunBits& bits) {
    auto next = bits.begin();
    if (next != bits.end()) scene.run.bits = *next++;
    for (ComparedRun& run : scene.film.runs.others) {
        if (next == bits.end()) break;
        auto other = std::make_shared<Scene>(*run.scene);
        other->run.bits = *next++;
        run.scene = std::move(other);
    }
    return scene;
}

AxesCache::AxesCache(const std::filesystem::path& folder, const Scene& asked) {
    if (folder.empty()) return;
    std::error_code error;
    const auto found = std::filesystem::status(folder, error);
    if (std::filesystem::exists(found) && !std::filesystem::is_directory(found))
        error = std::make_error_code(std::errc::not_a_directory);
    if (error == std::errc::not_a_directory)
        throw SystemError(fmt::format("--cache {}: cannot make this folder: {}", folder.string(),
                                      error.message()));
    file_ = {folder, fingerprint_of(asked.source) + ".axes"};
}

std::optional<SettledAxes> AxesCache::find() const {
    constexpr std::int64_t most_bytes = std::int64_t{1} << 30;
    if (file_.name.empty()) return std::nullopt;
    try {
        Archive archive(read_file(file_, most_bytes), file_.path().string());
        SettledAxes settled;
        archive(settled);
        archive.expect_end();
        return settled;
    } catch (const SystemError&) {
        return std::nullopt;
    }
}

void AxesCache::keep(SettledAxes settled) const {
    if (file_.name.empty()) return;
    Archive archive;
    archive(settled);
    try {
        write_file(file_, archive.finished());
    } catch (const SystemError& error) {
        print_to_stderr(fmt::format("carom: --cache: {}; nothing is kept for the next time\n",
                                    printable(error.what())));
    }
}

}  // namespace carom
