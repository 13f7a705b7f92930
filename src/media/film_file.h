// The file that a film is written to, for the writers of the formats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "media/film_writer.h"
#include "util/files/atomic_file.h"

namespace carom {

/// A film in one file. What is written to `file_` is the film, as far as it goes.
class FilmInFile : public FilmWriter {
  public:
    void settle() final;
    void commit() final;
    std::string name() const final { return file_.name(); }
    std::int64_t bytes() const final { return bytes_; }
    void copy(const std::function<void(std::string_view)>& take) const final;

  protected:
    /// A new file at the path or, if the settings say so, a temporary one. Throws as AtomicFile
    /// does.
    FilmInFile(const std::filesystem::path& path, VideoSettings settings);

    /// Writes the end of the film. Called once.
    virtual void write_end() = 0;

    const VideoSettings settings_;
    AtomicFile file_;

  private:
    std::int64_t bytes_ = 0;
};

}  // namespace carom
