#include "app/figures/set_work.h"

#include <algorithm>

namespace carom {
namespace {

// The figures of a part that are asked for.
std::vector<std::string> chosen(const SetPart& part, const std::vector<std::string>& only) {
    std::vector<std::string> names;
    for (const std::string& name : part.figures)
        if (only.empty() || std::ranges::find(only, name) != only.end()) names.push_back(name);
    return names;
}

}  // namespace

Work work_of_set(const FigureSet& set, const std::vector<std::string>& only, bool films) {
    Work work;
    for (const SetPart& part : set.parts) {
        const SceneCounts counts = counts_of_film(part.scene);
        const std::vector<std::string> names = chosen(part, only);
        if (!names.empty())
            work = together(work, work_of_figures(part.scene, names, set.formats, counts.front()));
        if (films && !part.compares)
            work = together(work, work_of_film(part.scene, {}, output_format("mp4"), counts));
    }
    return work;
}

}  // namespace carom
