#include "films/chunks/chunk_file.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "util/archive.h"

namespace carom {
namespace {

constexpr std::size_t length_bytes = 8;

// The bytes, preceded by their length as a little-endian number.
std::string with_length(const std::string& bytes) {
    std::string whole;
    for (std::size_t i = 0; i < length_bytes; ++i)
        whole += static_cast<char>(static_cast<std::uint64_t>(bytes.size()) >> (8 * i) & 0xff);
    return whole + bytes;
}

}  // namespace

class ChunkWriter::Segment : public FilmSegment {
  public:
    Segment(AtomicFile& file, std::unique_ptr<FilmSegment> encoded)
        : file_(file), encoded_(std::move(encoded)) {}
    void add(const Canvas& frame) override { encoded_->add(frame); }
    void finish() override { encoded_->finish(); }
    void archive(Archive& archive) override { encoded_->archive(archive); }
    void join() override {
        Archive content;
        encoded_->archive(content);
        file_.write(with_length(content.finished()));
    }

  private:
    AtomicFile& file_;
    std::unique_ptr<FilmSegment> encoded_;
};

ChunkWriter::ChunkWriter(const StoredFile& path, ChunkIdentity identity, FilmWriter& encoder)
    : file_(path), encoder_(encoder) {
    Archive header;
    header(identity);
    file_.write(with_length(header.finished()));
}

std::unique_ptr<FilmSegment> ChunkWriter::segment(int first) {
    return std::make_unique<Segment>(file_, encoder_.segment(first));
}

void ChunkWriter::commit() {
    bytes_ = file_.size();
    file_.commit();
}

ChunkReader::ChunkReader(const StoredFile& stored, const ChunkIdentity& expected)
    : path_(stored.path().string()), file_(stored) {
    file_.require_open();
    left_ = static_cast<std::uint64_t>(file_.size());
    Archive header(next(), path_);
    ChunkIdentity identity;
    header(identity);
    header.expect_end();
    if (identity != expected)
        header.refuse(fmt::format("it is chunk {} of another plan", identity.number));
}

std::string ChunkReader::next() {
    std::array<char, length_bytes> length{};
    const bool is_short = file_.read(length) < length_bytes;
    std::uint64_t size = 0;
    for (std::size_t i = length_bytes; i-- > 0;)
        size = size << 8 | static_cast<unsigned char>(length[i]);
    if (is_short || left_ < length_bytes || size > left_ - length_bytes)
        file_.refuse("it is cut short");
    left_ -= length_bytes + size;
    std::string bytes(size, '\0');
    if (file_.read(bytes) < size) file_.refuse("it is cut short");
    return bytes;
}

void ChunkReader::read(FilmSegment& segment) {
    Archive content(next(), path_);
    segment.archive(content);
    content.expect_end();
}

void ChunkReader::expect_end() {
    if (left_ > 0) file_.refuse("there are data after its end");
}

}  // namespace carom
