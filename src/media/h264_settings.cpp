#include "media/h264_settings.h"

#include <cassert>

namespace carom {

H264Settings h264_settings(Quality quality) {
    // A constant quantiser: a gas film is alike from end to end, so that rate control would only
    // measure every frame once more, and give crowded films less quality than empty ones. Plain P
    // frames without look-ahead cost a third less time than B frames, and a third of the memory.
    switch (quality) {
        case Quality::draft:
            return {"ultrafast", "qp=25:8x8dct=1"};  // a film is High, which means 8x8 blocks
        case Quality::standard:
            return {"veryfast", "qp=24:bframes=0:weightp=0:rc-lookahead=0"};
        case Quality::final_:
            return {"medium",
                    "qp=20:bframes=2:b-pyramid=none:weightp=0:rc-lookahead=3:ref=2:subme=7:"
                    "psy-rd=0.4,0:deblock=1,1"};
    }
    assert(false);
    return {};
}

}  // namespace carom
