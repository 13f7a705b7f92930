// Messages about errors in a user's input: place, error, and how to correct it. Owns the value
// types and their text form; independent of YAML and of the command line.
#pragma once

#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// A place in a text; lines and columns count from 1. Line 0 means the whole file, or a text
/// without lines such as a command line, where only `column` matters. `length` is in characters
/// (code points).
struct SourceSpan {
    std::string file;
    int line = 0;
    int column = 0;
    int length = 1;
};

/// One error of a user's input. `source_line` is the whole line the span points into, empty if
/// unknown.
struct Diagnostic {
    SourceSpan span;
    std::string message;  ///< what was expected and what was found; lower case, no full stop
    std::string hint;     ///< how to correct it; may be empty
    std::string source_line;
};

/// The text of a diagnostic: `file:line:column: error: message`, the line (cut around the place
/// when it is long), a caret, `hint: ...`; no trailing newline.
std::string to_text(const Diagnostic& diagnostic);

/// The user's input is wrong (exit code 2). Holds all diagnostics found at once.
class SceneError : public std::runtime_error {
  public:
    explicit SceneError(std::vector<Diagnostic> diagnostics);
    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

  private:
    std::vector<Diagnostic> diagnostics_;
};

/// Returns what `make` gives for each item. If it throws SceneError for any items, throws one
/// SceneError with the diagnostics of all of them.
template <class Items, class Make>
auto all_made(const Items& items, const Make& make) {
    std::vector<decltype(make(*std::begin(items)))> made;
    std::vector<Diagnostic> diagnostics;
    for (const auto& item : items) {
        try {
            made.push_back(make(item));
        } catch (const SceneError& error) {
            diagnostics.insert(diagnostics.end(), error.diagnostics().begin(),
                               error.diagnostics().end());
        }
    }
    if (!diagnostics.empty()) throw SceneError(std::move(diagnostics));
    return made;
}

/// The command line is wrong (exit code 2).
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The work failed for a reason outside the input: disk, codec, memory (exit code 1). The message
/// names path and cause.
class SystemError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The work failed, but may succeed if it is tried again: a full disk, too many open files, a file
/// system that does not answer (exit code 75, EX_TEMPFAIL of sysexits.h).
class TemporaryError : public SystemError {
  public:
    using SystemError::SystemError;
};

/// Whether an errno value is that of a failure that may pass.
bool is_transient(int error);

/// Throws `message` as a TemporaryError if the failure with the errno value `error` may pass,
/// otherwise as a SystemError.
[[noreturn]] void throw_system_error(const std::string& message, int error);

/// Writes to standard error directly, without buffering, as far as possible. Does not allocate;
/// safe in a signal handler.
void write_to_standard_error(std::initializer_list<std::string_view> parts) noexcept;

}  // namespace carom
