#include "panels/dials/dial_record.h"

namespace carom {

DialRecord mean_of(const std::vector<DialRecord>& records) {
    DialRecord mean = begun_mean(records);
    DialRun& run = mean.runs.front();
    const auto average = [&](NumberRows DialRun::*lines, NumberRows DialRun::*errors) {
        take_means(
            records,
            [lines](const DialRecord& record) -> const NumberRows& {
                return record.runs.front().*lines;
            },
            run.*lines, run.*errors);
    };
    average(&DialRun::lines, &DialRun::errors);
    average(&DialRun::sampled, &DialRun::sampled_errors);
    return mean;
}

}  // namespace carom
