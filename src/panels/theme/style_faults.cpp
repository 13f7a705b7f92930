#include "panels/theme/style_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "draw/palette.h"
#include "draw/vision.h"
#include "panels/panel.h"
#include "scene/style/style.h"

namespace carom {
namespace {

class Faults {
  public:
    explicit Faults(const Style& style) : style_(style), theme_(theme_of(style.base, &style)) {}

    std::vector<Diagnostic> find() {
        // Colours of words are made legible where they are written, except for these.
        for (const auto& [key, color] : {std::pair{"ink", theme_.ink},
                                         {"second", theme_.second},
                                         {"muted", theme_.muted},
                                         {"highlight", theme_.highlight}})
            find_pale(key, color, {"words", least_contrast_of_words});
        const Least marks{"lines and areas", least_contrast_of_marks};
        for (const auto& [key, color] : {std::pair{"theory", theme_.accent},
                                         {"bar", theme_.bar},
                                         {"wall", theme_.wall},
                                         {"trail", theme_.trail}})
            find_pale(key, color, marks);
        for (std::size_t k = 0; k < given(); ++k) find_pale(series_key(k), theme_.series[k], marks);
        if (!theme_.ramp.empty()) {
            find_pale("slow", theme_.ramp.front(), marks);
            find_pale("fast", theme_.ramp.back(), marks);
            find_alike("slow", theme_.ramp.front(), "fast", theme_.ramp.back(),
                       vision::least_distance);
        }
        for (std::size_t k = 0; k < given(); ++k) {
            for (std::size_t i = 0; i < k; ++i)
                find_alike(series_key(k), theme_.series[k], series_key(i), theme_.series[i],
                           vision::least_distance_on_scale);
            find_alike(series_key(k), theme_.series[k], "theory", theme_.accent,
                       vision::least_distance_on_scale);
        }
        return std::move(found_);
    }

  private:
    struct Least {
        const char* what;
        double contrast;
    };

    std::size_t given() const { return style_.colors.series.size(); }
    static std::string series_key(std::size_t k) { return fmt::format("series.{}", k); }

    static std::string name_of(const std::string& key) {
        constexpr std::string_view series = "series.";
        return key.starts_with(series)
                   ? fmt::format("colour {} of `series`", std::stoul(key.substr(series.size())) + 1)
                   : "`" + key + "`";
    }

    // Adds a fault at the first of some keys that the style gives; none if it gives none of them.
    void add(const std::vector<std::string>& keys, std::string message, std::string hint) {
        for (const std::string& key : keys) {
            const auto place = style_.places.find(key);
            if (place == style_.places.end()) continue;
            Diagnostic fault = place->second;
            fault.message = std::move(message);
            fault.hint = std::move(hint);
            found_.push_back(std::move(fault));
            return;
        }
    }

    void find_pale(const std::string& key, Color color, const Least& least) {
        for (const auto& [name, behind] :
             {std::pair<std::string, Color>{"page", theme_.page}, {"ground", theme_.ground}}) {
            const double its = contrast(color, behind);
            if (its >= least.contrast) continue;
            const Color better =
                toward_ink(color, theme_, std::array{theme_.page, theme_.ground}, least.contrast);
            const bool is_better = contrast(better, theme_.page) >= least.contrast &&
                                   contrast(better, theme_.ground) >= least.contrast;
            // A colour that is not given may follow from the ink, or be the base's.
            add({key, name, "page", "ink"},
                fmt::format("the contrast of {} with `{}` is {:.2f}, and {} need {}", name_of(key),
                            name, its, least.what, least.contrast),
                is_better ? fmt::format("{} has enough", hex_of(better))
                          : fmt::format("take another `{}`, or another `ink`", name));
            return;
        }
    }

    void find_alike(const std::string& key, Color color, const std::string& other,
                    Color other_color, double least) {
        for (const vision::Vision& viewer : vision::visions) {
            const double apart = vision::distance(viewer, color, other_color);
            if (apart >= least) continue;
            const bool is_full = &viewer == vision::visions.data();
            add({key, other},
                fmt::format(
                    "{} and {} look alike{}: they differ by {:.2g} (CIEDE2000), and {:g} "
                    "{}",
                    name_of(key), name_of(other),
                    is_full ? "" : fmt::format(" to viewers with {}", viewer.name), apart, least,
                    least < vision::least_distance ? "is seen at a glance" : "is seen from afar"),
                "make one of them lighter or darker");
            return;
        }
    }

    const Style& style_;
    const Theme& theme_;
    std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> faults_of(const Style& style) { return Faults(style).find(); }

}  // namespace carom
