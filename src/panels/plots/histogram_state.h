// What a histogram shows in one frame, and the words of its counts: shared by the files of
// HistogramPanel.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"
#include "panels/plots/histogram_record.h"

namespace carom {

struct HistogramState : PanelState {
    HistogramCounts counts;
    std::size_t bytes() const override {
        std::size_t sum = 0;
        for (const MeanHistogram& one : counts.series) sum += one.counts.size() * sizeof(double);
        return sum;
    }
};

/// Rows of words on fitted curves: more would leave no room for the bars.
inline constexpr int most_fit_rows = 3;

/// A count, or a mean of counts, which is no whole number.
std::string count_words(double count);

}  // namespace carom
