#include "media/image_writer.h"

#include "util/atomic_file.h"

namespace carom {

void write_image(Canvas& canvas, const std::filesystem::path& path) {
    AtomicFile file{path};
    file.write(canvas.file());
    file.commit();
}

}  // namespace carom
