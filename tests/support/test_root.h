// Where the checkout is. Compiled once for each program, so that no other file of the tests depends
// on the folder it is built in, and a compiler cache serves several checkouts.
#pragma once

#include <filesystem>

namespace carom::test {

/// The root of the checkout.
const std::filesystem::path& checkout();

}  // namespace carom::test
