// The file of a chunk: its encoded segments one after the other, each with its own fingerprint, so
// that neither writing nor joining holds more than one of them in memory.
#pragma once

#include <cstdint>
#include <string>

#include "media/film_writer.h"
#include "util/files/atomic_file.h"
#include "util/files/input_file.h"

namespace carom {

/// Identifies the chunk that a file holds.
struct ChunkIdentity {
    std::string plan;  ///< as PlanFolder::fingerprint()
    int number = 0;
    int segments = 0;

    friend bool operator==(const ChunkIdentity&, const ChunkIdentity&) = default;

    template <class Archive>
    void archive(Archive& archive) {
        archive(plan, number, segments);
    }
};

/// Writes the segments of a chunk, encoded by `encoder`, to a file that appears complete or not at
/// all.
class ChunkWriter : public FilmWriter {
  public:
    ChunkWriter(const StoredFile& path, ChunkIdentity identity, FilmWriter& encoder);
    std::unique_ptr<FilmSegment> segment(int first) override;
    void settle() override { file_.settle(); }
    void commit() override;
    std::string name() const override { return file_.name(); }
    std::int64_t bytes() const override { return bytes_; }

  private:
    class Segment;

    AtomicFile file_;
    FilmWriter& encoder_;
    std::int64_t bytes_ = 0;
};

/// Reads the segments back in order. All functions throw SystemError if the file is damaged.
class ChunkReader {
  public:
    /// Throws SystemError if the file holds another chunk than `expected`.
    ChunkReader(const StoredFile& stored, const ChunkIdentity& expected);

    /// Reads the next segment into a new one.
    void read(FilmSegment& segment);
    void expect_end();

  private:
    std::string next();

    std::string path_;
    InputFile file_;
    std::uint64_t left_ = 0;  ///< bytes not read yet
};

}  // namespace carom
