// Pages in headless Chromium, by tests/browser/pages.cjs.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "e2e/program.h"
#include "support/process.h"

namespace carom::test {

/// Whether there are a browser and what drives it (./dev setup full installs both).
inline bool can_browse() {
    if (is_installed("chromium") && is_installed("node") &&
        std::filesystem::exists(root / "build/npm/node_modules/playwright-core"))
        return true;
    MESSAGE("chromium or build/npm is not there: pages are not tried in a browser");
    return false;
}

/// What pages.cjs says of a page; `mode` is film or gallery.
inline nlohmann::json browsed(const std::string& mode, const std::filesystem::path& page) {
    const Outcome outcome =
        run({"env", "NODE_PATH=" + (root / "build/npm/node_modules").string(), "timeout", "240",
             "node", (root / "tests/browser/pages.cjs").string(), mode, page.string()});
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return nlohmann::json::parse(outcome.out);
}

/// A page that is as it should be: nothing failed in it, no script but its own ran, and axe-core
/// finds no violation of WCAG 2.1 AA in light and dark.
inline void check_sound(const nlohmann::json& answer) {
    CHECK(answer["bad"] == nlohmann::json::array());
    CHECK(answer["changed"] == "undefined");
    CHECK(answer["violations"] == nlohmann::json::array());
}

/// A page of a film whose film plays and whose chapters jump.
inline void check_film(const nlohmann::json& answer) {
    check_sound(answer);
    CHECK(answer["paused"] == true);
    CHECK(answer["played"].get<double>() > 0.2);
    CHECK(answer["chapters"].size() > 1);
    for (const nlohmann::json& chapter : answer["chapters"]) {
        CAPTURE(chapter.dump());
        CHECK(chapter["reached"].get<double>() ==
              doctest::Approx(chapter["at"].get<double>()).epsilon(0.05));
        CHECK(chapter["current"] == "true");
    }
}

}  // namespace carom::test
