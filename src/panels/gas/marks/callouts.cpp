#include "panels/gas/marks/callouts.h"

#include "panels/gas/marks/spotlights.h"
#include "scene/film.h"

namespace carom {

Callouts::Callouts(const PanelContext& context) : context_(context) {
    const Film& film = context.film();
    if (film.callouts.empty()) return;
    const std::vector<Tick> ticks = timeline(context.scene);
    for (const Callout& callout : film.callouts)
        if (const auto* particle = std::get_if<std::int64_t>(&callout.on)) {
            callouts_.push_back({static_cast<Eigen::Index>(*particle), &callout});
            times_.push_back(showing(ticks, film, {callout.at, {}}, callout.seconds));
        }
    ways_.resize(callouts_.size());
}

void Callouts::survey(const FrameInput& input, const Eigen::ArrayXXd& places) {
    for (std::size_t k = 0; k < callouts_.size(); ++k) {
        const Eigen::Index particle = callouts_[k].particle;
        if (share_of(context_, times_[k], input.tick, input.is_still) <= 0.0) continue;
        ways_[k].push_back({surveyed_, vec_in(places, particle)});
    }
    ++surveyed_;
}

std::vector<Callouts::Present> Callouts::at(const Tick& tick, bool is_still) const {
    std::vector<Present> present;
    for (std::size_t k = 0; k < callouts_.size(); ++k) {
        const double share = share_of(context_, times_[k], tick, is_still);
        if (share > 0.0 && !ways_[k].empty()) present.push_back({k, callouts_[k].particle, share});
    }
    return present;
}

std::vector<Callouts::Standing> Callouts::standing(const std::vector<Present>& present,
                                                   const DrawContext& dc, double most_width,
                                                   const PlaceOf& place_of) const {
    std::vector<std::size_t> seen;
    for (const Present& one : present) seen.push_back(one.index);
    const auto plate_of = [&](std::size_t k) {
        return callout_plate(dc, callouts_[k].callout->words, most_width);
    };
    const auto places = places_in_time(
        times_, seen, [&](std::size_t k, std::span<const Rect> others) -> std::optional<Rect> {
            if (ways_[k].empty()) return std::nullopt;
            return place_of(ways_[k], callouts_[k].particle, plate_of(k), others);
        });
    std::vector<Standing> all;
    for (const Present& one : present)
        all.push_back({one, plate_of(one.index), *places[one.index]});
    return all;
}

}  // namespace carom
