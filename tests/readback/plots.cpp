// Reads plots: one check for all of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "readback/checks.h"

namespace carom::test {
namespace {

constexpr double on_whole_pixels = 0.5;  // how far rounding moves ticks and the sides of bars
constexpr double precision = 0.15;       // of a map fitted to places so rounded
constexpr double thinning = 0.75;        // pixels: of nearer points of a curve only one is drawn

struct Datum {
    double x = 0, y = 0, to = 0;
    bool has_y = false;
};

struct Group {
    std::string part, of;
    std::vector<Datum> data = {};
    std::string name() const { return part + " of " + of; }
};

bool is_filled(const Row& row, const std::string& column) {
    const auto found = row.find(column);
    return found != row.end() && !found->second.empty();
}

// The distance of a point from the straight segment between two others.
double distance(Spot p, Spot a, Spot b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double along = square > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0.0;
    const double share = std::clamp(along, 0.0, 1.0);
    return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

bool is_near(Spot a, Spot b, double most) {
    return std::abs(a.x - b.x) <= most && std::abs(a.y - b.y) <= most;
}

class PlotReading {
  public:
    PlotReading(const DrawnFigure& figure, const PlotColumns& columns)
        : figure_(figure), columns_(columns), axes_(axes_of(figure.picture)) {
        for (Tick& tick : axes_.up)
            if (columns.is_logarithmic || columns.has_exponents)
                tick.value = std::log10(tick.value);
        across_ = fitted(axes_.across);
        up_ = fitted(axes_.up);
        find_tips();
        group_rows();
    }

    Problems problems() {
        // The axes are fitted in three steps: roughly with ticks, which lie on whole pixels; better
        // with the ends of lines; and with all of their corners as exactly as the picture shows
        // them.
        for (const double tolerance : {3.0 * half_a_pixel, 2.0 * half_a_pixel, half_a_pixel}) {
            read_all(tolerance);
            is_rough_ = false;
            if (tolerance == half_a_pixel) break;
            across_ = fitted(axes_.across, x_pairs_);
            up_ = fitted(axes_.up, y_pairs_);
        }
        check_ticks("across", axes_.across, across_);
        check_ticks("up", axes_.up, up_);
        return problems_;
    }

    // Checks the areas of a stack: the corners of each run to the right along its upper line and
    // back along the lower one.
    Problems stack() {
        if (!problems().empty()) return problems_;
        std::vector<const Group*> lines;
        for (const Group& group : groups_)
            if (group.part == "line") lines.push_back(&group);
        std::size_t areas = 0;
        for (const Shape& shape : figure_.picture.shapes) {
            const std::vector<Spot> corners = shape.corners();
            if (shape.is_stroke || shape.paint[3] > 0.8 || corners.size() < 2 * 20) continue;
            if (areas == lines.size()) return {"more areas than lines"};
            const auto turn = std::ranges::max_element(corners, {}, &Spot::x);
            const Group* below = areas == 0 ? nullptr : lines[areas - 1];
            for (auto corner = corners.begin(); corner != corners.end(); ++corner)
                if (!lies_on(corner <= turn ? lines[areas] : below, *corner) &&
                    !(corner->x == turn->x && lies_on(below, *corner)))
                    complain("a corner of area " + std::to_string(areas) + " is on no line");
            ++areas;
        }
        if (areas != lines.size()) complain("fewer areas than lines");
        return problems_;
    }

  private:
    // Whether a corner lies on a line; without a line, on the axis.
    bool lies_on(const Group* line, Spot corner) const {
        if (line == nullptr) return std::abs(corner.y - within(up_(0.0))) <= tolerance_;
        return std::ranges::any_of(line->data,
                                   [&](const Datum& datum) { return is_at(corner, datum); });
    }

    void group_rows() {
        std::map<std::string, std::size_t> known;
        for (const Row& row : figure_.table) {
            const std::string& part = row.at("part");
            if (!is_drawn(row)) continue;
            const auto piece = row.find("piece (number)");
            const std::string key =
                part + "/" + row.at("of") + "/" + (piece == row.end() ? "" : piece->second);
            if (known.try_emplace(key, groups_.size()).second)
                groups_.push_back({part, row.at("of")});
            Datum datum{.has_y = is_filled(row, columns_.y)};
            if (!is_filled(row, columns_.x)) continue;
            datum.x = number(row, columns_.x);
            if (datum.has_y) datum.y = number(row, columns_.y);
            if (columns_.is_logarithmic) datum.y = std::log10(std::max(datum.y, 1e-300));
            if (part == "bar") datum.to = number(row, columns_.to);
            groups_[known[key]].data.push_back(datum);
        }
    }

    void read_all(double tolerance) {
        tolerance_ = tolerance;
        x_pairs_.clear(), y_pairs_.clear(), problems_.clear(), used_.clear();
        for (const Group& group : groups_) {
            if (group.data.empty())
                complain("no numbers of the " + group.name());
            else if (group.part == "bar")
                read_bars(group);
            else if (group.part == "deviation")
                read_band(group);
            else if (!group.data.front().has_y && group.data.size() == 1)
                read_marker(group);
            else if (group.part == "point" || group.part == "mean" || group.data.size() == 1)
                read_points(group);
            else
                read_curve(group);
        }
        if (columns_.y.starts_with("virial")) read_errors();
        read_error_band(columns_.x, {1.0, 0.0});
        read_error_band(columns_.y, {0.0, 1.0});
    }

    void check_ticks(const std::string& axis, const std::vector<Tick>& ticks,
                     const LinearMap& map) {
        for (const Tick& tick : ticks)
            if (std::abs(map(tick.value) - tick.at) > on_whole_pixels + precision)
                complain(axis + ": the tick at " + std::to_string(tick.value) + " is " +
                         std::to_string(map(tick.value) - tick.at) + " pixels off");
    }

    void complain(const std::string& words) { problems_.push_back(figure_.name + ": " + words); }

    double within(double y) const { return std::clamp(y, axes_.lines.top, axes_.lines.bottom); }
    Spot place(const Datum& datum) const { return {across_(datum.x), up_(datum.y)}; }

    // Whether a spot is at the place of a datum or, beyond the axis, where the axis ends.
    bool is_at(Spot spot, const Datum& datum) const {
        const Spot its = place(datum);
        if (is_near(spot, its, tolerance_)) return true;
        return within(its.y) != its.y &&
               is_near(spot, {its.x, within(its.y)}, tolerance_ + on_whole_pixels);
    }

    // Triangles with a corner on an end of the axis: there a curve is cut.
    void find_tips() {
        constexpr double slack = 1.0;
        for (const Shape& shape : figure_.picture.shapes) {
            std::vector<Spot> corners = shape.corners();
            if (corners.size() == 4 && is_near(corners.front(), corners.back(), 0.01))
                corners.pop_back();
            if (shape.is_stroke || corners.size() != 3) continue;
            for (const Spot& tip : corners) {
                if (std::abs(tip.y - within(tip.y)) > slack ||
                    std::min(std::abs(tip.y - axes_.lines.top),
                             std::abs(tip.y - axes_.lines.bottom)) > slack)
                    continue;
                double length = 0.0;
                for (const Spot& corner : corners)
                    length = std::max(length, std::hypot(corner.x - tip.x, corner.y - tip.y));
                tips_.push_back({tip, length});
            }
        }
    }

    // Whether a spot is under the arrow where a curve is cut.
    bool is_at_tip(Spot spot) const {
        return std::ranges::any_of(tips_, [&](const Tip& tip) {
            return std::hypot(spot.x - tip.at.x, spot.y - tip.at.y) <= 1.5 * tip.length;
        });
    }

    // Whether no line shows a datum of a curve: it lies beyond the axis, or where that is cut.
    bool is_cut_off(const Datum& datum) const {
        const Spot its = place(datum);
        return std::abs(its.y - within(its.y)) > tolerance_ || is_at_tip(its);
    }

    // Whether a corner of a line lies between the data i and i + 1, where the curve is cut.
    bool is_cut_between(Spot corner, const std::vector<Datum>& data, std::size_t i) const {
        return i + 1 < data.size() && is_at_tip(corner) &&
               distance(corner, place(data[i]), place(data[i + 1])) <= tolerance_ + on_whole_pixels;
    }

    // Checks that there is an arrow wherever a curve leaves the plot.
    void check_exits(const Group& group, const std::vector<Datum>& data) {
        constexpr double beyond = 2.0;  // pixels
        for (std::size_t i = 1; i < data.size(); ++i) {
            const Spot a = place(data[i - 1]), b = place(data[i]);
            const auto is_beyond = [&](Spot at) { return std::abs(at.y - within(at.y)) > beyond; };
            if (is_beyond(a) == is_beyond(b)) continue;
            const double end = within(is_beyond(a) ? a.y : b.y);
            const double share = (end - a.y) / (b.y - a.y);
            if (share < 0.0 || share > 1.0) continue;  // within a pixel of the end
            if (!is_at_tip({a.x + share * (b.x - a.x), end}))
                complain("no arrow shows that the " + group.name() + " goes on after row " +
                         std::to_string(i - 1));
        }
    }

    void keep(Spot spot, const Datum& datum) {
        x_pairs_.push_back({spot.x, datum.x});
        if (std::abs(spot.y - up_(datum.y)) <= tolerance_) y_pairs_.push_back({spot.y, datum.y});
    }

    // The distance of a spot from the place of a datum or from where the axis ends before it.
    double off_by(Spot spot, const Datum& datum) const {
        const Spot its = place(datum);
        return std::min(std::hypot(its.x - spot.x, its.y - spot.y),
                        std::hypot(its.x - spot.x, within(its.y) - spot.y));
    }

    // Whether a curve may omit the datum: it is near the corner `before` or on the segment to
    // `corner`.
    bool is_left_out(const Datum& datum, Spot before, Spot corner) const {
        const Spot its = place(datum);
        return std::ranges::any_of(std::array{its.y, within(its.y)}, [&](double y) {
            return is_near({its.x, y}, before, thinning + tolerance_) ||
                   distance({its.x, y}, before, corner) <= tolerance_ + on_whole_pixels;
        });
    }

    // The datum that a corner of a curve shows, searched after the datum `from` of the corner
    // `before` for as long as the curve may omit the data passed. It is the first datum at the
    // corner within `precision`, otherwise the nearest one; for the last corner of the curve, the
    // last one.
    std::optional<std::size_t> next(const std::vector<Datum>& data, std::size_t from, Spot before,
                                    Spot corner, bool is_last) const {
        std::optional<std::size_t> found;
        double least = INFINITY;
        for (std::size_t i = from + 1; i < data.size(); ++i) {
            const double off = off_by(corner, data[i]);
            if (is_at(corner, data[i]) && (is_last || off < least)) found = i, least = off;
            if (off < precision && !is_last) break;
            const bool may_be_left_out = is_left_out(data[i], before, corner);
            if (!may_be_left_out && found != i) break;
        }
        return found;
    }

    // How far the data agree with the corners of a line.
    struct Match {
        std::size_t end = 0;
        std::vector<std::pair<Spot, std::size_t>> corners = {};
    };
    std::optional<Match> match_along(const std::vector<Spot>& corners,
                                     const std::vector<Datum>& data, std::size_t from) const {
        if (corners.size() < 2) return {};
        Match match{from};
        std::size_t& i = match.end;
        if (is_at(corners.front(), data[from]))
            match.corners = {{corners.front(), from}};
        else if (from > 0 && is_cut_between(corners.front(), data, from - 1))
            i = from - 1;
        else if (!is_cut_between(corners.front(), data, from))
            return {};
        if (is_rough_ && is_at(corners.back(), data.back())) {
            i = data.size() - 1;
            match.corners.emplace_back(corners.back(), i);
            return match;
        }
        for (std::size_t k = 1; k < corners.size(); ++k) {
            constexpr double same = 0.01;
            const bool is_last = k + 1 == corners.size();
            if (is_near(corners[k], corners[k - 1], same)) {
                while (is_last && i + 1 < data.size() && is_at(corners[k], data[i + 1])) ++i;
                continue;
            }
            const auto found = next(data, i, corners[k - 1], corners[k], is_last);
            if (!found && is_last) {
                while (i + 1 < data.size() && !is_cut_between(corners[k], data, i)) ++i;
                if (i + 1 < data.size()) return match;
            }
            if (!found) return {};
            i = *found;
            match.corners.emplace_back(corners[k], i);
        }
        return match;
    }

    // A curve may be broken into several lines.
    void read_curve(const Group& group) {
        std::vector<Datum> data;
        std::ranges::copy_if(group.data, std::back_inserter(data), &Datum::has_y);
        for (std::size_t from = 0; from < data.size(); ++from) {
            Match longest{from};
            const Shape* shown_by = nullptr;
            for (const Shape& shape : figure_.picture.shapes) {
                if (!shape.is_stroke || used_.contains(&shape)) continue;
                auto match = match_along(shape.corners(), data, from);
                if (match && (shown_by == nullptr || match->end > longest.end))
                    longest = std::move(*match), shown_by = &shape;
            }
            if (shown_by == nullptr && is_cut_off(data[from])) continue;
            if (shown_by == nullptr)
                return complain("no line shows the " + group.name() + " from row " +
                                std::to_string(from) + " of " + std::to_string(data.size()));
            used_.insert(shown_by);
            for (const auto& [corner, i] : longest.corners) keep(corner, data[i]);
            from = std::max(from, longest.end);
        }
        check_exits(group, data);
    }

    void read_points(const Group& group) {
        for (const Datum& datum : group.data) {
            const auto shows = [&](const Shape& shape) {
                const auto circle = shape.circle();
                return circle && is_at(circle->middle, datum);
            };
            const auto found = std::ranges::find_if(figure_.picture.shapes, shows);
            if (found == figure_.picture.shapes.end())
                complain("no point shows the " + group.name());
            else
                keep(found->circle()->middle, datum);
        }
    }

    void read_marker(const Group& group) {
        const double x = across_(group.data.front().x);
        for (const Shape& shape : figure_.picture.shapes) {
            const std::vector<Spot> ends = shape.is_stroke ? shape.corners() : std::vector<Spot>{};
            if (ends.size() != 2 || ends[0].x != ends[1].x || std::abs(ends[0].x - x) > tolerance_)
                continue;
            if (std::abs(ends[0].y - axes_.lines.bottom) > 1.0) continue;
            return x_pairs_.push_back({ends[0].x, group.data.front().x});
        }
        complain("no line up shows the " + group.name());
    }

    // Checks a band: it extends to both sides of a level by what the table says.
    void read_band(const Group& group) {
        const Row row = rows_of(figure_, group.part).at(0);
        const double error = number(row, "standard deviation of " + columns_.y);
        const double y = group.data.front().y;
        const double high = within(up_(y + error)), low = within(up_(y - error));
        for (const Shape& shape : figure_.picture.shapes) {
            const auto band = shape.is_stroke ? std::nullopt : shape.rectangle();
            if (band &&
                is_near({band->left, band->top}, {across_(group.data.front().x), high},
                        tolerance_) &&
                is_near({band->right, band->bottom}, {across_(group.data.back().x), low},
                        tolerance_))
                return;
        }
        complain("no band shows the " + group.name());
    }

    // Checks the error bars: each extends from one standard error below the mean to one above.
    void read_errors() {
        const std::string column = "standard error of " + columns_.y;
        for (const Row& row : rows_of(figure_, "mean")) {
            if (!is_filled(row, column)) continue;  // a single run has no error
            const double x = across_(number(row, columns_.x)), y = number(row, columns_.y);
            const double error = number(row, column);
            const bool is_shown =
                std::ranges::any_of(figure_.picture.shapes, [&](const Shape& shape) {
                    const std::vector<Spot> ends =
                        shape.is_stroke ? shape.corners() : std::vector<Spot>{};
                    return ends.size() == 2 && is_near(ends[0], {x, up_(y - error)}, tolerance_) &&
                           is_near(ends[1], {x, up_(y + error)}, tolerance_);
                });
            if (!is_shown) complain("no bar shows the error at " + row.at(columns_.x));
        }
    }

    // Checks a band around the steps of a profile: each end of a step has two corners of it, one
    // standard error to either side.
    void read_error_band(const std::string& of, Spot along) {
        for (const Row& row : rows_of(figure_, "profile")) {
            const std::string column = "standard error of " + of;
            if (!row.contains(column) || !is_filled(row, column)) continue;
            const double error = number(row, column);
            for (const double side : {-error, error}) {
                const Spot corner{across_(number(row, columns_.x) + side * along.x),
                                  up_(number(row, columns_.y) + side * along.y)};
                const bool is_shown =
                    std::ranges::any_of(figure_.picture.shapes, [&](const Shape& shape) {
                        return !shape.is_stroke &&
                               std::ranges::any_of(shape.corners(), [&](Spot its) {
                                   return is_near(its, corner, tolerance_);
                               });
                    });
                if (!is_shown) complain("no band shows the error at " + row.at(of));
            }
        }
    }

    // For an outline of level and upright sides: the highest level side at x.
    static std::optional<double> top_at(const std::vector<Spot>& outline, double x) {
        std::optional<double> top;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Spot &a = outline[i], &b = outline[(i + 1) % outline.size()];
            if (a.y != b.y || x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
            top = top ? std::min(*top, a.y) : a.y;
        }
        return top;
    }

    // Whether ever fainter pieces go on from the top of a bar to the end of the axis.
    bool fades_out(double x, double top) const {
        constexpr double slack = 1.0;
        double faintest = 1.0;
        for (const Shape& shape : figure_.picture.shapes) {
            const auto piece = shape.is_stroke ? std::nullopt : shape.rectangle();
            if (!piece || piece->left > x || piece->right < x) continue;
            if (std::abs(piece->bottom - top) > 0.1 + (faintest == 1.0 ? slack : 0.0)) continue;
            if (shape.paint[3] >= faintest) continue;
            top = piece->top;
            faintest = shape.paint[3];
        }
        return top <= axes_.lines.top + slack && faintest < 0.1;
    }

    static double nearest_side(const std::vector<Spot>& outline, double x) {
        double nearest = INFINITY;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Spot &a = outline[i], &b = outline[(i + 1) % outline.size()];
            if (a.x == b.x && std::abs(a.x - x) < std::abs(nearest - x)) nearest = a.x;
        }
        return nearest;
    }

    void read_bars(const Group& group) {
        Problems fewest;
        bool is_found = false;
        const auto all_x = x_pairs_, all_y = y_pairs_;
        auto best_x = all_x, best_y = all_y;
        for (const Shape& shape : figure_.picture.shapes) {
            const std::vector<Spot> outline =
                shape.is_stroke ? std::vector<Spot>{} : shape.corners();
            if (outline.size() < 4 ||
                shape.pieces.front().edges().width() > figure_.picture.width - 2)
                continue;
            if (std::abs(shape.pieces.front().edges().bottom - axes_.lines.bottom) > 1.0) continue;
            x_pairs_ = all_x, y_pairs_ = all_y;
            Problems its = bar_problems(group, outline);
            if (is_found && its.size() >= fewest.size()) continue;
            is_found = true, fewest = std::move(its);
            best_x = x_pairs_, best_y = y_pairs_;
        }
        x_pairs_ = best_x, y_pairs_ = best_y;
        if (!is_found) complain("no bars");
        for (const std::string& one : fewest) complain(one);
    }

    Problems bar_problems(const Group& group, const std::vector<Spot>& outline) {
        Problems problems;
        std::optional<double> before;
        const std::string name = group.name() + " at ";
        for (std::size_t i = 1; i < group.data.size(); ++i)
            if (group.data[i].x != group.data[i - 1].to)
                problems.push_back(name + std::to_string(group.data[i].x) + ": it begins too late");
        for (const Datum& bar : group.data) {
            const double left = across_(bar.x), right = across_(bar.to);
            const double bottom = axes_.lines.bottom, expected = up_(bar.y);
            const double top = top_at(outline, 0.5 * (left + right)).value_or(bottom);
            if (within(expected) != expected) {
                if (!fades_out(0.5 * (left + right), top))
                    problems.push_back(name + std::to_string(bar.x) + ": it does not fade out");
            } else if (std::abs(top - expected) > tolerance_)
                problems.push_back(name + std::to_string(bar.x) + ": its top is " +
                                   std::to_string(top - expected) + " pixels off");
            else
                y_pairs_.push_back({top, bar.y});
            if (std::abs(top - before.value_or(bottom)) > 1.0) {
                const double side = nearest_side(outline, left);
                if (std::abs(side - left) > tolerance_ + precision)
                    problems.push_back(name + std::to_string(bar.x) + ": its side is " +
                                       std::to_string(side - left) + " pixels off");
                else
                    x_pairs_.push_back({side, bar.x});
            }
            before = top;
        }
        return problems;
    }

    const DrawnFigure& figure_;
    PlotColumns columns_;
    DrawnAxes axes_;
    LinearMap across_, up_;
    std::vector<Group> groups_;
    double tolerance_ = 0.0;
    bool is_rough_ = true;
    std::vector<Pair> x_pairs_, y_pairs_;
    struct Tip {
        Spot at;
        double length = 0.0;
    };
    std::vector<Tip> tips_;
    std::set<const Shape*> used_;  ///< shapes that were read as lines
    Problems problems_;
};

}  // namespace

Problems plot_problems(const DrawnFigure& figure, const PlotColumns& columns) {
    return PlotReading(figure, columns).problems();
}

Problems stack_problems(const DrawnFigure& figure, const PlotColumns& columns) {
    return PlotReading(figure, columns).stack();
}

}  // namespace carom::test
