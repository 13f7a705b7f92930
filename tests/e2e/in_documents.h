// The example of integrations/ in a folder of its own, and the tools that make documents of it.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

namespace carom::test {

class ExampleDocuments {
  public:
    ExampleDocuments() {
        std::filesystem::copy(root / "integrations", folder.path() / "integrations",
                              std::filesystem::copy_options::recursive);
    }

    std::filesystem::path path(const std::string& name) const { return place() / name; }

    std::filesystem::path place() const { return folder.path() / "integrations/example"; }

    std::string text(const std::string& name) const { return contents(path(name)); }

    void write(const std::string& name, const std::string& words) const {
        folder.write("integrations/example/" + name, words);
    }

    /// Calls a tool there, which finds the program that is tested.
    Outcome call(std::vector<std::string> command) const {
        command.insert(command.begin(), {"env", "CAROM=" + program});
        return run(command, place());
    }

    /// The names of the files in carom-media/, without those in its folders.
    std::vector<std::string> media(const std::string& ending) const {
        std::vector<std::string> names;
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(path("carom-media"), none))
            if (entry.path().string().ends_with(ending))
                names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }

    TemporaryFolder folder;
};

/// Names that are no scene's: they climb, are addresses, options, commands or markup.
inline const std::vector<std::string> hostile_names{"../gas.yaml",
                                                    "a/../../gas.yaml",
                                                    "/etc/passwd.yaml",
                                                    "-o.yaml",
                                                    "--help.yaml",
                                                    "$(touch pwned).yaml",
                                                    "`touch pwned`.yaml",
                                                    "'; touch pwned; '.yaml",
                                                    "a|touch pwned.yaml",
                                                    "\\input{canary}.yaml",
                                                    "http://localhost/a.yaml",
                                                    "a\"onerror=\"pwned().yaml"};

}  // namespace carom::test
