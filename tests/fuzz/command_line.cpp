// Fuzz target: the words after `carom`, one per line. They are parsed but not executed; those that
// contain a `=` are also tried as overrides of a scene and as the axis of a sweep.
#include "app/commands/command_line.h"

#include "fuzz/fuzz.h"
#include "runs/own_files.h"
#include "scene/scene.h"
#include "scene/sweep.h"

using namespace carom;

namespace {

constexpr const char* scene =
    "title: T\nbox: {size: [20, 15], walls: {left: {temperature: 2}}}\n"
    "partitions: [{name: p, x: 9}]\ngas: [{name: a, count: 4, radius: 0.3, speed: 1}]\n"
    "run: {until: 2, events: [{at: 1, open: p}]}\nfilm: {seconds: 1, panels: [speed-histogram]}\n";

// Reads the word as the axis of a sweep, and what follows the `=` as a range of seeds.
void read_sweep(const std::string& word) {
    try {
        check_sweep(
            {.axes = {sweep_axis(word)}, .seeds = seed_range(word.substr(word.find('=') + 1))});
    } catch (const SweepError&) {
    }
}

}  // namespace

void test::fuzz(const std::uint8_t* data, std::size_t size) {
    static const SceneResources resources = scene_resources();
    const std::vector<std::string> words = test::fuzz_lines(test::fuzz_text(data, size));
    test::succeeds([&] { check_command_line(words); });
    Overrides overrides;
    for (const std::string& word : words) {
        const std::size_t sign = word.find('=');
        if (sign == std::string::npos || sign == 0) continue;
        overrides.push_back(word);
        read_sweep(word);
    }
    if (!overrides.empty())
        test::succeeds([&] { load_scene_text(scene, "scene.yaml", resources, overrides); });
}
