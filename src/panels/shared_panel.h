// A panel that can show several runs at once: side by side, or their mean.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace carom {

class SharedPanel : public Panel {
  public:
    /// fix_axes() for several runs that one panel shows: of this one and of others, panels of the
    /// same kind that saw them. With the names of all runs they are side by side, with none it is
    /// their mean. Throws std::logic_error where the kind shows no such thing.
    virtual void fix_axes_of_runs(const std::vector<Panel*>& others,
                                  const std::vector<std::string>& names) {
        (void)others, (void)names;
        throw std::logic_error("a panel of a kind that does not show several runs so");
    }

    /// What such a panel shows: the states of all its runs together, this panel's first.
    virtual std::shared_ptr<const PanelState> state_of_runs(
        const std::vector<std::shared_ptr<const PanelState>>& states) const = 0;

    /// Of each of the runs side by side what a caption says of it: "mean 1.25".
    virtual std::vector<std::string> accounts_of_runs(const PanelState& state) const = 0;
};

}  // namespace carom
