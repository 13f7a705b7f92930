#include "panels/gas/marks/seed_paths.h"

#include <algorithm>
#include <cmath>

#include "panels/archived.h"
#include "panels/precision.h"
#include "util/interrupt.h"

namespace carom {

std::vector<SeedPath> seed_paths(const PanelContext& context,
                                 const std::vector<Eigen::Index>& particles) {
    constexpr int points = 800;
    std::vector<SeedPath> all;
    if (particles.empty() || !context.in_film) return all;
    const Box& box = context.box();
    for (int later = 1; later <= context.film().trails.seeds; ++later) {
        Scene scene = context.scene;
        scene.gas.seed = scene.seed += static_cast<std::uint64_t>(later);
        Simulation run = start_scene(scene).simulation;
        const std::size_t first = all.size();
        all.resize(first + particles.size());
        for (int k = 0; k <= points; ++k) {
            throw_if_interrupted();
            const double time = scene.run.until * k / points;
            run.advance_to(time);
            const Sample& sample = run.sample();
            for (std::size_t i = 0; i < particles.size(); ++i) {
                SeedPath& path = all[first + i];
                const Point at{sample.position(particles[i], 0), sample.position(particles[i], 1)};
                bool breaks = false;
                if (k > 0)
                    breaks = box.turns(0, path.place.back().x - at.x) != 0.0 ||
                             box.turns(1, path.place.back().y - at.y) != 0.0;
                path.piece.push_back(k == 0 ? 0 : path.piece.back() + (breaks ? 1 : 0));
                path.time.push_back(time);
                path.place.push_back(at);
            }
        }
    }
    return all;
}

}  // namespace carom
