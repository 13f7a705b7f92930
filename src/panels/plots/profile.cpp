// Density, temperature, mean speed or flow along an axis of the box: means over slabs across it, by
// exact times of residence. Along y height is up, as in the box. Where an ideal gas would have a
// barometric law, that is drawn with the density.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "panels/chosen.h"
#include "panels/field/field_layer.h"
#include "panels/plot/plot_panel.h"
#include "panels/plots/window.h"
#include "panels/registry.h"
#include "physics/mechanics.h"
#include "stats/barometric_law.h"
#include "stats/histogram.h"
#include "stats/thinning.h"
#include "util/text.h"

namespace carom {
namespace {

using plot::Role;

constexpr int usual_slabs = 20;
constexpr double share_of_run = 0.1;  // that it is averaged over

struct ProfileState : PanelState {
    std::vector<Eigen::ArrayXd> values;  // of each choice, of each slab; NaN: too few particles
    std::size_t bytes() const override {
        return values.empty()
                   ? 0
                   : values.size() * static_cast<std::size_t>(values[0].size()) * sizeof(double);
    }
};

Over over_of(const PanelContext& context, const PanelSpec& spec) {
    return spec.over.value_or(Over{Over::Since::window, share_of_run * context.scene.run.until});
}

// Energy is kept, and nothing but gravity and walls acts.
bool has_law(const Scene& scene, FieldOf quantity, int axis) {
    const Surfaces& surfaces = scene.gas.box.surfaces;
    const bool changes = std::ranges::any_of(scene.run.events, [](const RunEvent& event) {
        return !std::holds_alternative<ReverseVelocities>(event.action) &&
               !std::holds_alternative<Perturbation>(event.action);
    });
    return quantity == FieldOf::density && !changes && surfaces.gravity[axis] != 0.0 &&
           (scene.gas.box.dimension == 1 || surfaces.gravity[1 - axis] == 0.0) &&
           !scene.gas.box.is_periodic(axis) && surfaces.partitions.empty() &&
           surfaces.obstacles.empty() &&
           std::ranges::all_of(surfaces.sides, [](const Behaviour& side) {
               return std::holds_alternative<Reflecting>(side);
           });
}

class ProfilePanel : public PlotPanel {
  public:
    ProfilePanel(const PanelContext& context, const PanelSpec& spec);

    void survey(const FrameInput& input) override;
    void fix_axes() override;
    void archive(Archive& archive) override;
    bool surveys_collisions() const override { return window_of(over_) != 0.0; }
    bool wants_collisions() const override { return surveys_collisions(); }
    std::shared_ptr<const PanelState> state(const FrameInput& input) override;
    plot::Plot plot(const PanelState* state) const override;

  private:
    struct Law {
        std::vector<double> densities;  // in each slab
        void archive(Archive& archive) { archive(densities); }
    };
    bool is_up() const { return axis_ == 1; }
    void find_laws(const Sample& start);
    std::vector<double> shares_of(const BarometricLaw& law, double radius) const;
    plot::Line line_of(std::size_t choice, const Eigen::ArrayXd& values, const char* part) const;
    std::vector<plot::Text> titles() const;
    void make_plot();

    PanelContext context_;
    PanelSpec spec_;
    int axis_;
    Cells cells_;
    Over over_;
    std::vector<Chosen> choices_;
    std::vector<CellQuantity> surveyed_, shown_;
    std::vector<double> pool_;
    int frames_seen_ = 0;
    double top_ = 1.0;
    std::vector<Law> laws_;  // of each choice; none where there is none
    plot::Plot whole_;
};

ProfilePanel::ProfilePanel(const PanelContext& context, const PanelSpec& spec)
    : context_(context),
      spec_(spec),
      axis_(spec.component == Component::y ? 1 : 0),
      cells_(slabs(context.scene.gas.box, axis_, spec.bins.value_or(usual_slabs))),
      over_(over_of(context, spec)),
      choices_(choices(spec)) {
    for (const std::vector<Eigen::Index>& list : carom::members(context, choices_)) {
        std::vector<bool> members(static_cast<std::size_t>(context.particles.count()));
        for (const Eigen::Index i : list) members[static_cast<std::size_t>(i)] = true;
        surveyed_.emplace_back(context, cells_, spec.quantity, std::nullopt, window_of(over_),
                               members);
    }
    shown_ = surveyed_;
}

void ProfilePanel::survey(const FrameInput& input) {
    if (frames_seen_ == 0 && spec_.theory && has_law(context_.scene, spec_.quantity, axis_))
        find_laws(input.sample);
    const auto slabs = static_cast<double>(cells_.all());
    for (CellQuantity& one : surveyed_) {
        one.see(input);
        const Eigen::ArrayXd values = one.values(axis_);
        for_each_kept(values.size(), slabs * static_cast<double>(surveyed_.size()), frames_seen_,
                      context_.frames, [&](Eigen::Index k) {
                          if (!std::isnan(values[k])) pool_.push_back(std::abs(values[k]));
                      });
    }
    ++frames_seen_;
}

// Of choices of equal particles only.
void ProfilePanel::find_laws(const Sample& start) {
    const Box& box = context_.scene.gas.box;
    const Particles& particles = context_.particles;
    const double gravity = box.surfaces.gravity[axis_], size = box.size[axis_];
    if ((particles.inverse_mass == 0.0).any()) return;
    const auto lowest = [&](Eigen::Index i) {
        return gravity < 0.0 ? particles.radius[i] : size - particles.radius[i];
    };
    double energy = 0.0;
    std::vector<FallingKind> kinds;
    std::vector<std::size_t> kind_of(static_cast<std::size_t>(particles.count()));
    for (Eigen::Index i = 0; i < particles.count(); ++i) {
        const double mass = 1.0 / particles.inverse_mass[i];
        const double height = size - 2.0 * particles.radius[i];
        energy += mass * (0.5 * start.velocity.row(i).square().sum() -
                          gravity * (start.position(i, axis_) - lowest(i)));
        auto kind = std::ranges::find_if(kinds, [&](const FallingKind& one) {
            return one.mass == mass && one.height == height;
        });
        if (kind == kinds.end()) kind = kinds.insert(kind, {mass, 0.0, height});
        kind->count += 1.0;
        kind_of[static_cast<std::size_t>(i)] = static_cast<std::size_t>(kind - kinds.begin());
    }
    const bool is_joined = box.dimension == 2 && box.is_periodic(1 - axis_);
    const double freedoms = double(box.dimension) * double(particles.count()) - (is_joined ? 1 : 0);
    if (!(energy > 0.0) || freedoms < 3.0 || kinds.size() > 20) return;
    for (std::size_t k = 0; k < choices_.size(); ++k) {
        Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(cells_.all());
        std::vector<double> counts(kinds.size());
        std::vector<double> radii(kinds.size());
        for (const Eigen::Index i : carom::members(context_, choices_[k])) {
            counts[kind_of[static_cast<std::size_t>(i)]] += 1.0;
            radii[kind_of[static_cast<std::size_t>(i)]] = particles.radius[i];
        }
        for (std::size_t its = 0; its < kinds.size(); ++its) {
            if (counts[its] == 0.0) continue;
            const BarometricLaw law(freedoms, energy, std::abs(gravity), kinds, its);
            const std::vector<double> shares = shares_of(law, radii[its]);
            for (Eigen::Index slab = 0; slab < sum.size(); ++slab)
                sum[slab] += counts[its] * shares[static_cast<std::size_t>(slab)];
        }
        laws_.push_back({{}});
        for (const double density : sum) laws_.back().densities.push_back(density / cells_.area());
    }
}

// The share of its particles in each slab.
std::vector<double> ProfilePanel::shares_of(const BarometricLaw& law, double radius) const {
    const bool is_down = context_.scene.gas.box.surfaces.gravity[axis_] < 0.0;
    const double size = context_.scene.gas.box.size[axis_], width = cells_.size[axis_];
    std::vector<double> shares;
    for (Eigen::Index slab = 0; slab < cells_.all(); ++slab) {
        const double low = static_cast<double>(slab) * width, high = low + width;
        shares.push_back(is_down ? law.share_below(high - radius) - law.share_below(low - radius)
                                 : law.share_below(size - low - radius) -
                                       law.share_below(size - high - radius));
    }
    return shares;
}

void ProfilePanel::fix_axes() {
    for (const Law& law : laws_)
        pool_.insert(pool_.end(), law.densities.begin(), law.densities.end());
    const double most = pool_.empty() ? 0.0 : quantile(pool_, 0.999);
    top_ = most > 0.0 ? round_up_for_axis(1.02 * most) : 1.0;
    pool_ = {};
    surveyed_ = {};
    make_plot();
}

void ProfilePanel::archive(Archive& archive) {
    archive(top_, laws_);
    if (archive.is_reading()) make_plot();
}

std::vector<plot::Text> ProfilePanel::titles() const {
    if (spec_.title) return {escape_markup(*spec_.title)};
    const Language language = context_.language();
    std::string name = name_of_quantity(language, context_.scene, spec_.quantity, {});
    if (context_.scene.gas.box.dimension == 2)
        name = is_up() ? say(language, "{} along y", name) : say(language, "{} along x", name);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    if (spec_.of.empty()) return {name};
    const plot::Text names = names_of(context_, choices_, plot::Sample::line);
    return {name + ": " + names, names};
}

// A level in each slab; broken where there is none.
plot::Line ProfilePanel::line_of(std::size_t choice, const Eigen::ArrayXd& values,
                                 const char* part) const {
    const double width = cells_.size[axis_];
    std::vector<double> along, up;
    std::vector<int> piece;
    int pieces = 0;
    for (Eigen::Index slab = 0; slab < values.size(); ++slab) {
        if (std::isnan(values[slab])) {
            ++pieces;
            continue;
        }
        for (const int end : {0, 1}) {
            along.push_back(static_cast<double>(slab + end) * width);
            up.push_back(values[slab]);
            piece.push_back(pieces);
        }
    }
    plot::Line line;
    line.part = part;
    line.of = column_name_of(context_.scene, choices_[choice]);
    line.x = plot::column(whole_.columns[1], is_up() ? up : along);
    line.y = plot::column(whole_.columns[2], is_up() ? along : up);
    line.piece = std::make_shared<const std::vector<int>>(std::move(piece));
    line.piece_column = whole_.columns[0];
    line.is_thinned = false;
    return line;
}

void ProfilePanel::make_plot() {
    const Scene& scene = context_.scene;
    const Language language = context_.language();
    const std::string quantity = name_of_quantity(Language::english, scene, spec_.quantity, {});
    const std::string place = scene.gas.box.dimension == 1 ? "position" : is_up() ? "y" : "x";
    const double low = spec_.quantity == FieldOf::flow ? -top_ : 0.0;
    plot::Axis places{.title = scene.gas.box.dimension == 1 ? say(language, "position") : place,
                      .low = 0.0,
                      .high = cells_.box[axis_]};
    plot::Axis values{
        .title = name_of_quantity(language, scene, spec_.quantity, {}), .low = low, .high = top_};
    const std::string of_place = column_name(place, reduced::length);
    const std::string of_value = column_name(quantity, unit_of_quantity(scene, spec_.quantity));
    whole_ = {.titles = titles(),
              .x = is_up() ? values : places,
              .y = is_up() ? places : values,
              .columns = {"piece (number)", is_up() ? of_value : of_place,
                          is_up() ? of_place : of_value}};
    whole_.language = language;
    const bool is_one = choices_.size() == 1;
    const plot::Stroke of_law{.role = {.of = is_one ? Role::Of::accent : Role::Of::muted},
                              .dashes = is_one ? std::vector<double>{} : std::vector{0.5}};
    plot::Note note{.wraps = true};
    note.entries.push_back(
        {.words = {plot::Text(words_of_window(language, over_, Phrase{"now"}))}});
    if (!laws_.empty())
        note.entries.push_back({.sample = of_law, .words = {say(language, "ideal gas")}});
    whole_.notes.push_back(std::move(note));
    for (std::size_t k = 0; k < laws_.size(); ++k) {
        plot::Line law = line_of(
            k, Eigen::Map<const Eigen::ArrayXd>(laws_[k].densities.data(), cells_.all()), "law");
        // Through the middles of the slabs.
        std::vector<double> along, up;
        for (Eigen::Index slab = 0; slab < cells_.all(); ++slab) {
            along.push_back((static_cast<double>(slab) + 0.5) * cells_.size[axis_]);
            up.push_back(laws_[k].densities[static_cast<std::size_t>(slab)]);
        }
        law.x = plot::column(whole_.columns[1], is_up() ? up : along);
        law.y = plot::column(whole_.columns[2], is_up() ? along : up);
        law.piece = nullptr;
        law.still = true;
        law.depth = 1;
        const Role own = role_among(context_, choices_, k);
        law.stroke = of_law;
        if (!is_one) law.stroke.role = own;
        whole_.layers.emplace_back(std::move(law));
    }
}

std::shared_ptr<const PanelState> ProfilePanel::state(const FrameInput& input) {
    auto state = std::make_shared<ProfileState>();
    for (CellQuantity& one : shown_) {
        one.see(input);
        state->values.push_back(one.values(axis_));
    }
    return state;
}

plot::Plot ProfilePanel::plot(const PanelState* state) const {
    plot::Plot now = whole_;
    if (state == nullptr) return now;
    const auto& shown = static_cast<const ProfileState&>(*state);
    for (std::size_t k = 0; k < shown.values.size(); ++k) {
        plot::Line line = line_of(k, shown.values[k], "profile");
        line.stroke = {.role = role_among(context_, choices_, k),
                       .width = 0.22,
                       .print_dashes = plot::dashes_in_print(k, choices_.size()),
                       .shade = plot::Shade::legible};
        now.layers.emplace_back(std::move(line));
        const auto known = !shown.values[k].isNaN();
        if (!known.any()) continue;
        constexpr double infinite = std::numeric_limits<double>::infinity();
        if (!now.account.empty()) now.account += " ";
        const Language language = context_.language();
        const std::string axis = is_up() ? "y" : "x";
        now.account +=
            say(language, "{} of {} along {}, {}: between {} and {}.",
                name_of_quantity(language, context_.scene, spec_.quantity, {}),
                name_of(context_.scene, choices_[k]), axis,
                words_of_window(language, over_, Phrase{"now"}),
                three_digits(language, known.select(shown.values[k], infinite).minCoeff()),
                three_digits(language, known.select(shown.values[k], -infinite).maxCoeff()));
    }
    return now;
}

}  // namespace

std::unique_ptr<Panel> make_profile(const PanelContext& context, const PanelSpec& spec) {
    return std::make_unique<ProfilePanel>(context, spec);
}

}  // namespace carom
