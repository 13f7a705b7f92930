#include "media/film_file.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "util/interrupt.h"

namespace carom {

FilmInFile::FilmInFile(const std::filesystem::path& path, VideoSettings settings)
    : settings_(std::move(settings)),
      file_(settings_.is_scratch ? AtomicFile(Scratch{}) : AtomicFile(path)) {}

void FilmInFile::settle() {
    if (bytes_ > 0) return;
    write_end();
    bytes_ = file_.size();
    file_.settle();
}

void FilmInFile::commit() {
    settle();
    file_.commit();
}

void FilmInFile::copy(const std::function<void(std::string_view)>& take) const {
    constexpr std::size_t block = 1 << 18;
    std::vector<std::uint8_t> buffer(block);
    std::int64_t place = 0;
    while (const std::size_t count = file_.read_at(place, buffer)) {
        throw_if_interrupted();
        take({reinterpret_cast<const char*>(buffer.data()), count});
        place += static_cast<std::int64_t>(count);
    }
}

}  // namespace carom
