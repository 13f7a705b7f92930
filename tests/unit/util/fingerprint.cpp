#include "util/fingerprint.h"

#include <doctest/doctest.h>

#include <string>

#include "support/files.h"
#include "util/diagnostics.h"
#include "util/files/input_file.h"

using namespace carom;

TEST_CASE("a file that cannot be read is not taken for one that is not there") {
    const test::TemporaryFolder folder;
    folder.write("words", "abc");
    CHECK(fingerprint_of_file(folder.path() / "words") == fingerprint("abc"));
    CHECK_FALSE(fingerprint_of_file(folder.path() / "none"));
    CHECK_FALSE(fingerprint_of_file(folder.path()));
#ifdef __linux__
    // An ordinary file by its kind, of which nothing can be read where no memory is mapped.
    CHECK_THROWS_WITH_AS(fingerprint_of_file("/proc/self/mem"),
                         "cannot read /proc/self/mem: Input/output error", SystemError);
#endif
}
