// Numbers in words: read in the course of the run that they are of, and filled into the words.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "panels/meters/instruments.h"
#include "physics/units/number_text.h"
#include "scene/keys/numbers_in_words.h"

namespace carom {

struct FigureSpec;
struct Scene;

/// A number for which words ask, and the simulated time of which it is.
struct WordRequest {
    std::size_t number;  ///< of Scene::numbers
    double at;
};

/// What the words of the film of a scene ask for: its captions, callouts, end card and the texts of
/// its panels, each at the time at which it appears.
std::vector<WordRequest> requests_of_film(const Scene& scene);

/// What the words of a figure ask for, at its time, except of what it shows itself.
std::vector<WordRequest> requests_of_figure(const Scene& scene, const FigureSpec& figure);

/// Reads what is requested in the course of a run. Not safe to use from several threads.
class WordNumbers {
  public:
    /// What the context refers to must outlive the object.
    WordNumbers(const PanelContext& context, std::vector<WordRequest> requests);

    bool need_collisions() const { return instruments_.need_collisions(); }

    /// Takes the next moment of the run: a sample, a frame or both.
    void see(const FrameInput& input);

    /// The texts of all numbers of the scene, in order: each as it was at the first moment at or
    /// after its time; empty if it is not requested. Throws SceneError if one has no value then.
    std::vector<std::string> texts() const;

  private:
    const Scene& scene_;
    std::vector<WordRequest> requests_;
    std::vector<std::size_t> instrument_ = {};   ///< of each request
    std::vector<PanelSpec> specs_;               ///< each once
    std::vector<std::optional<double>> values_;  ///< of each request that has been read
    Instruments instruments_;
};

/// The scene with the texts of WordNumbers in the words of its film.
Scene with_numbers(Scene scene, const std::vector<std::string>& texts);

/// The same with numbers of usual length, before they are known.
Scene with_usual_numbers(Scene scene);

/// A number as words show it: with three digits, or with as many as are asked for.
std::string number_words(const Wording& wording, const NumberInWords& number,
                         const Quantity& quantity, double value);

}  // namespace carom
