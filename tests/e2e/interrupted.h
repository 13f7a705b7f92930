// Interrupts carom at work: once its bar is shown, not after a time that may be too short or too
// long.
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>

#include "e2e/program.h"
#include "support/process.h"

namespace carom::test {

struct Interruption : Outcome {  ///< `err` is what its terminal showed, without carriage returns
    double seconds = 0.0;        ///< from the signal to the end
};

/// Runs the program with these arguments at a terminal and sends it a signal once it shows these
/// words, or after `most` seconds, of which there are plenty. `by`: a program that starts it.
inline Interruption interrupted(const std::string& arguments, const std::filesystem::path& folder,
                                const std::string& signal = "INT",
                                const std::string& words = "left\r", const std::string& by = "",
                                int most = 60) {
    namespace fs = std::filesystem;
    const TemporaryFolder notes;
    const std::string at = notes.path().string() + "/";
    notes.write("run", "echo $$ >" + at + "pid\nexec " + by + " '" + program + "' " + arguments +
                           " >" + at + "out\n");
    Interruption found;
    static_cast<Outcome&>(found) =
        shell("script -qec 'sh " + at + "run' /dev/null >" + at + "shown & for i in $(seq " +
                  std::to_string(20 * most) + "); do grep -qF '" + words + "' " + at +
                  "shown && break; sleep 0.05; done; touch " + at + "sent; kill -" + signal +
                  " $(cat " + at + "pid); wait $!",
              folder);
    found.seconds = std::chrono::duration<double>(fs::file_time_type::clock::now() -
                                                  fs::last_write_time(at + "sent"))
                        .count();
    found.out = contents(at + "out");
    found.err = contents(at + "shown");
    std::erase(found.err, '\r');
    return found;
}

}  // namespace carom::test
