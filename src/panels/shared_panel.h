// A panel that can show several runs together: compared side by side, or as their mean.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

class SharedPanel : public Panel {
  public:
    /// Replaces fix_axes() if the panel shows several runs: its own and those that `others`, panels
    /// of the same kind, have seen. With the names of all runs these are compared; with empty
    /// `names` their mean is shown. Throws std::logic_error if the kind does not support this.
    virtual void fix_axes_of_runs(const std::vector<Panel*>& others,
                                  const std::vector<std::string>& names) {
        (void)others, (void)names;
        throw std::logic_error("a panel of a kind that does not show several runs so");
    }

    /// Combines the states of all runs, this panel's first, into what the panel shows.
    virtual std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const = 0;

    /// What a caption says of each compared run: "mean 1.25".
    virtual std::vector<std::string> accounts_of_runs(const PanelState& state) const = 0;
};

}  // namespace carom
