#include "panels/gas/marks/callouts.h"

#include "panels/gas/marks/spotlights.h"

namespace carom {

Callouts::Callouts(const PanelContext& context) : context_(context) {
    const Film& film = context.scene.film;
    if (film.callouts.empty()) return;
    const std::vector<Tick> ticks = timeline(context.scene);
    for (const Callout& callout : film.callouts)
        if (const auto* particle = std::get_if<std::int64_t>(&callout.on))
            callouts_.push_back({static_cast<Eigen::Index>(*particle),
                                 showing(ticks, film, {callout.at, {}}, callout.seconds),
                                 &callout});
    ways_.resize(callouts_.size());
}

void Callouts::survey(const FrameInput& input, const Eigen::ArrayXXd& places) {
    for (std::size_t k = 0; k < callouts_.size(); ++k) {
        const Timed& one = callouts_[k];
        if (share_of(context_, one.time, input.tick, input.is_still) <= 0.0) continue;
        ways_[k].push_back({surveyed_, places(one.particle, 0),
                            places.cols() > 1 ? places(one.particle, 1) : 0.0});
    }
    ++surveyed_;
}

std::vector<Callouts::Present> Callouts::at(const Tick& tick, bool is_still) const {
    std::vector<Present> present;
    for (std::size_t k = 0; k < callouts_.size(); ++k) {
        const double share = share_of(context_, callouts_[k].time, tick, is_still);
        if (share > 0.0 && !ways_[k].empty()) present.push_back({k, callouts_[k].particle, share});
    }
    return present;
}

const std::string& Callouts::words(const Present& one) const {
    return callouts_[one.index].callout->words;
}

}  // namespace carom
