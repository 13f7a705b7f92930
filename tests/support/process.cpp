#include "support/process.h"

#include <sys/wait.h>

#include <cstdlib>

namespace carom::test {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace

Outcome shell(const std::string& script, const fs::path& folder) {
    const TemporaryFolder streams;
    const fs::path out = streams.path() / "out";
    const fs::path err = streams.path() / "err";
    const std::string line = "cd " + quoted(folder.string()) + " && { " + script + "\n} >" +
                             quoted(out.string()) + " 2>" + quoted(err.string());
    const int status = std::system(line.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, contents(out), contents(err)};
}

Outcome run(const std::vector<std::string>& command, const fs::path& folder) {
    std::string line;
    for (const std::string& word : command) line += quoted(word) + " ";
    return shell(line, folder);
}

bool is_installed(const std::string& program) {
    return shell("command -v " + quoted(program)).exit_code == 0;
}

}  // namespace carom::test
