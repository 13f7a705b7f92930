// The films of several scenes as one: each fades into its ground and the next one comes out of it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/film/render.h"
#include "draw/color.h"

namespace carom {

/// One of the films in a joined one.
struct JoinedPart {
    int first = 0;         ///< its first frame in the whole
    int frames = 0;        ///< of its own
    int fading = 0;        ///< frames at either end that fade, where something is before or after
    bool comes_in = true;  ///< out of `before`
    bool goes_out = true;  ///< into `ground`
    Color before = {}, ground = {};  ///< opaque
    Film film = {};                  ///< for pictures of its size
};

/// How much of a part's frame, counted from 0, its ground covers, from 0 to 1.
double cover_of(const JoinedPart& part, int frame);

/// What writes a part into the whole, which it refers to. It is not committed.
std::unique_ptr<FilmWriter> writer_of_part(FilmWriter& whole, const JoinedPart& part);

/// What a joined film begins with; without a title it begins with its first scene.
struct JoinedTitle {
    std::string title, words;
};

/// Of the card that it begins with: its length, and what it takes about in the format of
/// `options.output`. Both are 0 without a title.
double seconds_of_title(const JoinedTitle& title);
double bytes_of_title(const std::vector<Scene>& scenes, const JoinedTitle& title,
                      const FilmOptions& options);

/// Renders the films of several scenes, which have one size and rate, as one film, whole or not at
/// all: its title is its own or theirs, its chapters are their titles. One that does not fit is not
/// written. Throws as render() does.
RenderReport render_joined(const std::vector<Scene>& scenes, const JoinedTitle& title,
                           const FilmOptions& options, Progress& progress);

/// A card of a joined film: its title over its words.
void draw_title(Canvas& canvas, const Film& film, const JoinedTitle& title);

}  // namespace carom
