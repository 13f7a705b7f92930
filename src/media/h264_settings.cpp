#include "media/h264_settings.h"

#include <cassert>

namespace carom {

H264Settings h264_settings(Quality quality) {
    switch (quality) {
        case Quality::draft:
            return {"ultrafast", "crf=23:8x8dct=1"};
        case Quality::standard:
            return {"veryfast", "crf=20"};
        case Quality::final_:
            return {"slow", "crf=17"};
    }
    assert(false);
    return {};
}

}  // namespace carom
