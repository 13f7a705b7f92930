// Common parts of the fuzz targets: how they read their input, and which errors are expected for
// any input. A target is one file that accepts any bytes and returns normally; anything else is a
// find. docs/trust.md describes how they are run.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "support/files.h"
#include "util/diagnostics.h"
#include "util/interrupt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace carom::test {

/// The target: handles one input.
void fuzz(const std::uint8_t* data, std::size_t size);

/// Reads the bytes of an input in sequence; after its end all bytes are 0.
class FuzzInput {
  public:
    FuzzInput(const std::uint8_t* data, std::size_t size)
        : rest_(reinterpret_cast<const char*>(data), size) {}

    bool is_at_end() const { return rest_.empty(); }

    std::uint8_t byte() {
        if (rest_.empty()) return 0;
        const char first = rest_.front();
        rest_.remove_prefix(1);
        return static_cast<std::uint8_t>(first);
    }

    /// A number in [0, count); `count` must not be 0.
    std::size_t below(std::size_t count) {
        const std::size_t high = count > 256 ? byte() : 0;
        return (high << 8 | byte()) % count;
    }

    template <class List>
    const auto& one_of(const List& list) {
        return list[below(list.size())];
    }

  private:
    std::string_view rest_;
};

inline std::string fuzz_text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// The lines of a text, without their breaks.
inline std::vector<std::string> fuzz_lines(const std::string& text) {
    std::vector<std::string> lines{""};
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    return lines;
}

/// Executes `work`. Returns whether it completed; false if the input was rejected with a message.
template <class Work>
bool succeeds(const Work& work) {
    try {
        work();
        return true;
    } catch (const SceneError& error) {
        if (error.diagnostics().empty()) std::abort();
    } catch (const UsageError&) {
    } catch (const SystemError&) {
    } catch (const Interrupted&) {
    }
    return false;
}

/// A folder of this process, removed when the process ends.
inline const std::filesystem::path& fuzz_folder() {
    static const TemporaryFolder folder;
    return folder.path();
}

}  // namespace carom::test
