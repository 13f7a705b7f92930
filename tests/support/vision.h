// How colours look to viewers, under shorter names.
#pragma once

#include "draw/vision.h"

namespace carom::test {

using namespace vision;

}  // namespace carom::test
