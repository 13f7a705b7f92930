#include "media/film_file.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "util/interrupt.h"

namespace carom {

void copy_file(const AtomicFile& file, const std::function<void(std::string_view)>& take) {
    constexpr std::size_t block = 1 << 18;
    std::vector<std::uint8_t> buffer(block);
    std::int64_t place = 0;
    while (const std::size_t count = file.read_at(place, buffer)) {
        throw_if_interrupted();
        take({reinterpret_cast<const char*>(buffer.data()), count});
        place += static_cast<std::int64_t>(count);
    }
}

}  // namespace carom
