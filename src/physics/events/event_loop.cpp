#include "physics/events/event_loop.h"

#include "physics/events/event_loop_steps.h"

namespace carom {

template class EventLoop<1>;
template class EventLoop<2>;
template class EventLoop<3>;
template class EventLoop<1, double, true>;
template class EventLoop<2, double, true>;
template class EventLoop<3, double, true>;

}  // namespace carom
