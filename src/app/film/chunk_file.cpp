#include "app/film/chunk_file.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "util/archive.h"
#include "util/diagnostics.h"

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

ChunkWriter::ChunkWriter(const std::filesystem::path& path, ChunkIdentity identity,
                         FilmWriter& encoder)
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

ChunkReader::ChunkReader(const std::filesystem::path& path, const ChunkIdentity& expected)
    : path_(path) {
    errno = 0;
    file_.open(path, std::ios::binary);
    if (!file_) refuse();
    std::error_code error;
    left_ = std::filesystem::file_size(path, error);
    errno = error.value();
    if (error) refuse();
    Archive header(next(), path_.string());
    ChunkIdentity identity;
    header(identity);
    header.expect_end();
    if (identity != expected)
        header.refuse(fmt::format("it is chunk {} of another plan", identity.number));
}

std::string ChunkReader::next() {
    std::array<unsigned char, length_bytes> length{};
    errno = 0;
    file_.read(reinterpret_cast<char*>(length.data()), length_bytes);
    std::uint64_t size = 0;
    for (std::size_t i = length_bytes; i-- > 0;) size = size << 8 | length[i];
    if (!file_ || left_ < length_bytes || size > left_ - length_bytes) refuse();
    left_ -= length_bytes + size;
    std::string bytes(size, '\0');
    file_.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!file_) refuse();
    return bytes;
}

// The message gives the error of the system, if there was one.
void ChunkReader::refuse() const {
    const int reason = errno;
    throw_system_error(
        fmt::format("cannot read {}: {}", path_.string(),
                    reason == 0 ? "it is cut short" : std::generic_category().message(reason)),
        reason);
}

void ChunkReader::read(FilmSegment& segment) {
    Archive content(next(), path_.string());
    segment.archive(content);
    content.expect_end();
}

void ChunkReader::expect_end() {
    if (left_ > 0)
        throw SystemError(
            fmt::format("cannot read {}: something stands behind its end", path_.string()));
}

}  // namespace carom
