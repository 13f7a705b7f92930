// Serialises values to bytes that another process can read back: numbers, text, lists and nested
// values, in one order shared by writing and reading. Little-endian; with a version, a length and a
// fingerprint, so that truncated or modified data are refused as a whole.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace carom {

class Archive;

/// A value that lists its own parts: `void archive(Archive& archive) { archive(a_, b_); }`.
template <class T>
concept Archivable = requires(T& value, Archive& archive) {
    value.archive(archive);
};

/// A value whose parts are listed by a free function, `archive_parts(archive, value)`: for types of
/// modules that do not depend on this one.
template <class T>
concept PartsListed = requires(T& value, Archive& archive) {
    archive_parts(archive, value);
};

/// A dense Eigen array or matrix of any shape.
template <class T>
concept MatrixLike = requires(T& value) {
    typename T::Scalar;
    value.resize(value.rows(), value.cols());
    value.data();
};

/// Writes values, or reads them back into values of the same types in the same order. Not
/// thread-safe.
class Archive {
  public:
    /// Constructs an archive for writing; finished() returns the bytes.
    Archive() = default;

    /// Constructs an archive that reads `bytes`, as returned by finished(); messages call them
    /// `name`. Throws SystemError if they are of another kind or version, truncated, or modified.
    Archive(std::string bytes, std::string name);

    bool is_reading() const { return reading_; }

    /// Writes each of the values, or replaces each by the one that was written. Throws SystemError
    /// if there are fewer bytes to read.
    template <class... T>
    void operator()(T&... values) {
        (value(values), ...);
    }

    /// Returns everything written, after a header with version, length and fingerprint.
    std::string finished() const;

    /// Throws SystemError if bytes remain to be read: then values of other types were written.
    void expect_end() const;

    /// Throws SystemError that names the bytes and says what is wrong with them, `cause`.
    [[noreturn]] void refuse(const std::string& cause) const;

  private:
    void bytes(void* data, std::size_t size);
    /// Writes or reads the size of a list. A size that is read is refused if the remaining bytes
    /// cannot hold that many items of at least `bytes` bytes each.
    std::size_t size_of(std::size_t size, std::size_t bytes = 1);
    std::size_t area_of(std::int64_t rows, std::int64_t columns, std::size_t bytes) const;

    template <class T>
    void number(T& value) {
        std::array<std::byte, sizeof(T)> raw{};
        if (!reading_) std::memcpy(raw.data(), &value, sizeof(T));
        if constexpr (std::endian::native == std::endian::big) reverse(raw.data(), raw.size());
        bytes(raw.data(), raw.size());
        if constexpr (std::endian::native == std::endian::big) reverse(raw.data(), raw.size());
        if (reading_) std::memcpy(&value, raw.data(), sizeof(T));
    }

    template <class T>
    void numbers(T* data, std::size_t count) {
        if constexpr (std::endian::native == std::endian::little)
            bytes(data, count * sizeof(T));
        else
            for (std::size_t i = 0; i < count; ++i) number(data[i]);
    }

    template <class T>
    void value(T& object) {
        if constexpr (std::same_as<T, bool>) {
            // When reading, the value may be uninitialised and hence not a valid bool.
            auto whole = reading_ ? std::uint8_t{0} : static_cast<std::uint8_t>(object);
            number(whole);
            object = whole != 0;
        } else if constexpr (std::is_enum_v<T>) {
            auto whole = reading_ ? std::int64_t{0} : static_cast<std::int64_t>(object);
            number(whole);
            object = static_cast<T>(whole);
        } else if constexpr (std::is_arithmetic_v<T>) {
            number(object);
        } else if constexpr (Archivable<T>) {
            object.archive(*this);
        } else if constexpr (PartsListed<T>) {
            archive_parts(*this, object);
        } else if constexpr (MatrixLike<T>) {
            matrix(object);
        } else {
            parts(object);
        }
    }

    template <class T>
    void matrix(T& object) {
        auto rows = static_cast<std::int64_t>(object.rows()), columns = std::int64_t{object.cols()};
        number(rows);
        number(columns);
        const std::size_t count = area_of(rows, columns, sizeof(typename T::Scalar));
        const auto is = [](std::int64_t size, std::int64_t fixed) {
            return fixed < 0 || size == fixed;
        };
        if (!is(rows, T::RowsAtCompileTime) || !is(columns, T::ColsAtCompileTime))
            refuse("it holds an array of another shape");
        if (reading_) object.resize(rows, columns);
        if constexpr (std::same_as<typename T::Scalar, bool>)
            for (std::size_t i = 0; i < count; ++i) value(object.data()[i]);
        else
            numbers(object.data(), count);
    }

    void parts(std::string& text) {
        const std::size_t size = size_of(text.size());
        if (reading_) text.resize(size);
        bytes(text.data(), size);
    }

    template <class T, class Allocator>
    void parts(std::vector<T, Allocator>& list) {
        if constexpr (std::is_arithmetic_v<T>) {
            const std::size_t size = size_of(list.size(), sizeof(T));
            if (reading_) list.resize(size);
            numbers(list.data(), size);
        } else {
            items(list);
        }
    }

    void parts(std::vector<bool>& list) {
        const std::size_t size = size_of(list.size());
        if (reading_) list.resize(size);
        for (std::size_t k = 0; k < size; ++k) {
            bool item = list[k];
            value(item);
            list[k] = item;
        }
    }

    template <class T>
    void parts(std::deque<T>& list) {
        items(list);
    }

    // When reading, the list grows as its items are read, so that a wrong size cannot allocate far
    // more memory than there are bytes.
    template <class List>
    void items(List& list) {
        constexpr std::size_t most_unread = 1024;
        const std::size_t size = size_of(list.size());
        if (list.size() > size) list.resize(size);
        for (std::size_t k = 0; k < size; ++k) {
            if (k == list.size()) list.resize(std::min(size, k + most_unread));
            value(list[k]);
        }
    }

    template <class T, std::size_t count>
    void parts(std::array<T, count>& list) {
        for (T& item : list) value(item);
    }

    template <class A, class B>
    void parts(std::pair<A, B>& both) {
        value(both.first);
        value(both.second);
    }

    template <class T>
    void parts(std::optional<T>& object) {
        bool there = object.has_value();
        value(there);
        if (reading_) there ? void(object.emplace()) : object.reset();
        if (object) value(*object);
    }

    template <class... T>
    void parts(std::variant<T...>& object) {
        auto index = static_cast<std::int64_t>(object.index());
        number(index);
        if (reading_) {
            std::int64_t k = 0;
            const bool known = ((k++ == index ? (void(object = T{}), true) : false) || ...);
            if (!known) refuse("it holds a value of an unknown type");
        }
        std::visit([this](auto& alternative) { value(alternative); }, object);
    }

    template <class Key, class T>
    void parts(std::map<Key, T>& object) {
        ordered<std::pair<Key, T>>(object);
    }

    template <class Key, class T>
    void parts(std::multimap<Key, T>& object) {
        ordered<std::pair<Key, T>>(object);
    }

    template <class T>
    void parts(std::set<T>& object) {
        ordered<T>(object);
    }

    template <class Item, class Container>
    void ordered(Container& object) {
        std::vector<Item> list(object.begin(), object.end());
        value(list);
        if (reading_) object = {list.begin(), list.end()};
    }

    static void reverse(std::byte* data, std::size_t size) {
        for (std::size_t i = 0; 2 * i + 1 < size; ++i) std::swap(data[i], data[size - 1 - i]);
    }

    bool reading_ = false;
    std::string name_;
    std::string content_;
    std::size_t at_ = 0;  ///< position in the content while reading
};

}  // namespace carom
