#include "media/image_writer.h"

#include "util/atomic_file.h"

namespace carom {

void write_png(const Canvas& canvas, const std::filesystem::path& path) {
    AtomicFile file{path};
    file.write(canvas.png());
    file.commit();
}

}  // namespace carom
