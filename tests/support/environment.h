// A variable of the environment as long as a test needs it.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace carom::test {

/// Sets the variable, and gives it back what it was. Not while other threads read it.
class EnvironmentVariable {
  public:
    EnvironmentVariable(const char* name, const std::string& value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        setenv(name, value.c_str(), 1);
    }
    ~EnvironmentVariable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_ = {};
};

}  // namespace carom::test
