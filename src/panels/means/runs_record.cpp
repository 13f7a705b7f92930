#include "panels/means/runs_record.h"

namespace carom {

std::string words_of_mean(Language language, int runs) {
    if (runs == 1) return "";
    return counted(language, runs, Phrase{"mean of {} run"}, Phrase{"mean of {} runs"});
}

}  // namespace carom
