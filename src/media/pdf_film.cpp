// Films as PDF documents of one page for each frame, as LaTeX's package animate takes them.
#include <stdexcept>
#include <utility>

#include "media/film_file.h"
#include "media/film_writer.h"
#include "util/files/atomic_file.h"

namespace carom {
namespace {

PictureWords words_of(const VideoSettings& settings) {
    PictureWords words;
    for (const auto& [key, value] : settings.metadata) {
        if (key == "title") words.title = value;
        if (key == "description") words.description = value;
        if (key == "comment") words.origin = value;
    }
    return words;
}

class PdfFilm : public FilmWriter {
  public:
    PdfFilm(const std::filesystem::path& path, const VideoSettings& settings)
        : file_(file_of_film(path, settings)),
          document_({settings.width, settings.height}, VectorFormat::pdf, words_of(settings)) {}

    Canvas* document() override { return &document_; }
    std::unique_ptr<FilmSegment> segment(int) override {
        throw std::logic_error("the pages of a PDF are drawn on its document");
    }
    void settle() override {
        if (!std::exchange(is_whole_, true)) {
            file_.write(document_.file());
            bytes_ = file_.size();
        }
        file_.settle();
    }
    void commit() override {
        settle();
        file_.commit();
    }
    std::string name() const override { return file_.name(); }
    std::int64_t bytes() const override { return bytes_; }
    void copy(const std::function<void(std::string_view)>& take) const override {
        copy_file(file_, take);
    }

  private:
    AtomicFile file_;
    Canvas document_;
    bool is_whole_ = false;
    std::int64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<FilmWriter> pdf_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int) {
    return std::make_unique<PdfFilm>(path, settings);
}

}  // namespace carom
