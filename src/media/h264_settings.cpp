#include "media/h264_settings.h"

#include <cassert>

namespace carom {

H264Settings h264_settings(Quality quality) {
    // Frames of the same few flat colours, half of them still: plain P frames cost a third less
    // time than B frames with look-ahead, and a third of the memory. Without adaptive quantisation
    // bits go to edges and type instead of to flat ground.
    switch (quality) {
        case Quality::draft:
            return {"ultrafast", "crf=23:8x8dct=1"};  // a film is High, which means 8x8 blocks
        case Quality::standard:
            return {"veryfast", "crf=22:aq-mode=0:bframes=0:weightp=0:no-mbtree=1:rc-lookahead=0"};
        case Quality::final_:
            return {"medium",
                    "crf=18:aq-mode=0:bframes=2:b-pyramid=none:weightp=0:no-mbtree=1:"
                    "rc-lookahead=3:ref=2:subme=7:psy-rd=0.4,0:deblock=1,1"};
    }
    assert(false);
    return {};
}

}  // namespace carom
