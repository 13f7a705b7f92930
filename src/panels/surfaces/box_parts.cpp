#include "panels/surfaces/box_parts.h"

#include <limits>

#include "panels/surfaces/surface_words.h"
#include "physics/membership.h"
#include "stats/paths/stays.h"

namespace carom {

plot::Role surface_role(std::size_t place, std::size_t count) {
    if (count == 1) return {.of = plot::Role::Of::bar};
    return {.of = plot::Role::Of::run, .index = place};
}

std::vector<std::string> BoxParts::names(Language language) const {
    std::vector<std::string> all;
    for (const NamedRegion& one : regions_) all.push_back(one.name);
    if (!all.empty()) return all;
    if (axis() == 0) return {say(language, "left"), say(language, "right")};
    if (axis() == 1) return {say(language, "below"), say(language, "above")};
    return {say(language, "back"), say(language, "front")};
}

std::vector<Region> BoxParts::regions(std::span<const SurfaceState> states) const {
    std::vector<Region> all;
    for (const NamedRegion& one : regions_) all.push_back(one.region);
    if (!all.empty()) return all;
    constexpr double far = std::numeric_limits<double>::infinity();
    Region whole{{-far, -far, -far}, {far, far, far}};
    if (box_.is_periodic(axis())) {
        whole.low[axis()] = 0.0;
        whole.high[axis()] = box_.length(axis());
    }
    all = {whole, whole};
    all[0].high[axis()] = all[1].low[axis()] =
        place_of_surface(box_, states, static_cast<std::size_t>(surfaces_.front()));
    return all;
}

std::vector<std::vector<Eigen::Index>> BoxParts::members(const FrameInput& input) const {
    const std::vector<Region> parts = regions(input.advanced.surfaces);
    std::vector<std::vector<Eigen::Index>> all(parts.size());
    const Eigen::ArrayXXd& position = input.sample.position;
    for (Eigen::Index i = 0; i < position.rows(); ++i) {
        if (!is_present(input.sample, i)) continue;
        const Vec place = vec_in(position, i);
        for (std::size_t k = 0; k < parts.size(); ++k)
            if (is_in(box_, parts[k], place)) all[k].push_back(i);
    }
    return all;
}

}  // namespace carom
