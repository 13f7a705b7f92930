#include "util/files/spool.h"

#include <optional>
#include <span>
#include <utility>

#include "util/archive.h"

namespace carom {

void Spool::add(std::string piece) {
    if (in_memory_ + piece.size() > most_in_memory_) {
        if (!file_) file_ = std::make_unique<ScratchFile>();
        if (const auto place = file_->append(std::as_bytes(std::span(piece)))) {
            pieces_.push_back({{}, *place, piece.size()});
            return;
        }
    }
    in_memory_ += piece.size();
    pieces_.push_back({std::move(piece)});
}

std::string Spool::piece(std::size_t k) const {
    const Piece& its = pieces_[k];
    if (its.place < 0) return its.bytes;
    std::string bytes(its.length, '\0');
    file_->read(its.place, std::as_writable_bytes(std::span(bytes)));
    return bytes;
}

void Spool::archive(Archive& archive) {
    auto count = static_cast<std::int64_t>(size());
    archive(count);
    for (std::int64_t k = 0; k < count; ++k) {
        std::string bytes;
        if (!archive.is_reading()) bytes = piece(static_cast<std::size_t>(k));
        archive(bytes);
        if (archive.is_reading()) add(std::move(bytes));
    }
}

}  // namespace carom
