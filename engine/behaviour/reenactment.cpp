#include "continua/behaviour/reenactment.h"

namespace continua {

ActEnd Reenactment::act(const Term& program, SimTime t) {
  performer_.begin(performance_, {++acts_, program, {}});
  for (;;) {
    const auto event = performer_.next(performance_, body_.snapshot());
    if (!event) {
      for (const auto& report : body_.advance(t).acts) performer_.reported(performance_, report);
      continue;
    }
    if (const auto* step = std::get_if<ActStep>(&*event); step && step->command) body_.command(*step->command);
    if (const auto* end = std::get_if<ActEnd>(&*event); end && end->act.number == acts_) return *end;
  }
}

}  // namespace continua
