#include "media/vp9_settings.h"

#include <cassert>

namespace carom {

Vp9Settings vp9_settings(Quality quality) {
    // A constant quality, for the reasons that H.264 has a constant quantiser, and about the same
    // likeness. The realtime modes cost two to three times what x264 does; the other is only for
    // the final film.
    switch (quality) {
        case Quality::draft:
            return {"realtime", "8", "32"};
        case Quality::standard:
            return {"realtime", "5", "24"};
        case Quality::final_:
            return {"good", "3", "20"};
    }
    assert(false);
    return {};
}

}  // namespace carom
