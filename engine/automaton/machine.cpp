#include "automaton/machine.h"

#include <algorithm>

namespace continua {

Term empty_value(const Type& type) {
  return type.kind() == Type::Kind::list ? Term::list({}, type.element()) : Term::null();
}

bool Machine::knows_input(std::string_view symbol) const {
  return std::any_of(transitions.begin(), transitions.end(),
                     [&](const Transition& transition) { return transition.on && transition.on->contains(symbol); });
}

}  // namespace continua
