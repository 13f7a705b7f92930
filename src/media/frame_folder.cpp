// Films as folders of numbered pictures.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "media/film_writer.h"
#include "util/archive.h"
#include "util/files/atomic_file.h"

namespace carom {
namespace {

class FrameFolder : public FilmWriter {
  public:
    FrameFolder(const std::filesystem::path& path, int frames)
        : folder_(path), digits_(std::max<std::size_t>(5, fmt::formatted_size("{}", frames))) {}

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
        void add(const Canvas& frame) override { pictures_.push_back(frame.png()); }
        void archive(Archive& archive) override { archive(pictures_); }
        void join() override {
            int number = first_;  // from 0; files count from 1
            for (const std::vector<std::uint8_t>& png : pictures_) {
                film_.folder_.write(fmt::format("frame-{:0{}}.png", ++number, film_.digits_), png);
                film_.bytes_ += static_cast<std::int64_t>(png.size());
            }
        }

      private:
        FrameFolder& film_;
        int first_;
        std::vector<std::vector<std::uint8_t>> pictures_;
    };

    AtomicFolder folder_;
    std::size_t digits_;
    std::int64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<FilmWriter> folder_of_frames(const std::filesystem::path& path,
                                             const VideoSettings&, int frames) {
    return std::make_unique<FrameFolder>(path, frames);
}

}  // namespace carom
