#include "panels/dials/dial_record.h"

#include "stats/mean_error.h"

namespace carom {

DialRecord mean_of(const std::vector<DialRecord>& records) {
    DialRecord mean = records.front();
    mean.runs_in_mean = static_cast<int>(records.size());
    DialRun& run = mean.runs.front();
    using Lines = std::vector<std::vector<double>>;
    std::vector<double> of_each(records.size());
    const auto average = [&](Lines DialRun::*lines, Lines DialRun::*errors) {
        run.*errors = run.*lines;
        for (std::size_t k = 0; k < (run.*lines).size(); ++k)
            for (std::size_t i = 0; i < (run.*lines)[k].size(); ++i) {
                for (std::size_t r = 0; r < records.size(); ++r)
                    of_each[r] = (records[r].runs.front().*lines)[k][i];
                const MeanError all = mean_error(of_each);
                (run.*lines)[k][i] = all.mean;
                (run.*errors)[k][i] = all.error;
            }
    };
    average(&DialRun::lines, &DialRun::errors);
    average(&DialRun::sampled, &DialRun::sampled_errors);
    return mean;
}

DialRecord compare(std::vector<DialRecord> records, const std::vector<std::string>& names) {
    DialRecord all{.runs = {}};
    for (std::size_t k = 0; k < records.size(); ++k) {
        all.runs.push_back(std::move(records[k].runs.front()));
        all.runs.back().name = names[k];
    }
    return all;
}

}  // namespace carom
