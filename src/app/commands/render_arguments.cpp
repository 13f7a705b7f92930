#include "app/commands/render_arguments.h"

#include <fmt/format.h>

#include <limits>

#include "app/film/film_request.h"
#include "films/cost/film_shape.h"
#include "media/formats.h"
#include "util/diagnostics.h"
#include "util/text.h"

namespace carom {

double most_bytes(const RenderArguments& arguments) {
    if (arguments.max_size.empty()) return std::numeric_limits<double>::infinity();
    return parsed_bytes("--max-size", arguments.max_size);
}

void refuse_slide_options(const RenderArguments& arguments) {
    const FilmDestination& its = arguments.destination;
    refuse_file_for_folder(its.slides, "a set of slides", "--slides");
    if (!its.output.empty())
        throw UsageError(fmt::format(
            "-o {}: the folder of slides is named behind --slides; write --slides {} instead",
            its.output, its.output));
    if (!its.page.empty())
        throw UsageError("--slides: the slides are a page of all films; leave --page out");
    if (arguments.join)
        throw UsageError(
            "--slides: each scene gets a slide; leave --join out, or join the films first and "
            "insert the one film yourself");
}

void refuse_page_options(const RenderArguments& arguments, const OutputFormat& format) {
    if (!arguments.max_size.empty() && format.in_one_piece)
        throw UsageError("--max-size: the pages of a PDF have no pixels, and no size is foreseen");
    const bool is_slides = !arguments.destination.slides.empty();
    if (arguments.destination.page.empty() && !is_slides) return;
    if (arguments.join)
        throw UsageError("--page: a page shows the film of one scene; leave --join out");
    if (arguments.film.text && !is_slides)
        throw UsageError("--page: the page holds the words of the film; leave --words out");
    if (format.name != "mp4" && format.name != "webm")
        throw UsageError(
            fmt::format("--{}: browsers play MP4 and WebM, and not {}; give --format mp4 or webm",
                        is_slides ? "slides" : "page", upper_case(format.name)));
}

void refuse_film_options(const RenderArguments& arguments) {
    const bool changes = !arguments.destination.output.empty() ||
                         !arguments.destination.format.empty() || changes_film(arguments.film) ||
                         arguments.film.text || arguments.join || !arguments.max_size.empty() ||
                         !overrides_of(arguments).empty() || !arguments.destination.page.empty() ||
                         !arguments.destination.slides.empty() || !arguments.depfile.empty() ||
                         !arguments.cache.empty();
    if (changes)
        throw UsageError(
            "the chunks of a plan are drawn as it says; give what changes the film to carom plan, "
            "and -o and --words to carom join");
}

}  // namespace carom
