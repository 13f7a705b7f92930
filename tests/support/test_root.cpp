#include "support/test_root.h"

namespace carom::test {

const std::filesystem::path& checkout() {
    static const std::filesystem::path root = CAROM_TEST_ROOT;
    return root;
}

}  // namespace carom::test
