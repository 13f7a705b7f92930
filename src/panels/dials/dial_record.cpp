#include "panels/dials/dial_record.h"

namespace carom {

DialRecord mean_of(const std::vector<DialRecord>& records) {
    DialRecord mean = records.front();
    mean.runs_in_mean = static_cast<int>(records.size());
    std::vector<std::vector<double>>& lines = mean.runs.front().lines;
    for (std::size_t k = 0; k < lines.size(); ++k)
        for (std::size_t i = 0; i < lines[k].size(); ++i) {
            double sum = 0.0;
            for (const DialRecord& record : records) sum += record.runs.front().lines[k][i];
            lines[k][i] = sum / static_cast<double>(records.size());
        }
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
