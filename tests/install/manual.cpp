// The installed manual: pages whose links and pictures lead to installed files.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "support/process.h"
#include "support/test_root.h"

using namespace carom::test;
namespace fs = std::filesystem;

namespace {

// The files to which a page refers, `](file#place)` and `src="file"`; not in code, which is
// indented or fenced.
std::vector<std::string> files_named_in(const std::string& with_code) {
    std::string page = std::regex_replace(with_code, std::regex("\n    [^\n]*"), "\n");
    for (std::size_t begin = 0; (begin = page.find("\n```")) != page.npos;)
        page.erase(begin, std::min(page.find("\n```", begin + 1), page.size() - 4) + 4 - begin);
    const std::regex link(R"(\]\(([^()# ]+)[^()]*\)|src="([^"]+)\")");
    std::vector<std::string> files;
    for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it) {
        const std::string file = (*it)[1].matched ? (*it)[1] : (*it)[2];
        if (!std::regex_search(file, std::regex("^[a-z]+:"))) files.push_back(file);
    }
    return files;
}

// How many of these there are in a page; all must exist.
std::size_t checked_links(const fs::path& page) {
    CAPTURE(page.string());
    const std::vector<std::string> files = files_named_in(contents(page));
    for (const std::string& file : files) {
        CAPTURE(file);
        CHECK(fs::exists(page.parent_path() / file));
    }
    return files.size();
}

}  // namespace

TEST_CASE("links in the installed manual lead to installed files") {
    const TemporaryFolder folder;
    const fs::path installed = folder.path() / "installed", manual = installed / "share/doc/carom";
    REQUIRE(
        run({"cmake", "--install", CAROM_BUILD_FOLDER, "--prefix", installed.string()}).exit_code ==
        0);
    CHECK(checked_links(manual / "README.md") > 20);
    CHECK(checked_links(manual / "docs/gallery.md") > 40);
    CHECK(checked_links(manual / "docs/scene-reference.md") > 30);
    for (const fs::path& pages : {manual, manual / "docs", installed / "share/carom/cluster",
                                  installed / "share/carom/integrations/pandoc"})
        for (const fs::directory_entry& entry : fs::directory_iterator(pages))
            if (entry.path().extension() == ".md") checked_links(entry.path());
    CHECK(checked_links(manual / "docs/tutorial.md") > 14);
    // The program finds it.
    const Outcome help =
        run({(installed / "bin/carom").string(), "help", "panel", "speed-histogram"});
    CHECK(help.out.find("\nExample:\n  title: Disks that began at one speed\n") !=
          std::string::npos);
    // Of what is not installed, the words are left.
    CHECK(contents(manual / "docs/limits.md").find("\nsrc/scene/limits.h, and") !=
          std::string::npos);
}
