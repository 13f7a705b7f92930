// A page in HTML that shows one film: with its chapters, its transcript and its scene.
#pragma once

#include <filesystem>
#include <string>

#include "app/film/render.h"
#include "app/output.h"
#include "app/progress.h"
#include "figures/page.h"
#include "scene/scene.h"

namespace carom {

/// The template of this name among those of pages of films. Throws SystemError.
Source document_template(const std::string& name);

/// Where a page finds a file: beside it, or in itself.
struct PageFile {
    std::string name;     ///< in UTF-8 or not; that under which it is saved
    std::string inlined;  ///< an address that contains it; empty: it is beside the page
};

/// What a page of a film shows. The words of the film are in the page itself, as some browsers
/// read no such file beside a page that comes from a folder.
struct FilmPage {
    const Scene& scene;
    const FilmText& text;
    PageFile film, poster, source;
    std::string site = {};   ///< the title of the site that it belongs to; empty: none
    std::string index = {};  ///< the address of that site's first page
};

/// The page as UTF-8. `page` is the template. Throws SceneError where that has a mistake.
std::string film_page(const Source& page, const FilmPage& its);

/// Bytes of a film beyond which not all browsers play it from inside a page: Firefox takes
/// addresses of 32 MiB.
inline constexpr double most_inlined_bytes = 24e6;

/// Renders the film of a scene into a page of its own, whole or not at all.
/// Of a film that does not fit it writes nothing, and may be called again. The report is
/// about the film, its path that of the page. The ending of `options.output` gives the format.
/// Throws as render() does.
RenderReport render_page(const Scene& scene, FilmOptions options, Output& page, Progress& progress);

}  // namespace carom
