#include "support/svg_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

#include "support/files.h"

namespace carom::test {
namespace {

struct Matrix {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
    Spot operator()(Spot p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    Matrix operator*(const Matrix& m) const {
        return {a * m.a + c * m.b, b * m.a + d * m.b,     a * m.c + c * m.d,
                b * m.c + d * m.d, a * m.e + c * m.f + e, b * m.e + d * m.f + f};
    }
};

// The rest of a text after the spaces and commas at `at`.
const char* next_in(const char* at) { return at + std::strspn(at, ", \n"); }

// The number at `at`, which moves behind it.
std::optional<double> number_in(const char*& at) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at) return std::nullopt;
    at = next_in(end);
    return number;
}

// The numbers of a list that is separated by commas or spaces.
std::vector<double> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    for (const char* at = next_in(text.c_str()); *at != '\0';) {
        const std::optional<double> number = number_in(at);
        if (!number) throw std::runtime_error("no list of numbers: " + text);
        numbers.push_back(*number);
    }
    return numbers;
}

Matrix matrix_of(const pugi::xml_node& node) {
    const std::string text = node.attribute("transform").value();
    if (text.empty()) return {};
    if (!text.starts_with("matrix(") || !text.ends_with(")"))
        throw std::runtime_error("a transform that is no matrix: " + text);
    const std::vector<double> n = numbers_in(text.substr(7, text.size() - 8));
    if (n.size() != 6) throw std::runtime_error("no matrix: " + text);
    return {n[0], n[1], n[2], n[3], n[4], n[5]};
}

// A property of an element, or of its nearest ancestor that sets it: from the attribute `style`, as
// Cairo 1.16 writes it, or from an attribute of its own, as 1.18 does.
std::string property(pugi::xml_node node, const std::string& name) {
    for (; node; node = node.parent()) {
        std::istringstream style(node.attribute("style").value());
        for (std::string part; std::getline(style, part, ';');) {
            const std::size_t start = part.find_first_not_of(' '), colon = part.find(':');
            if (colon != std::string::npos && part.substr(start, colon - start) == name)
                return part.substr(colon + 1);
        }
        if (const pugi::xml_attribute own = node.attribute(name.c_str())) return own.value();
    }
    return "";
}

double number_or(const std::string& text, double otherwise) {
    return text.empty() ? otherwise : std::stod(text);
}

Paint paint_of(const pugi::xml_node& node, const std::string& kind) {
    std::string color = property(node, kind);
    if (!color.starts_with("rgb(")) throw std::runtime_error("a colour that is no rgb: " + color);
    color = color.substr(4, color.size() - 5);
    const bool is_share = std::erase(color, '%') > 0;
    Paint paint{};
    const std::vector<double> levels = numbers_in(color);
    for (std::size_t i = 0; i < 3; ++i)
        paint[i] = is_share ? levels.at(i) * 255.0 / 100.0 : levels.at(i);
    paint[3] = number_or(property(node, kind + "-opacity"), 1.0);
    return paint;
}

std::vector<Outline> pieces_of(const std::string& path, const Matrix& to_picture) {
    std::vector<Outline> pieces;
    const char* at = next_in(path.c_str());
    const auto add_points = [&](char command, int count) {
        if (command == 'M' || pieces.empty()) pieces.emplace_back();
        pieces.back().commands += command;
        for (int i = 0; i < count; ++i) {
            const std::optional<double> x = number_in(at), y = number_in(at);
            if (!x || !y) throw std::runtime_error("a path ends: " + path);
            pieces.back().points.push_back(to_picture({*x, *y}));
        }
    };
    while (*at != '\0') {
        const char command = *at;
        at = next_in(at + 1);
        if (command != 'M' && command != 'L' && command != 'C' && command != 'Z')
            throw std::runtime_error("an unknown command in a path: " + path);
        add_points(command, command == 'C' ? 3 : command == 'Z' ? 0 : 1);
    }
    // After each closed subpath Cairo moves back to its start; drop these lone moves.
    std::erase_if(pieces, [](const Outline& piece) { return piece.commands == "M"; });
    return pieces;
}

Edges around(const std::vector<Edges>& all) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Edges sum{infinite, infinite, -infinite, -infinite};
    for (const Edges& one : all)
        sum = {std::min(sum.left, one.left), std::min(sum.top, one.top),
               std::max(sum.right, one.right), std::max(sum.bottom, one.bottom)};
    return sum;
}

class Reader {
  public:
    explicit Reader(const std::string& text) {
        if (!document_.load_buffer(text.data(), text.size()))
            throw std::runtime_error("no XML document");
        const pugi::xml_node root = document_.document_element();
        picture_.width = std::stod(root.attribute("width").value());
        picture_.height = std::stod(root.attribute("height").value());
        for (const pugi::xpath_node& one : document_.select_nodes("//*[@id]"))
            by_id_.emplace(one.node().attribute("id").value(), one.node());
        read_children(root, {}, {});
    }
    SvgPicture picture() { return std::move(picture_); }

  private:
    using Clip = std::optional<Edges>;

    // The part of `outer` that the clip of an element leaves; clips are rectangles.
    Clip clip_of(const pugi::xml_node& node, const Clip& outer) const {
        const std::string url = node.attribute("clip-path").value();
        if (url.empty()) return outer;
        const pugi::xml_node clip = by_id_.at(url.substr(5, url.size() - 6)).first_child();
        Edges own;
        if (std::string(clip.name()) == "rect") {
            own = rectangle_of(clip, {}).edges();
        } else {
            const Shape shape{.pieces = pieces_of(clip.attribute("d").value(), {})};
            const std::optional<Edges> edges = shape.rectangle();
            if (!edges) throw std::runtime_error("a clip that is no rectangle");
            own = *edges;
        }
        if (!outer) return own;
        return Edges{std::max(own.left, outer->left), std::max(own.top, outer->top),
                     std::min(own.right, outer->right), std::min(own.bottom, outer->bottom)};
    }

    void read_children(const pugi::xml_node& parent, const Matrix& outer, const Clip& clip) {
        bool in_letters = false;
        for (const pugi::xml_node& node : parent.children()) {
            const std::string name = node.name();
            const Matrix own = outer * matrix_of(node);
            if (name == "use") read_letter(node, own, in_letters);
            in_letters = name == "use";
            const Clip left = clip_of(node, clip);
            if (name == "g" || name == "svg") read_children(node, own, left);
            if (name == "path") add_path(node, pieces_of(node.attribute("d").value(), own), left);
            if (name == "rect") add_path(node, {rectangle_of(node, own)}, left);
            if (name == "image") throw std::runtime_error("a picture of pixels");
        }
    }

    static Outline rectangle_of(const pugi::xml_node& node, const Matrix& to_picture) {
        const auto number = [&](const char* name) {
            return number_or(node.attribute(name).value(), 0.0);
        };
        const double x = number("x"), y = number("y");
        const double right = x + number("width"), bottom = y + number("height");
        return {"MLLLZ",
                {to_picture({x, y}), to_picture({right, y}), to_picture({right, bottom}),
                 to_picture({x, bottom})}};
    }

    void add_path(const pugi::xml_node& node, std::vector<Outline> pieces, const Clip& clip) {
        if (pieces.empty()) return;
        const bool is_stroke = property(node, "fill") == "none";
        picture_.shapes.push_back({is_stroke, number_or(property(node, "stroke-width"), 1.0),
                                   paint_of(node, is_stroke ? "stroke" : "fill"), std::move(pieces),
                                   clip});
    }

    void read_letter(const pugi::xml_node& node, const Matrix& to_picture, bool goes_on) {
        const std::string id = node.attribute("xlink:href").value();
        const pugi::xml_node path = by_id_.at(id.substr(1)).child("path");
        Outline all;
        for (const Outline& piece : pieces_of(path.attribute("d").value(), {})) {
            all.commands += piece.commands;
            all.points.insert(all.points.end(), piece.points.begin(), piece.points.end());
        }
        if (!goes_on) picture_.texts.push_back({{}, paint_of(node, "fill")});
        picture_.texts.back().all.push_back(
            {std::move(all),
             to_picture({node.attribute("x").as_double(), node.attribute("y").as_double()})});
    }

    pugi::xml_document document_;
    std::map<std::string, pugi::xml_node> by_id_;
    SvgPicture picture_;
};

}  // namespace

Edges Outline::edges() const {
    std::vector<Edges> all;
    for (const Spot& p : points) all.push_back({p.x, p.y, p.x, p.y});
    return around(all);
}

std::optional<Edges> Shape::rectangle() const {
    const std::vector<Spot> all = corners();
    if (all.size() != 4) return {};
    const Edges edges = pieces.front().edges();
    for (const Spot& corner : all) {
        if (corner.x != edges.left && corner.x != edges.right) return {};
        if (corner.y != edges.top && corner.y != edges.bottom) return {};
    }
    return edges;
}

std::optional<Circle> Shape::circle() const {
    constexpr double rounding = 0.02;  // pixels: the numbers of Cairo are rounded
    if (pieces.size() != 1) return {};
    const auto& [commands, points] = pieces.front();
    if (commands.size() < 4 || commands.find('L') != std::string::npos || commands[1] != 'C')
        return {};
    std::vector<Spot> ends;  // ends of the arcs, which are equally long
    for (std::size_t i = 3; i < points.size(); i += 3) ends.push_back(points[i]);
    Circle circle;
    for (const Spot& end : ends) {
        circle.middle.x += end.x / static_cast<double>(ends.size());
        circle.middle.y += end.y / static_cast<double>(ends.size());
    }
    circle.radius = std::hypot(ends[0].x - circle.middle.x, ends[0].y - circle.middle.y);
    for (const Spot& end : ends)
        if (std::abs(std::hypot(end.x - circle.middle.x, end.y - circle.middle.y) - circle.radius) >
            rounding)
            return {};
    return circle;
}

std::vector<Spot> Shape::corners() const {
    if (pieces.size() != 1 || pieces.front().commands.find('C') != std::string::npos) return {};
    return pieces.front().points;
}

Edges Letters::edges() const {
    std::vector<Edges> inks;
    for (const Letter& letter : all) {
        if (letter.outline.points.empty()) continue;
        const Edges ink = letter.outline.edges();
        inks.push_back({ink.left + letter.at.x, ink.top + letter.at.y, ink.right + letter.at.x,
                        ink.bottom + letter.at.y});
    }
    return around(inks);
}

SvgPicture svg_picture(const std::string& document) { return Reader(document).picture(); }

SvgPicture svg_picture(const std::filesystem::path& file) { return svg_picture(contents(file)); }

}  // namespace carom::test
