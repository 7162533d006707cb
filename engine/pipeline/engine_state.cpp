#include "continua/pipeline/engine_state.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace continua {

bool EngineState::waits(int serial) const {
  return fusion.waits(serial) || std::any_of(complete.begin(), complete.end(),
                                             [&](const Ensemble& one) { return one.percept.serial <= serial; });
}

void Tick::then(Tick next) {
  after = std::move(next.after);
  events.insert(events.end(), std::make_move_iterator(next.events.begin()), std::make_move_iterator(next.events.end()));
}

}  // namespace continua
