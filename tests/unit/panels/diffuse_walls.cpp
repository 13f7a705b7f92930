// Walls and partitions that reflect diffusely, as a reader tells them apart from others.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "panels/frame.h"
#include "panels/surfaces/surface_view.h"
#include "panels/surfaces/surface_words.h"
#include "scene/describe.h"
#include "support/pixels.h"
#include "support/scene_text.h"
#include "support/shot.h"

using namespace carom;

namespace {

using Picture = std::vector<std::uint32_t>;

Scene gas_in_print() {
    Scene scene = test::scene_from(
        "title: T\nbox: {size: [20, 10]}\npartitions: [{name: wall, x: 12}]\n"
        "gas: [{count: 5, radius: 0.3, speed: 2, position: {within: [0, 0, 8, 10]}}]\n"
        "run: {until: 3}\n"
        "film: {seconds: 2, fps: 10, panels: [], size: [640, 360], theme: print}\n");
    scene.gas.box.surfaces.gravity = {0.0, -1e-6};  // the box is not plain, whatever its walls are
    return scene;
}

Picture picture_of(const Scene& scene) {
    const test::Shot shot(scene, 1);
    FramePainter painter(*shot.panels);
    return test::pixels_of(painter.paint(shot.frames[0]));
}

}  // namespace

TEST_CASE("a diffuse side or partition looks like no other, without colour too") {
    const std::vector<Behaviour> kinds{Diffuse{},   Reflecting{}, Bath{2.0},
                                       Driven{0.5}, Piston{9.0},  Membrane{.species = {0}}};
    for (std::size_t k = 1; k < kinds.size(); ++k) {
        Scene diffuse = gas_in_print(), other = gas_in_print();
        diffuse.gas.box.surfaces.partitions[0].behaviour = kinds[0];
        other.gas.box.surfaces.partitions[0].behaviour = kinds[k];
        CHECK(picture_of(diffuse) != picture_of(other));
    }
    for (std::size_t side = 0; side < 4; ++side)
        for (std::size_t k = 1; k < 5; ++k) {
            Scene diffuse = gas_in_print(), other = gas_in_print();
            diffuse.gas.box.surfaces.sides[side] = kinds[0];
            other.gas.box.surfaces.sides[side] = kinds[k];
            CHECK(picture_of(diffuse) != picture_of(other));
        }
}

TEST_CASE("the words for a diffuse wall are there in every language") {
    Scene scene = gas_in_print();
    scene.gas.box.surfaces.sides[0] = Diffuse{};
    scene.run.events = {{1.0, ChangeSurface{1, Diffuse{}}}};
    const std::vector<std::string> at_start{
        "The left wall reflects diffusely", "Die linke Wand reflektiert diffus",
        "La paroi gauche réfléchit de façon diffuse", "La pared izquierda refleja de forma difusa"};
    std::size_t k = 0;
    for (const Language language :
         {Language::english, Language::german, Language::french, Language::spanish}) {
        CHECK(words_of_surfaces({language}, scene.gas).front() == at_start[k++]);
        const std::string change =
            words_of_surface_event({language}, scene.run.events[0], scene.gas);
        if (language != Language::english) CHECK(change.find("diffusely") == std::string::npos);
    }
    CHECK(words_of_surface_event({Language::english}, scene.run.events[0], scene.gas) ==
          "The right wall reflects diffusely from now on");
    CHECK(label_of_surface(Language::english, scene.gas, Diffuse{}, 0).empty());
}
