// SVG and PDF: read back by another reader than the writer.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/disks/disks.h"
#include "draw/svg.h"
#include "draw/text.h"
#include "util/diagnostics.h"

using namespace carom;

namespace {

const PictureWords words{"Hot & cold <disks>", "Two disks, “one” of them hot.", "a & b"};
constexpr PixelSize size{400, 300};
constexpr Color blue = rgb(0x0000FF);

std::string file_of(Canvas& canvas) {
    const std::vector<std::uint8_t> bytes = canvas.file();
    return {bytes.begin(), bytes.end()};
}

struct Svg {
    pugi::xml_document document;
    pugi::xml_node root;

    explicit Svg(const std::string& text) {
        REQUIRE(document.load_string(text.c_str()));
        root = document.document_element();
        REQUIRE(std::string(root.name()) == "svg");
    }

    std::set<std::string> ids() const {
        std::set<std::string> all;
        for (const pugi::xpath_node& found : document.select_nodes("//@id"))
            CHECK(all.insert(found.attribute().value()).second);
        return all;
    }

    // What links and `url(#...)` refer to.
    std::set<std::string> references() const {
        std::set<std::string> all;
        for (const pugi::xpath_node& found : document.select_nodes("//@*[contains(., '#')]")) {
            const std::string value = found.attribute().value();
            for (std::size_t at = value.find('#'); at != std::string::npos;
                 at = value.find('#', at + 1)) {
                const bool is_address = at >= 4 && value.compare(at - 4, 4, "url(") == 0;
                if (at != 0 && !is_address) continue;
                all.insert(value.substr(at + 1, value.find_first_of(")'\"", at) - at - 1));
            }
        }
        return all;
    }

    std::size_t count(const std::string& name) const {
        return document.select_nodes(("//" + name).c_str()).size();
    }
};

// Some of everything that a picture may hold.
std::string drawn(VectorFormat format) {
    Canvas canvas(size, format, words);
    canvas.fill_all(rgb(0xFFFFFF));
    canvas.clip_to({10, 10, 200, 200});
    canvas.fill({5, 5, 50, 50}, with_alpha(blue, 0.3));
    canvas.release_clip();
    draw_text(canvas, {20, 200}, "mean <b>energy</b>", {.color = blue});
    DiskPainter disks;
    const std::vector<Disk> three{{50, 60, 8, 0x123456}, {99, 60, 8, 0xABCDEF}, {150, 60, 8, 0}};
    disks.draw(canvas, three, {0, 0, 100, 100});
    return file_of(canvas);
}

// Canvases and letters that come before, as in a process that draws more than one picture.
void draw_something_else() {
    Canvas raster({50, 50});
    draw_text(raster, {0, 20}, "before", {});
    Canvas other(size, VectorFormat::svg, {});
    other.fill_all(blue);
    other.file();
}

}  // namespace

TEST_CASE("an SVG has a title, a description and the role of a picture") {
    const Svg svg(drawn(VectorFormat::svg));
    CHECK(std::string(svg.root.attribute("role").value()) == "img");
    const pugi::xml_node first = svg.root.first_child();
    CHECK(std::string(first.name()) == "title");
    CHECK(first.text().get() == words.title);
    CHECK(std::string(first.next_sibling().name()) == "desc");
    CHECK(first.next_sibling().text().get() == words.description);
    CHECK(svg.root.child("metadata").text().get() == words.origin);
}

TEST_CASE("a pixel is a user unit of an SVG and three quarters of a point in a PDF") {
    const Svg svg(drawn(VectorFormat::svg));
    CHECK(std::string(svg.root.attribute("width").value()) == "400px");
    CHECK(std::string(svg.root.attribute("height").value()) == "300px");
    CHECK(std::string(svg.root.attribute("viewBox").value()) == "0 0 400 300");
    CHECK(drawn(VectorFormat::pdf).find("/MediaBox [ 0 0 300 225 ]") != std::string::npos);
}

TEST_CASE("disks of a vector picture are curves, cut where they are asked to be") {
    Canvas canvas(size, VectorFormat::svg, words);
    DiskPainter disks;
    // Inside, over the edge, outside.
    const std::vector<Disk> three{{50, 60, 8, 0x123456}, {99, 60, 8, 0xABCDEF}, {150, 60, 8, 0}};
    disks.draw(canvas, three, {0, 0, 100, 100});
    const Svg svg(file_of(canvas));
    CHECK(svg.count("image") == 0);
    // Cairo says the colour in `style` up to 1.16, in `fill` from 1.18 on.
    CHECK(svg.count("path[contains(@d, 'C') and (contains(@style, 'fill:') or @fill)]") == 2);
    CHECK(svg.count("clipPath") == 1);
}

TEST_CASE("the same drawing gives the same document, whatever was drawn before") {
    for (const VectorFormat format : {VectorFormat::svg, VectorFormat::pdf}) {
        const std::string first = drawn(format);
        draw_something_else();
        CHECK(first.size() > 1000);
        CHECK(drawn(format) == first);
    }
}

TEST_CASE("two pictures share no id, and every reference leads to one of the same picture") {
    const Svg svg(drawn(VectorFormat::svg));
    Canvas canvas(size, VectorFormat::svg, words);
    draw_text(canvas, {20, 200}, "other letters", {});
    canvas.clip_to({10, 10, 100, 100});
    canvas.fill_all(blue);
    canvas.release_clip();
    const Svg other(file_of(canvas));
    for (const Svg* one : {&svg, &other}) {
        CHECK(one->ids().size() > 5);
        const std::set<std::string> ids = one->ids(), references = one->references();
        CHECK(references.size() > 5);
        CHECK(std::ranges::includes(ids, references));
    }
    std::vector<std::string> both;
    std::ranges::set_intersection(svg.ids(), other.ids(), std::back_inserter(both));
    CHECK(both.empty());
}

TEST_CASE("every kind of reference follows the ids") {
    const std::string text =
        "<svg xmlns='http://www.w3.org/2000/svg' fill='#102030'><clipPath id='a'/>"
        "<g id='b' clip-path='url(#a)' style='mask:url(#b); fill:url(#a)'/>"
        "<use href='#a'/><use xlink:href='#b'/><a href='other#a'/></svg>";
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    const std::vector<std::uint8_t> finished = finished_svg(bytes, words);
    const Svg svg({finished.begin(), finished.end()});
    const auto value = [&](const char* path) {
        return std::string(svg.document.select_node(path).attribute().value());
    };
    const std::string a = value("//clipPath/@id"), b = value("//g/@id");
    CHECK(a.size() > 2);
    CHECK(value("//g/@clip-path") == "url(#" + a + ")");
    CHECK(value("//g/@style") == "mask:url(#" + b + "); fill:url(#" + a + ")");
    CHECK(value("(//use)[1]/@href") == "#" + a);
    CHECK(value("(//use)[2]/@*") == "#" + b);
    CHECK(value("//a/@href") == "other#a");
    CHECK(value("/svg/@fill") == "#102030");
}

TEST_CASE("a PDF tells its title, and no date of its making") {
    const std::string pdf = drawn(VectorFormat::pdf);
    CHECK(pdf.find("/Title (Hot & cold <disks>)") != std::string::npos);
    // Cairo 1.16 leaves out the `D:` that dates begin with.
    for (const std::string date : {"/CreationDate (", "/ModDate ("}) {
        const std::size_t at = pdf.find(date);
        REQUIRE(at != std::string::npos);
        const std::string value = pdf.substr(at + date.size(), 17);
        CHECK((value.starts_with("20000101000000Z") || value == "D:20000101000000Z"));
    }
}

TEST_CASE("a document of no size is refused") {
    CHECK_THROWS_AS(Canvas({0, 10}, VectorFormat::svg, words), SystemError);
    CHECK_THROWS_AS(Canvas({10, 20000}, VectorFormat::pdf, words), SystemError);
}

TEST_CASE("what is no SVG is not finished") {
    for (const std::string text : {"", "<svg", "<html/>"}) {
        CAPTURE(text);
        const std::vector<std::uint8_t> bytes(text.begin(), text.end());
        CHECK_THROWS_AS(finished_svg(bytes, words), SystemError);
    }
}
