// Work that asks for no flag ends at once with a signal: loading, and drawing one large picture.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

using namespace carom::test;

TEST_CASE("the loading of a large file can be stopped") {
    const TemporaryFolder folder;
    std::string text =
        "title: Many disks\nbox: {size: [100000, 100]}\nrun: {until: 1}\n"
        "gas:\n  - radius: 0.2\n    speed: 1\n    position:\n";
    constexpr int disks = 60'000;  // takes more than a second
    for (int i = 1; i <= disks; ++i)
        text +=
            "      - [" + std::to_string(i) + ".12345678901234567890, 50.12345678901234567890]\n";
    folder.write("scene.yaml", text);
    const Outcome stopped =
        shell("'" + program +
                  "' check scene.yaml & p=$!; until grep -q \"^SigCgt:.*4...$\" "
                  "/proc/$p/status; do :; done; sleep 0.1; kill -TERM $p; wait $p",
              folder.path());
    CHECK(stopped.exit_code == 130);
    CHECK(stopped.out.empty());
    CHECK(stopped.err == "carom: interrupted; nothing was written\n");
}

TEST_CASE("a large still can be stopped while it is drawn") {
    const TemporaryFolder folder;
    folder.write("scene.yaml",
                 "title: A gas\nbox: {size: [100, 100]}\nrun: {until: 1}\n"
                 "gas: [{count: 1000, radius: 1, speed: 1}]\n");
    // Drawing takes several seconds.
    const Outcome stopped = shell(
        "'" + program +
            "' still scene.yaml --size 8192x8192 -o large.png & p=$!; sleep 1; kill -TERM $p; "
            "wait $p",
        folder.path());
    CHECK(stopped.exit_code == 130);
    CHECK(stopped.err == "carom: interrupted; nothing was written\n");
    CHECK(folder.names() == std::vector<std::string>{"scene.yaml"});
}
