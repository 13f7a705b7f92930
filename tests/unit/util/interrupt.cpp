#include "util/interrupt.h"

#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "support/files.h"
#include "util/files/atomic_file.h"

using namespace carom;

namespace {

struct Ending {
    int exit_code;
    std::string said;
};

// Of another process, which has the handlers and does this.
template <class Work>
Ending ending(const Work& work) {
    const test::TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        if (std::freopen((folder.path() / "said").c_str(), "w", stderr) == nullptr) _exit(2);
        install_signal_handlers();
        try {
            work();
        } catch (const Interrupted&) {
            _exit(3);
        }
        _exit(0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    return {WEXITSTATUS(status), test::contents(folder.path() / "said")};
}

}  // namespace

TEST_CASE("a signal sets a flag, and ends a program at once where it may") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        CHECK(ending([&] { raise(signal); }).exit_code == 0);
        CHECK(ending([&] { raise(signal), throw_if_interrupted(); }).exit_code == 3);
        const Ending ended = ending([&] {
            const EndsAtOnce whole;
            raise(signal);
        });
        CHECK(ended.exit_code == 130);
        CHECK(ended.said == "carom: interrupted; nothing was written\n");
        const test::TemporaryFolder outputs;
        const Ending after_output = ending([&] {
            AtomicFile(outputs.path() / "output").commit();
            const EndsAtOnce whole;
            raise(signal);
        });
        CHECK(after_output.said == "carom: interrupted; nothing more was written\n");
    }
}

TEST_CASE("an interruption says whether anything was written before") {
    const test::TemporaryFolder outputs;
    CHECK(ending([&] {
              if (std::string(Interrupted().what()) != "interrupted; nothing was written")
                  throw Interrupted();
              AtomicFolder(outputs.path() / "output").commit();
              if (std::string(Interrupted().what()) != "interrupted; nothing more was written")
                  throw Interrupted();
          }).exit_code == 0);
}

TEST_CASE("a signal that came before is not forgotten, nor does one end what comes after") {
    CHECK(ending([] {
              raise(SIGTERM);
              const EndsAtOnce late;
          }).exit_code == 3);
    CHECK(ending([] {
              { const EndsAtOnce over; }
              raise(SIGTERM);
          }).exit_code == 0);
}

TEST_CASE("what must be cleaned up is not left behind by a signal") {
    CHECK(ending([] {
              const EndsAtOnce whole;
              const MustCleanUp something;
              raise(SIGTERM);
          }).exit_code == 0);
    const test::TemporaryFolder folder;
    CHECK(ending([&] {
              const EndsAtOnce whole;
              const AtomicFolder frames(folder.path() / "frames");
              raise(SIGTERM);
          }).exit_code == 0);
    CHECK(folder.names().empty());
}
