// Films as folders of numbered pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "media/film_writer.h"
#include "util/archive.h"
#include "util/files/atomic_file.h"
#include "util/files/spool.h"

namespace carom {
namespace {

class FrameFolder : public FilmWriter {
  public:
    FrameFolder(const std::filesystem::path& path, const VideoSettings& settings, int frames)
        : folder_(settings.is_scratch ? AtomicFolder(Scratch{}) : AtomicFolder(path)),
          digits_(std::max<std::size_t>(5, fmt::formatted_size("{}", frames))) {}

    std::unique_ptr<FilmSegment> segment(int first) override {
        return std::make_unique<Segment>(*this, first);
    }
    void settle() override { folder_.settle(); }
    void commit() override { folder_.commit(); }
    std::string name() const override { return folder_.name(); }
    std::int64_t bytes() const override { return bytes_; }

  private:
    class Segment : public FilmSegment {
      public:
        Segment(FrameFolder& film, int first) : film_(film), first_(first) {}
        void add(const Canvas& frame) override {
            const std::vector<std::uint8_t> png = frame.png();
            pictures_.add({png.begin(), png.end()});
        }
        void archive(Archive& archive) override { archive(pictures_); }
        void join() override {
            int number = first_;  // from 0; files count from 1
            for (std::size_t k = 0; k < pictures_.size(); ++k) {
                const std::string png = pictures_.piece(k);
                film_.folder_.write(
                    fmt::format("frame-{:0{}}.png", ++number, film_.digits_),
                    {reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
                film_.bytes_ += static_cast<std::int64_t>(png.size());
            }
        }

      private:
        FrameFolder& film_;
        int first_;
        Spool pictures_{most_encoded_bytes};
    };

    AtomicFolder folder_;
    std::size_t digits_;
    std::int64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<FilmWriter> folder_of_frames(const std::filesystem::path& path,
                                             const VideoSettings& settings, int frames) {
    return std::make_unique<FrameFolder>(path, settings, frames);
}

}  // namespace carom
