// The root folder of the checkout. It is compiled once for each program, so that no other test file
// depends on the folder in which it is built, and one compiler cache serves several checkouts.
#pragma once

#include <filesystem>

namespace carom::test {

/// The root of the checkout.
const std::filesystem::path& checkout();

}  // namespace carom::test
