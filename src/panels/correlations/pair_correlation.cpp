// The pair correlation g(r) of particles, from the exact times spent at each distance, with
// the theoretical contact value for equal disks or spheres.
#include "stats/pairs/pair_correlation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/curve_panel.h"
#include "panels/plot/window.h"
#include "panels/registry.h"
#include "panels/surfaces/surface_words.h"
#include "physics/box.h"
#include "scene/panel_kind.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr double usual_diameters = 5.0;  // up to where g(r) is shown
constexpr double rings_along = 100.0;    // about

std::vector<Binding<PairCorrelationOptions>> pair_correlation_keys() {
    return {bind_key("to", &PairCorrelationOptions::to, number(positive, quantities::length),
                     "The largest distance.")
                .default_text("five diameters, or less in a smaller box; for points half of the "
                              "largest distance")};
}

// The largest distance at which g(r) is known: half of the shortest periodic side, or the longest
// side if that is less.
double most_distance(const Box& box) {
    double nearest = INFINITY, longest = 0.0;
    for (int axis = 0; axis < box.dimension; ++axis) {
        if (box.is_periodic(axis)) nearest = std::min(nearest, 0.5 * box.length(axis));
        longest = std::max(longest, box.length(axis));
    }
    return std::min(nearest, longest);
}

// Reports boxes with partitions or obstacles, in which the rings of g(r) have no simple area;
// distances beyond that of the nearest periodic images; and more than two choices of particles.
void check_pair_correlation(PanelSpec& panel, const Node& node, Reading& reading) {
    const Box& box = reading.box();
    const Node& place = node.is_mapping() ? *given(node, "kind") : node;
    if (!box.surfaces.partitions.empty() || !box.surfaces.obstacles.empty())
        reading.errors.add(
            place, "`pair-correlation` needs a box without partitions and obstacles",
            "leave it out, or remove these: with them its normalisation is not known exactly");
    if (panel.of.size() > 2)
        reading.errors.add(*given(node, "of"), "`of` takes at most two choices, for pairs",
                           "for more, add a panel for each pair");
    const Node* to = given(node, "to");
    if (to == nullptr || !(box.size[0] > 0.0) ||
        *panel.options.as<PairCorrelationOptions>().to <= most_distance(box))
        return;
    reading.errors.add(*to, "`to` is too large for this box",
                       fmt::format("give at most {}: half of a periodic side, or the longest side",
                                   most_distance(box)));
}

// What determines the rings for a scene.
struct Rings {
    double contact = 0.0;  // of the first disks of both choices
    double to = 1.0;
    int count = 1;
};

// If the disks have a contact distance, it is at the edge of a ring.
Rings rings_of(const PanelContext& context, const PanelSpec& spec,
               const std::vector<std::vector<Eigen::Index>>& lists) {
    const double most = most_distance(context.box());
    Rings rings;
    rings.contact = context.particles.radius[lists.front().front()] +
                    context.particles.radius[lists.back().front()];
    const double usual = rings.contact > 0.0 ? usual_diameters * rings.contact : 0.5 * most;
    const double to = spec.options.as<PairCorrelationOptions>().to.value_or(std::min(usual, most));
    double width = to / rings_along;
    if (rings.contact > width) width = rings.contact / std::round(rings.contact / width);
    rings.count = std::max(1, static_cast<int>(std::floor(to / width * (1.0 + 1e-12))));
    rings.to = rings.count * width;
    return rings;
}

class PairMeter : public CurveMeter {
  public:
    PairMeter(const PanelContext& context, const std::vector<Chosen>& chosen,
              PairCorrelation::Wanted wanted)
        : context_(context),
          box_(context.box()),
          members_(context, {chosen.front(), chosen.back()}),
          wanted_(std::move(wanted)) {
        wanted_.first = members_.flags(0);
        wanted_.second = members_.flags(1);
    }

    // Before anything is seen.
    void fix_axis(double, double reach, int points) override {
        wanted_.to = reach;
        wanted_.rings = points;
        pairs_.emplace(box_, context_.particles, wanted_, velocity_changes(context_.run()));
    }

    void see(const FrameInput& input) override {
        BoxSides sides = sides_of(box_);
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(box_.dimension); ++axis)
            sides[axis] = {place_of_surface(box_, input.advanced.surfaces, 2 * axis),
                           place_of_surface(box_, input.advanced.surfaces, 2 * axis + 1)};
        pairs_->see(input.sample, input.advanced.collisions, sides);
        if (!members_.see(input.sample)) return;
        pairs_->choose(members_.flags(0), members_.flags(1));
        pairs_->see(input.sample, {}, sides);  // the present moment
    }
    Measured measured() const override {
        const Eigen::ArrayXd g = pairs_->values();
        return {.y = {{g.begin(), g.end()}}};
    }
    void archive(Archive& archive) override {
        archive(members_);
        if (archive.is_reading()) pairs_->choose(members_.flags(0), members_.flags(1));
        archive(*pairs_);
    }

  private:
    PanelContext context_;
    Box box_;
    Members members_;
    PairCorrelation::Wanted wanted_;
    std::optional<PairCorrelation> pairs_;  ///< with the rings of the axis
};

// `name`: of the equation of state from which the value follows.
void add_contact(Language language, const std::string& name, double contact, double value,
                 plot::Plot& plot) {
    const plot::Dot dot{.role = {.of = plot::Role::Of::accent}, .radius = 0.35, .halo = 0.1};
    plot::Points points;
    points.part = "contact";
    points.still = true;
    points.x = plot::column(plot.columns[0], {contact});
    points.y = plot::column(plot.columns[2], {value});
    points.dot = dot;
    plot.layers.emplace_back(std::move(points));
    const std::string number = three_digits(language, value);
    plot.notes.push_back({.entries = {{.words = {say(language, "{}: {} at contact", number, name),
                                                 say(language, "{}: {}", number, name), number},
                                       .dot = dot}}});
}

std::unique_ptr<Panel> make_pair_correlation(const PanelContext& context, const PanelSpec& spec) {
    const Language language = context.language();
    const std::vector<Chosen> chosen = choices(spec);
    const std::vector<std::vector<Eigen::Index>> lists = members(context, chosen);
    const Rings rings = rings_of(context, spec, lists);
    PairCorrelation::Wanted wanted;
    PanelSpec timed = spec;
    if (!timed.over) timed.over = Over{Over::Since::start, 0.0};
    wanted.window = window_of(*timed.over);

    CurveSubject subject{.shape = CurveSubject::Shape::steps, .points = rings.count};
    subject.over = *timed.over;
    subject.meter = [context, chosen, wanted] {
        return std::make_unique<PairMeter>(context, chosen, wanted);
    };
    const std::string what = say(language, "Pair correlation") + " <i>g</i>(<i>r</i>)";
    name_curves(subject, context, spec, what, time_words(context.wording(), timed));
    if (chosen.size() > 1) {  // one curve, of pairs
        subject.lines = {{subject.lines[0].column + " and " + subject.lines[1].column,
                          "",
                          {.of = plot::Role::Of::bar}}};
        subject.names = {{.words = {names_of(context, chosen, plot::Swatch::none)}}};
    }
    subject.along = quantities::distance;
    subject.up = quantities::number.named(Phrase{"pair correlation"});
    subject.reach = rings.to;
    subject.level = 1.0;
    subject.account = [wording = context.wording()](const CurveValues& values,
                                                    std::size_t) -> std::string {
        const std::vector<double>& g = values.y.front();
        const auto highest = std::ranges::max_element(g);
        if (highest == g.end() || !(*highest > 0.0)) return "";
        const double ring = values.reach() / static_cast<double>(g.size()),
                     at = (static_cast<double>(highest - g.begin()) + 0.5) * ring;
        return say(wording, "the pair correlation is highest, {}, at a distance of {}",
                   three_digits(wording.language, *highest),
                   three_digits(wording, quantities::distance, at));
    };
    const Law contact = law(context.gas, LawOf::contact);
    if (spec.theory && contact) {
        subject.least_top = 1.1 * contact.value;
        const std::string name(name_of(EquationOfState::simple, context.box().dimension));
        subject.add = [language, name, rings, contact = contact.value](const CurveValues*,
                                                                       plot::Plot& plot) {
            add_contact(language, name, rings.contact, contact, plot);
        };
    }
    return std::make_unique<CurvePanel>(context, std::move(subject));
}

}  // namespace

PanelKind pair_correlation_kind() {
    using enum Ability;
    return {.name = "pair-correlation",
            .words = Phrase{"pair correlation"},
            .shows =
                "*g*(*r*): the number of pairs at each distance, relative to that of random "
                "points in the same box, with the value of Henderson for equal disks at contact, "
                "or that of Carnahan and Starling for equal spheres.",
            .make = make_pair_correlation,
            .abilities = {of, over, theory, means, comparison},
            .shows_units = true,
            .tried_as = {"rdf"},
            .keys = option_keys(pair_correlation_keys()),
            .rule = check_pair_correlation,
            .laws = always(std::vector{LawOf::contact}),
            .work = [](const PanelSpec& panel, const Run&) {
                return PanelWork{.flights = PanelWork::Flights::pairs,
                                 .reach = panel.options.as<PairCorrelationOptions>().to};
            }};
}

}  // namespace carom
