// Serialisation with an Archive of the plain value types of drawing and of scenes; those of physics
// are in physics/archived.h.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "draw/geometry.h"
#include "physics/archived.h"
#include "scene/time/timeline.h"
#include "util/archive.h"

namespace carom {

/// A constant value that may have several owners; may be null.
template <class T>
void archive_parts(Archive& archive, std::shared_ptr<const T>& pointer) {
    std::optional<T> value;
    if (pointer) value = *pointer;
    archive(value);
    if (archive.is_reading())
        pointer = value ? std::make_shared<const T>(*std::move(value)) : nullptr;
}

inline void archive_parts(Archive& archive, Point& point) { archive(point.x, point.y); }

inline void archive_parts(Archive& archive, Tick& tick) {
    archive(tick.frame, tick.time, tick.phase, tick.progress, tick.slow.factor, tick.slow.share,
            tick.reversals, tick.seconds);
}

}  // namespace carom
