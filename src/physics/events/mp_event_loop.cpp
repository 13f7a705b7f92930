// The event loops of multiprecision numbers, which spend their time in MPFR.
#include "physics/events/event_loop.h"
#include "physics/events/event_loop_steps.h"
#include "physics/multiprecision/multiprecision.h"

namespace carom {

template class EventLoop<1, Real>;
template class EventLoop<2, Real>;
template class EventLoop<3, Real>;
template class EventLoop<1, Real, true>;
template class EventLoop<2, Real, true>;
template class EventLoop<3, Real, true>;

}  // namespace carom
