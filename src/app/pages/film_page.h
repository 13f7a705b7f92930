// An HTML page that shows one film with its chapters, its transcript and its scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/output.h"
#include "figures/page.h"
#include "films/render.h"
#include "util/progress.h"

namespace carom {

struct Scene;

/// The template of a film page with this name. Throws SystemError.
Source document_template(const std::string& name);

/// A file that a page refers to: next to the page, or embedded in it.
struct PageFile {
    std::string name;     ///< the name under which it is saved; need not be UTF-8
    std::string inlined;  ///< a data URL that contains the file; empty: it is next to the page
};

/// The contents of a film page. The texts of the film are part of the page, because some browsers
/// do not load text tracks from files next to a local page.
struct FilmPage {
    const Scene& scene;
    const FilmText& text;
    PageFile film, poster, source;
    std::string site = {};   ///< title of the site to which the page belongs; empty: none
    std::string index = {};  ///< URL of the first page of that site
};

/// The values of the placeholders for a film, on a page of its own or among others.
PageFields film_fields(const FilmPage& content);

/// The page as UTF-8. `page` is the template. Throws SceneError if the template has a mistake.
std::string film_page(const Source& page, const FilmPage& content);

/// Upper limit for the bytes of a film embedded in a page. Not all browsers play larger ones:
/// Firefox accepts data URLs of up to 32 MiB.
inline constexpr double most_inlined_bytes = 24e6;

/// The poster of a film as PNG; `options` are those of its plan.
std::vector<std::uint8_t> drawn_poster(const FilmPlan& plan, const FilmOptions& options,
                                       Progress& progress);

/// Renders the film of a scene into a page of its own, which appears complete or not at all. If the
/// film exceeds `options.most_bytes`, nothing is written, and the function may be called again. The
/// report is about the film, but its path is that of the page. The ending of `options.output` gives
/// the format. Throws what render() throws.
RenderReport render_page(const Scene& scene, FilmOptions options, Output& page, Progress& progress);

}  // namespace carom
