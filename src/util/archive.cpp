#include "util/archive.h"

#include <fmt/format.h>

#include "util/diagnostics.h"
#include "util/fingerprint.h"

namespace carom {
namespace {

// "carom", a byte that no text contains, and a line end that shows whether line ends were
// translated.
constexpr std::string_view signature{"carom\xff\r\n", 8};
constexpr std::uint32_t version = 1;
constexpr std::size_t fingerprint_size = 32;
constexpr std::size_t header_size = signature.size() + 4 + 8 + fingerprint_size;

void put(std::string& bytes, std::uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
}

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint64_t number = 0;
    for (std::size_t i = size; i-- > 0;)
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

}  // namespace

Archive::Archive(std::string bytes, std::string name) : reading_(true), name_(std::move(name)) {
    if (!bytes.starts_with(signature.substr(0, bytes.size())))
        refuse("it was not written by carom");
    if (bytes.size() < header_size) refuse("it is cut short");
    const std::uint64_t its = number_at(bytes, signature.size(), 4);
    if (its != version)
        refuse(fmt::format("it has version {}, and this program reads version {}", its, version));
    const std::uint64_t length = number_at(bytes, signature.size() + 4, 8);
    if (bytes.size() - header_size < length)
        refuse(fmt::format("it is cut short: {} of {} bytes are there", bytes.size(),
                           header_size + length));
    if (bytes.size() - header_size > length) refuse("there are data after its end");
    const std::string expected = bytes.substr(header_size - fingerprint_size, fingerprint_size);
    content_ = std::move(bytes.erase(0, header_size));
    if (fingerprint(content_) != expected) refuse("its content was changed after it was written");
}

std::string Archive::finished() const {
    std::string whole{signature};
    put(whole, version, 4);
    put(whole, content_.size(), 8);
    return whole + fingerprint(content_) + content_;
}

void Archive::expect_end() const {
    if (at_ != content_.size())
        refuse(fmt::format("{} of {} bytes were not expected", content_.size() - at_,
                           content_.size()));
}

void Archive::refuse(const std::string& cause) const {
    throw SystemError(fmt::format("cannot read {}: {}", name_, cause));
}

void Archive::bytes(void* data, std::size_t size) {
    if (size == 0) return;
    if (!reading_) {
        content_.append(static_cast<const char*>(data), size);
        return;
    }
    if (content_.size() - at_ < size) refuse("it ends early");
    std::memcpy(data, content_.data() + at_, size);
    at_ += size;
}

// A corrupt size must not make the list larger than memory.
std::size_t Archive::size_of(std::size_t size, std::size_t bytes) {
    auto whole = static_cast<std::uint64_t>(size);
    number(whole);
    if (reading_ && whole > (content_.size() - at_) / bytes) refuse("it ends early");
    return static_cast<std::size_t>(whole);
}

std::size_t Archive::area_of(std::int64_t rows, std::int64_t columns, std::size_t bytes) const {
    const auto most = static_cast<std::int64_t>((content_.size() - at_) / bytes);
    if (reading_ && (rows < 0 || columns < 0 || (columns > 0 && rows > most / columns)))
        refuse("it ends early");
    return static_cast<std::size_t>(rows * columns);
}

}  // namespace carom
