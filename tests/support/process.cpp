#include "support/process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace carom::test {

namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& word) {
    std::string text = "'";
    for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

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

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "carom-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() { fs::remove_all(path_); }

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_))
        names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

}  // namespace carom::test
