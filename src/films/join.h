// Joins the films of several scenes into one: each film fades out to its background colour, from
// which the next one fades in.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "draw/color.h"
#include "films/render.h"

namespace carom {

/// One of the films that make up a joined film.
struct JoinedPart {
    int first = 0;                   ///< index of its first frame in the joined film
    int frames = 0;                  ///< number of its frames
    int fading = 0;                  ///< frames that fade at each end next to another part
    bool comes_in = true;            ///< fades in, from the colour `before`
    bool goes_out = true;            ///< fades out, to the colour `ground`
    Color before = {}, ground = {};  ///< opaque
    Film film = {};                  ///< gives the size of its pictures
};

/// The opacity, from 0 to 1, with which the background covers frame `frame` (counted from 0) of a
/// part.
double cover_of(const JoinedPart& part, int frame);

/// A writer that adds a part to the joined film `whole`, which must outlive it. Its commit() does
/// nothing.
std::unique_ptr<FilmWriter> writer_of_part(FilmWriter& whole, const JoinedPart& part);

/// The text of the title card with which a joined film begins. With an empty title there is no
/// card.
struct JoinedTitle {
    std::string title, words;
};

/// The length of the title card in seconds, and its approximate bytes in the format of
/// `options.output`. Both are 0 without a title.
double seconds_of_title(const JoinedTitle& title);
double bytes_of_title(const std::vector<Scene>& scenes, const JoinedTitle& title,
                      const FilmOptions& options);

/// Renders the films of several scenes, which must have the same size and frame rate, as one film
/// that appears complete or not at all. Its title is that of the title card, or else lists the
/// scenes' titles, which are also the titles of its chapters. A film that exceeds
/// `options.most_bytes` is not written. Throws what render() throws.
RenderReport render_joined(const std::vector<Scene>& scenes, const JoinedTitle& title,
                           const FilmOptions& options, Progress& progress);

/// Draws the title card of a joined film: the title, with its words below.
void draw_title(Canvas& canvas, const Film& film, const JoinedTitle& title);

}  // namespace carom
