// Fingerprints of texts and files, to tell whether they are what they were. Not for secrets.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace carom {

/// 32 hexadecimal digits: XXH3 of 128 bits, the same on every machine.
std::string fingerprint(std::string_view bytes);

/// The same of pieces one after the other.
class GrowingFingerprint {
  public:
    GrowingFingerprint();
    ~GrowingFingerprint();
    GrowingFingerprint(const GrowingFingerprint&) = delete;
    GrowingFingerprint& operator=(const GrowingFingerprint&) = delete;

    void add(std::string_view bytes);
    std::string digits() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Of what is in a file; nothing where there is none, or no ordinary one. Throws SystemError where
/// it cannot be read.
std::optional<std::string> fingerprint_of_file(const std::filesystem::path& path);

}  // namespace carom
