// Fingerprints of texts, to detect whether they have changed. Not cryptographic.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace carom {

/// Returns 32 hexadecimal digits: the 128-bit XXH3 hash, the same on every machine.
std::string fingerprint(std::string_view bytes);

/// Computes the fingerprint of a text that is given in consecutive pieces.
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

}  // namespace carom
