// Films as PDF documents of one page for each frame, as LaTeX's package animate takes them.
#include <stdexcept>

#include "media/film_file.h"
#include "media/film_writer.h"

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

class PdfFilm : public FilmInFile {
  public:
    PdfFilm(const std::filesystem::path& path, const VideoSettings& settings)
        : FilmInFile(path, settings),
          document_({settings.width, settings.height}, VectorFormat::pdf, words_of(settings)) {}

    Canvas* document() override { return &document_; }
    std::unique_ptr<FilmSegment> segment(int) override {
        throw std::logic_error("the pages of a PDF are drawn on its document");
    }

  private:
    void write_end() override { file_.write(document_.file()); }

    Canvas document_;
};

}  // namespace

std::unique_ptr<FilmWriter> pdf_film(const std::filesystem::path& path,
                                     const VideoSettings& settings, int) {
    return std::make_unique<PdfFilm>(path, settings);
}

}  // namespace carom
