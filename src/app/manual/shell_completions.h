// Completions as scripts for bash, zsh and fish.
#pragma once

#include <string>

#include "app/manual/completion_table.h"

namespace carom {

/// For share/bash-completion/completions/carom.
std::string bash_completions(const CompletionTable& table);

/// For share/zsh/site-functions/_carom.
std::string zsh_completions(const CompletionTable& table);

/// For share/fish/vendor_completions.d/carom.fish.
std::string fish_completions(const CompletionTable& table);

}  // namespace carom
