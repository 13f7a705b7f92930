// The distribution of free flights from one collision to the next, as lengths or as times: the
// share of flights in each bin, with the exponential law of memoryless flights. The particles are
// those chosen at the start.
#include "stats/paths/free_flights.h"

#include <algorithm>
#include <cmath>

#include "panels/chosen.h"
#include "panels/correlations/correlation_keys.h"
#include "panels/correlations/curve_panel.h"
#include "panels/means/thinning.h"
#include "panels/plot/window.h"
#include "panels/registry.h"
#include "scene/panel_kind.h"
#include "stats/histogram.h"
#include "stats/means/mean_error.h"
#include "stats/paths/sliding_sum.h"
#include "util/bin_number.h"
#include "util/text.h"

namespace carom {
namespace {

constexpr int flight_bins = 40;
constexpr double shown_share = 0.985;  // of all flights, within the axis
constexpr double percent = 100.0;
constexpr Eigen::Index pieces = 40, fewest_pieces = 20;  // of the run, for errors

enum class Flown { path, time };

const FreeFlightOptions& options_of_flights(const PanelSpec& panel) {
    return panel.options.as<FreeFlightOptions>();
}

std::vector<Binding<FreeFlightOptions>> free_flight_keys() {
    return {
        bind_key("log", &FreeFlightOptions::logarithmic, flag(),
                 "Whether the vertical axis is logarithmic: an exponential law is then straight."),
        bind_key("walls", &FreeFlightOptions::ends_at_walls, flag(),
                 "Whether walls and partitions end a free flight too; otherwise only other "
                 "particles and obstacles do.")};
}

// Reports free flights of a single moment, in which none ends.
void check_free_flights(PanelSpec& panel, const Node& node, Reading& reading) {
    const Node* over = given(node, "over");
    if (over == nullptr || !panel.over || panel.over->since != Over::Since::now) return;
    reading.errors.add(*over, "no free flight ends at a single moment",
                       "give `start`, or a time: {window: 5}");
}

// The `numbers` of each line: the mean from the total path or time, the number of ended flights,
// and the mean speed.
class FlightMeter : public CurveMeter {
  public:
    FlightMeter(const PanelContext& context, const PanelSpec& spec, Flown flown,
                std::optional<double> window)
        : flown_(flown),
          window_(window),
          flights_(context.box(), options_of_flights(spec).ends_at_walls,
                   velocity_changes(context.run())),
          lists_(members_that_collide(context, choices(spec))),
          lists_of_(static_cast<std::size_t>(context.particles.count())),
          kept_(lists_.size()),
          sums_(lists_.size(), SlidingSum(flight_bins + 4, window)),
          piece_(context.run().until / pieces),
          of_pieces_(lists_.size(),
                     {Eigen::ArrayXXd::Zero(pieces, 1), Eigen::ArrayXXd::Zero(pieces, 1)}) {
        for (std::size_t k = 0; k < lists_.size(); ++k)
            for (const Eigen::Index i : lists_[k])
                lists_of_[static_cast<std::size_t>(i)].push_back(k);
    }

    void see(const FrameInput& input) override {
        const auto take = [this](const PathPiece& piece, bool ends_flight) {
            for (const std::size_t k : lists_of_[static_cast<std::size_t>(piece.particle)])
                add_piece(k, piece, ends_flight);
            now_ = std::max(now_, piece.to);
        };
        for (const FreeFlight& flight :
             flights_.see(input.sample, input.advanced.collisions, take)) {
            const double value = flown_ == Flown::path ? flight.length : flight.duration;
            for (const std::size_t k : lists_of_[static_cast<std::size_t>(flight.particle)]) {
                if (!reach_)
                    keep(k, value);
                else
                    add(k, value, flight.ended);
            }
        }
        for (SlidingSum& one : sums_) one.at(input.sample.time);  // forgets what is too old
    }

    double reach() const override {
        std::vector<double> all;
        for (const std::vector<double>& values : kept_)
            all.insert(all.end(), values.begin(), values.end());
        return round_up_for_axis(all.empty() ? 0.0 : quantile(all, shown_share));
    }

    void fix_axis(double, double reach, int) override {
        reach_ = reach;
        for (std::size_t k = 0; k < kept_.size(); ++k) {
            for (const double value : kept_[k]) add(k, value, 0.0);
            kept_[k] = {};
        }
    }

    Measured measured() const override {
        Measured now;
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            const Eigen::ArrayXd sums = sums_[k].sum();
            const double ended = sums.head(flight_bins + 1).sum();
            const Eigen::ArrayXd shares = percent * sums.head(flight_bins) / ended;
            now.y.emplace_back(shares.begin(), shares.end());
            const double hits = sums[flight_bins + 1], way = sums[flight_bins + 2],
                         time = sums[flight_bins + 3];
            const double mean = (flown_ == Flown::path ? way : time) / hits;
            now.numbers.push_back({{mean, error_of_mean(k)}, {ended, NAN}, {way / time, NAN}});
        }
        return now;
    }

    // kept_ is not archived: fix_axis() has added its values to the sums.
    void archive(Archive& archive) override {
        archive(flights_, now_);
        for (SlidingSum& one : sums_) archive(one);
        for (PieceSums& one : of_pieces_) archive(one.sum, one.weight);
    }

  private:
    // Keeps thinned values for the choice of the axis; the stride doubles when there are too many.
    void keep(std::size_t k, double value) {
        if (seen_++ % stride_ != 0) return;
        kept_[k].push_back(value);
        if (static_cast<double>(kept_[k].size()) < most_kept_of_film) return;
        stride_ *= 2;
        for (std::vector<double>& values : kept_) {
            for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
            values.resize((values.size() + 1) / 2);
        }
    }

    // Each part of the window has the way and the time that belong to it.
    void add_piece(std::size_t k, const PathPiece& piece, bool ends_flight) {
        SlidingSum& to = sums_[k];
        for (double from = piece.from; from < piece.to;) {
            const double until = std::min(piece.to, to.end_of_slice(from));
            const double middle = 0.5 * (from + until), span = until - from;
            Eigen::ArrayXd& sums = to.at(middle);
            const double way =
                length_of_way(piece.velocity_after(middle - piece.from), piece.acceleration, span);
            sums[flight_bins + 2] += way;
            sums[flight_bins + 3] += span;
            of_pieces_[k].sum(piece_at(middle), 0) += flown_ == Flown::path ? way : span;
            from = until;
        }
        if (!ends_flight) return;
        to.at(piece.to)[flight_bins + 1] += 1.0;
        of_pieces_[k].weight(piece_at(piece.to), 0) += 1.0;
    }

    // Of the equal pieces of the run.
    Eigen::Index piece_at(double time) const {
        return std::clamp<Eigen::Index>(static_cast<Eigen::Index>(time / piece_), 0, pieces - 1);
    }

    // From the scatter of pieces of the run that have ended, if these are independent. A mean over
    // a window has too few of them.
    double error_of_mean(std::size_t k) const {
        constexpr double rounding = 1e-9;
        const auto ended = static_cast<Eigen::Index>(now_ / piece_ + rounding) / 2 * 2;
        if (window_ || ended < fewest_pieces) return NAN;
        const auto errors = standard_errors(
            {of_pieces_[k].sum.topRows(ended), of_pieces_[k].weight.topRows(ended)});
        return errors ? (*errors)[0] : NAN;
    }

    // Flights beyond the reach are counted in bin number flight_bins.
    void add(std::size_t k, double value, double now) {
        const double bin = bin_number(value / *reach_ * flight_bins);
        sums_[k].at(now)[static_cast<Eigen::Index>(std::min(bin, double(flight_bins)))] += 1.0;
    }

    Flown flown_;
    std::optional<double> window_, reach_;
    FreeFlights flights_;
    std::vector<std::vector<Eigen::Index>> lists_;
    std::vector<std::vector<std::size_t>> lists_of_;  // of each particle
    std::vector<std::vector<double>> kept_;           // of each list, before the reach is known
    std::size_t seen_ = 0, stride_ = 1;
    std::vector<SlidingSum> sums_;  // bins, beyond, collisions, way, time
    double piece_, now_ = 0.0;
    std::vector<PieceSums> of_pieces_;  // way or time, and collisions
};

plot::Stroke stroke_of_law(const PanelContext& context, const std::vector<Chosen>& chosen,
                           std::size_t k) {
    plot::Stroke stroke{.role = {.of = plot::Role::Of::accent},
                        .width = 0.12,
                        .dashes = {0.5, 0.35},
                        .shade = plot::Shade::legible};
    if (chosen.size() > 1) stroke.role = choice_role(context, chosen[k], k);
    return stroke;
}

// The share of flights in each bin if flights were memoryless: an exponential law with the measured
// mean.
plot::Polyline law_of(const plot::Plot& plot, double mean) {
    const double reach = plot.x.high, width = reach / flight_bins;
    const double share_at_0 = percent * (1.0 - std::exp(-width / mean));
    std::vector<double> along, up;
    constexpr int points = 100;
    for (int i = 0; i <= points; ++i) {
        along.push_back(reach * i / points);
        up.push_back(share_at_0 * std::exp(-(along.back() - 0.5 * width) / mean));
    }
    plot::Polyline line;
    line.part = "memoryless";
    line.x = plot::column(plot.columns[0], std::move(along));
    line.y = plot::column(plot.columns[2], std::move(up));
    line.is_thinned = false;
    line.depth = 1;
    return line;
}

struct FlightNotes {
    PanelContext context;
    std::vector<Chosen> chosen;
    Flown flown;
    bool has_law = false;  // that of memoryless flights
    std::optional<double> exact_path = {};

    FlightNotes(const PanelContext& of, const PanelSpec& spec, Flown what)
        : context(of), chosen(choices(spec)), flown(what) {
        if (!spec.theory) return;
        has_law = bool(law(of.gas, LawOf::memoryless));
        const Law path = law(of.gas, LawOf::free_flight,
                             {.ends_at_walls = options_of_flights(spec).ends_at_walls});
        if (path) exact_path = path.value;
    }

    void operator()(const CurveValues* values, plot::Plot& plot) const {
        const Language language = context.language();
        plot::Note note{.wraps = true, .changes = true};
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            const plot::Stroke stroke = stroke_of_law(context, chosen, k);
            static const std::vector<MeanError> unknown{{NAN, NAN}, {NAN, NAN}, {1.0, NAN}};
            const std::vector<MeanError>& numbers =
                values != nullptr ? values->numbers[k] : unknown;
            add_mean(k, numbers, note, plot);
            if (!has_law || !std::isfinite(numbers.front().mean)) continue;
            plot::Polyline line = law_of(plot, numbers.front().mean);
            line.of = column_name_of(context.scene, chosen[k]);
            line.stroke = stroke;
            plot.layers.emplace_back(std::move(line));
        }
        if (has_law)
            note.entries.push_back({.swatch = stroke_of_law(context, chosen, 0),
                                    .words = {say(language, "exponential law (Boltzmann)"),
                                              say(language, "exponential law")}});
        plot.notes.push_back(std::move(note));
    }

    void add_mean(std::size_t k, const std::vector<MeanError>& numbers, plot::Note& note,
                  plot::Plot& plot) const {
        const Language language = context.language();
        const bool is_one = chosen.size() == 1;
        const double mean = numbers.front().mean;
        plot::Marker marker;
        marker.part = "mean";
        marker.of = column_name_of(context.scene, chosen[k]);
        marker.column = plot.columns[0];
        marker.value = mean;
        marker.stroke.width = 0.12;
        marker.stroke.role =
            is_one ? plot::Role{plot::Role::Of::ink} : choice_role(context, chosen[k], k);
        std::optional<double> exact = exact_path;
        if (exact && flown == Flown::time) *exact /= numbers.back().mean;
        const auto words = [&](const std::string& number) {
            std::string all = say(language, "mean {}", number);
            if (exact) all = say(language, "{} (exact: {})", all, three_digits(language, *exact));
            if (!is_one) all = say(language, "{}: {}", name_of(context.scene, chosen[k]), all);
            return plot::Text(all);
        };
        const bool is_known = std::isfinite(mean);
        note.entries.push_back({.swatch = marker.stroke,
                                .words = {words(is_known ? three_digits(language, mean) : "")},
                                .reserved = {{words(longest_number)}}});
        if (is_known) plot.layers.emplace_back(std::move(marker));
    }
};

CurveSubject free_flights(const PanelContext& context, const PanelSpec& spec, Flown flown) {
    const Language language = context.language();
    const std::vector<Chosen> chosen = choices(spec);
    const bool is_path = flown == Flown::path;
    PanelSpec timed = spec;
    if (!timed.over) timed.over = Over{Over::Since::start, 0.0};
    CurveSubject subject{.shape = CurveSubject::Shape::steps, .points = flight_bins};
    subject.over = *timed.over;
    subject.meter = [context, spec, flown, window = window_of(*timed.over)] {
        return std::make_unique<FlightMeter>(context, spec, flown, window);
    };
    name_curves(subject, context, spec,
                is_path ? say(language, "Free paths") : say(language, "Free-flight times"),
                time_words(context.wording(), timed));
    subject.along = is_path ? quantities::length.named(Phrase{"free path"})
                            : quantities::time.named(Phrase{"free time"});
    subject.up = quantities::per_cent;
    subject.height = [language](double width) { return percent_per(language, width); };
    subject.logarithmic = options_of_flights(spec).logarithmic;
    subject.account = [language, context, chosen, is_path](const CurveValues& values,
                                                           std::size_t line) -> std::string {
        const auto [mean, error] = values.numbers[line].front();
        if (!std::isfinite(mean)) return "";
        const std::string number = with_error(language, mean, error);
        const std::string words = is_path ? say(language, "mean free path {}", number)
                                          : say(language, "mean free time {}", number);
        return chosen.size() > 1
                   ? say(language, "{}: {}", name_of(context.scene, chosen[line]), words)
                   : words;
    };
    subject.add = FlightNotes(context, spec, flown);
    subject.results = {{is_path ? quantities::length.named(Phrase{"mean length of free flights"})
                                : quantities::time.named(Phrase{"mean time of free flights"})},
                       [](const CurveValues& values, std::size_t line) {
                           return std::vector{values.numbers[line].front()};
                       }};
    return subject;
}

CurveSubject free_paths(const PanelContext& context, const PanelSpec& spec) {
    return free_flights(context, spec, Flown::path);
}

CurveSubject free_times(const PanelContext& context, const PanelSpec& spec) {
    return free_flights(context, spec, Flown::time);
}

}  // namespace

PanelKind free_path_kind() {
    using enum Ability;
    return curve_kind<free_paths>(
        {.name = "free-path",
         .words = Phrase{"free path"},
         .shows = "The distribution of the distances that particles fly between collisions, with "
                  "the exponential law of memoryless flight.",
         .abilities = {of, over, theory, means, comparison},
         .keys = option_keys(free_flight_keys()),
         .rule = check_free_flights,
         .laws = always(std::vector{LawOf::memoryless}),
         .work = always(PanelWork{.flights = PanelWork::Flights::followed})});
}

PanelKind free_time_kind() {
    using enum Ability;
    return curve_kind<free_times>(
        {.name = "free-time",
         .words = Phrase{"free time"},
         .shows = "The distribution of the times that particles fly between collisions, with the "
                  "exponential law of memoryless flight.",
         .abilities = {of, over, theory, means, comparison},
         .asked = {{.name = "mean_free_time",
                    .meaning = "the mean time between collisions since the start",
                    .is_result = true}},
         .keys = option_keys(free_flight_keys()),
         .rule = check_free_flights,
         .laws = always(std::vector{LawOf::memoryless}),
         .work = always(PanelWork{.flights = PanelWork::Flights::followed})});
}

}  // namespace carom
