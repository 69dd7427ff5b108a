// The only place that instantiates World from its parts (*.ipp).

#include "world/ask_laws.ipp"
#include "world/assemble.ipp"
#include "world/detect.ipp"
#include "world/rebound.ipp"
#include "world/step.ipp"
#include "world/world.ipp"

namespace flyrock {

template class World<2>;
template class World<3>;

}  // namespace flyrock
