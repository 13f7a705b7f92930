// Scenes in Jupyter notebooks, by the extension in integrations/jupyter, run by nbconvert with a
// kernel. Skipped where Debian's python3-nbconvert and python3-ipykernel are not installed.
#include <nlohmann/json.hpp>

#include "e2e/in_documents.h"

using namespace carom::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string python = "/usr/bin/python3";

bool has_nbconvert() {
    if (run({python, "-c", "import nbconvert, ipykernel"}).exit_code == 0) return true;
    MESSAGE("nbconvert or ipykernel is not installed: the extension is not tried");
    return false;
}

// notebook.ipynb with its cells run, as a notebook or a page.
Outcome made(const ExampleDocuments& example, const std::string& format) {
    return example.call({python, "-m", "nbconvert", "--execute", "--to", format, "--output", "done",
                         "notebook.ipynb"});
}

// What the cells of code have put out, by their order.
std::vector<json> outputs_of(const std::string& notebook) {
    std::vector<json> outputs;
    const json read = json::parse(notebook);
    for (const json& cell : read["cells"])
        if (cell["cell_type"] == "code")
            outputs.push_back(cell["outputs"].empty() ? json() : cell["outputs"][0]["data"]);
    return outputs;
}

std::string joined(const json& text) {
    if (text.is_string()) return text;
    std::string all;
    for (const json& line : text) all += line.get<std::string>();
    return all;
}

// The outcome of Python with the extension at hand.
Outcome in_python(const ExampleDocuments& example, const std::string& code) {
    return example.call({python, "-c",
                         "import sys\nsys.path.insert(0, '../jupyter')\n"
                         "import carom_jupyter as carom\n" +
                             code});
}

}  // namespace

TEST_CASE("a notebook shows the films, the picture and the numbers of the example") {
    if (!has_nbconvert()) return;
    const ExampleDocuments example;
    const Outcome outcome = made(example, "notebook");
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const std::vector<json> outputs = outputs_of(example.text("done.ipynb"));
    REQUIRE(outputs.size() == 6);
    const std::string film = joined(outputs[1]["text/html"]);
    CHECK(has(film, "<video controls"));
    CHECK(has(film, "aria-label=\"A fast disk flies into forty slow ones."));
    CHECK(has(film, "<track kind=\"captions\""));
    CHECK(has(film, "One fast disk has nearly all of the energy"));  // in the transcript
    CHECK_FALSE(joined(outputs[1]["image/png"]).empty());
    CHECK(joined(outputs[1]["text/plain"]).starts_with("A fast disk flies"));
    CHECK(has(joined(outputs[2]["text/html"]), "src=\"data:video/mp4;base64,"));
    CHECK(has(joined(outputs[3]["text/html"]), "<img src=\"data:image/svg+xml;base64,"));
    CHECK(example.media(".mp4").size() == 2);
    // The numbers are those of the program.
    const json of_run =
        json::parse(run({program, "run", "gas.yaml", "--json", "-"}, example.place()).out);
    const std::string plain = joined(outputs[4]["text/plain"]);
    CHECK(has(plain, "collisions.particle"));
    CHECK(has(plain, std::to_string(of_run["collisions"]["particle"].get<int>())));
    CHECK(has(joined(outputs[4]["text/html"]), "species.the fast disk.count"));
    const json three = json::parse(joined(outputs[5]["text/plain"]));
    CHECK(three[0] == of_run["collisions"]["particle"]);
    CHECK(three[1] != three[0]);
    REQUIRE(made(example, "html").exit_code == 0);
    CHECK(has(example.text("done.html"), "<video "));
    CHECK(example.media(".mp4").size() == 2);
}

TEST_CASE("large films stand beside the notebook, and samples are rows") {
    if (!has_nbconvert()) return;
    const ExampleDocuments example;
    const Outcome outcome = in_python(example,
                                      "carom.embed_below = 0\n"
                                      "film = carom.film('gas.yaml', **{'film.size': [320, 180]})\n"
                                      "print(film.path in film._repr_html_())\n"
                                      "run = carom.run('gas.yaml')\n"
                                      "sys.modules['pandas'] = None\n"
                                      "rows = run.samples()\n"
                                      "print(len(rows), sorted(rows[0])[-1])\n"
                                      "print('<tr><th>particles</th><td>41</td></tr>' in "
                                      "run._repr_html_())\n");
    CAPTURE(outcome.err);
    CHECK(has(outcome.out, "True\n"));
    const std::string samples =
        run({program, "run", "gas.yaml", "--csv", "-", "--quiet"}, example.place()).out;
    const auto rows = std::ranges::count(samples, '\n') - 1;
    CHECK(has(outcome.out, std::to_string(rows) + " y\nTrue\n"));
}

TEST_CASE("with pandas, numbers and samples are tables of it") {
    if (!has_nbconvert() || run({python, "-c", "import pandas"}).exit_code != 0) return;
    const ExampleDocuments example;
    const Outcome outcome = in_python(example,
                                      "run = carom.run('gas.yaml')\n"
                                      "samples, numbers = run.samples(), run.frame()\n"
                                      "print(len(samples), samples.y.dtype, len(numbers), "
                                      "numbers.particles[0])\n"
                                      "print('<td>41</td>' in run._repr_html_())\n");
    CAPTURE(outcome.err);
    const std::string samples =
        run({program, "run", "gas.yaml", "--csv", "-", "--quiet"}, example.place()).out;
    const auto rows = std::ranges::count(samples, '\n') - 1;
    CHECK(outcome.out == std::to_string(rows) + " float64 1 41\nTrue\n");
}

TEST_CASE("hostile values and scenes in a notebook are words or errors") {
    if (!has_nbconvert()) return;
    const ExampleDocuments example;
    const Outcome words = in_python(
        example,
        "film = carom.film('gas.yaml', **{'title': '\"><script>pwned()</script>$(touch pwned)',\n"
        "  'description': '\"><img src=x onerror=pwned()>', 'film.size': [320, 180]})\n"
        "print(film._repr_html_())\n");
    CHECK(words.exit_code == 0);
    CHECK_FALSE(has(words.out, "<script>pwned"));
    CHECK_FALSE(has(words.out, "<img src=x"));
    CHECK_FALSE(fs::exists(example.path("pwned")));
    const auto refusal = [&](const std::string& code) {
        const Outcome outcome = in_python(
            example, "try: " + code + "\nexcept carom.CaromError as error: print(error)\n");
        CHECK(outcome.exit_code == 0);
        return outcome.out;
    };
    CHECK(has(refusal("carom.film('gas.yaml', **{'--output': 'x'})"), "is no path of a key"));
    CHECK(has(refusal("carom.film('gas.yaml', **{'film.seconds': 121})"), "the limit is 120"));
    CHECK(has(refusal("carom.still('--help')"), "--help: error: cannot be read"));
    CHECK(has(refusal("carom.still('gas.yaml', at=99)"), "the scene runs from 0 to 4"));
    example.write("notebook.ipynb", R"({"cells": [{"cell_type": "code", "id": "a", "metadata": {},
        "execution_count": null, "outputs": [], "source": "%load_ext carom_jupyter"},
        {"cell_type": "code", "id": "b", "metadata": {}, "execution_count": null, "outputs": [],
        "source": "%%carom --at soon\ntitle: T"}], "metadata": {}, "nbformat": 4,
        "nbformat_minor": 5})");
    const Outcome magic =
        example.call({"env", "PYTHONPATH=../jupyter", python, "-m", "nbconvert", "--execute",
                      "--to", "notebook", "--output", "done", "notebook.ipynb"});
    CHECK(magic.exit_code == 1);
    CHECK(has(magic.err, "--at soon: expected a simulated time"));
}
