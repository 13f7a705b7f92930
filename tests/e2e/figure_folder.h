// carom figures, by the program itself: a scene to make figures of, and what is in their folder.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

namespace carom::test {

inline const std::string ten_disks =
    "title: Ten disks\nbox: {size: [40, 30]}\ngas: [{count: 10, radius: 1, speed: 2}]\n"
    "run: {until: 10}\nfilm: {seconds: 2}\nfigures:\n"
    "  - {name: start, kind: gas, at: 0, caption: \"Ten & more\", alt: Ten disks in a box}\n"
    "  - {name: speeds, kind: speed-histogram, over: [2, 8], size: [10, 6]}\n";

/// Of `carom figures` in a folder.
inline Outcome figures(const TemporaryFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {program, "figures"});
    return run(arguments, folder.path());
}

/// The files of a folder, by their names.
inline std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = contents(entry.path());
    return files;
}

/// What out/scene/captions.json says.
inline nlohmann::json captions(const TemporaryFolder& folder) {
    return nlohmann::json::parse(contents(folder.path() / "out/scene/captions.json"));
}

/// What headless Chromium says on its console, and of the pictures and films in a page.
inline std::string seen_in_browser(const std::filesystem::path& page,
                                   const std::filesystem::path& profile) {
    std::string text = contents(page);
    text.replace(text.find("</body>"), 0,
                 "<script>addEventListener('load', () => { document.title = [...document.images]"
                 ".map(p => p.alt + ':' + (p.complete && p.naturalWidth > 0)).join(';') + '|' + "
                 "[...document.querySelectorAll('video')].map(v => v.textTracks.length).join(); "
                 "});</script>");
    const std::filesystem::path copy = page.parent_path() / "copy.html";
    std::ofstream(copy) << text;
    const Outcome outcome =
        run({"timeout", "90", "chromium", "--headless", "--no-sandbox", "--disable-gpu",
             "--no-first-run", "--disable-background-networking", "--disable-component-update",
             "--disable-sync", "--enable-logging=stderr", "--user-data-dir=" + profile.string(),
             "--dump-dom", "file://" + copy.string()});
    std::filesystem::remove(copy);
    CHECK_FALSE(has(outcome.err, "CONSOLE"));
    const std::size_t begin = outcome.out.find("<title>") + 7;
    return outcome.out.substr(begin, outcome.out.find("</title>") - begin);
}

}  // namespace carom::test
