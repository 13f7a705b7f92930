// Feeds a fuzz target with the files, and the files of the folders, that are given as arguments:
// what libFuzzer does with a corpus, but for any compiler.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "fuzz/fuzz.h"

namespace fs = std::filesystem;

int main(int argc, char** argv) {
    std::vector<fs::path> files;
    for (int i = 1; i < argc; ++i) {
        if (!fs::is_directory(argv[i])) {
            files.emplace_back(argv[i]);
            continue;
        }
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(argv[i]))
            if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) {
        if (!fs::is_regular_file(file)) {
            std::fprintf(stderr, "%s is no file\n", file.c_str());
            return 2;
        }
        std::fprintf(stderr, "%s\n", file.c_str());  // if the target crashes, this is its input
        const std::string bytes = carom::test::contents(file);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    std::printf("%zu inputs\n", files.size());
    return files.empty() ? 2 : 0;
}
