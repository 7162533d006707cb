#include "continua/body/capability.h"

#include <algorithm>
#include <array>

namespace continua {

namespace {

struct Row {
  Capability what;
  std::string_view name;
  ActEffect effect;
  ToGoal to_goal;
};

// In the order of the enumeration.
constexpr std::array acts = {
    Row{Capability::reach, "reach", ActEffect::shown, ToGoal::none},
    Row{Capability::point, "point", ActEffect::shown, ToGoal::none},
    Row{Capability::look, "look", ActEffect::announced, ToGoal::none},
    Row{Capability::grasp, "grasp", ActEffect::held, ToGoal::none},
    Row{Capability::lift, "lift", ActEffect::moved, ToGoal::none},
    Row{Capability::put, "put", ActEffect::moved, ToGoal::carried},
    Row{Capability::slide, "slide", ActEffect::moved, ToGoal::carried},
    Row{Capability::move, "move", ActEffect::moved, ToGoal::carried},
    Row{Capability::push, "push", ActEffect::moved, ToGoal::pushed},
    Row{Capability::turn, "turn", ActEffect::moved, ToGoal::none},
    Row{Capability::ungrasp, "ungrasp", ActEffect::hand, ToGoal::none},
    Row{Capability::retract, "retract", ActEffect::hand, ToGoal::none},
    Row{Capability::stop, "stop", ActEffect::hand, ToGoal::none},
    Row{Capability::signal, "signal", ActEffect::announced, ToGoal::none},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < acts.size(); ++i)
    if (static_cast<std::size_t>(acts[i].what) != i) return false;
  return true;
}
static_assert(in_order(), "a row is found by its capability");

constexpr std::array programs = {
    BodyProgram{"grasp", Capability::grasp, Takes::thing},
    BodyProgram{"hold", Capability::grasp, Takes::thing},
    BodyProgram{"lift", Capability::lift, Takes::thing},
    BodyProgram{"ungrasp", Capability::ungrasp, Takes::thing},
    BodyProgram{"put", Capability::put, Takes::thing_and_goal},
    BodyProgram{"move", Capability::move, Takes::thing_and_goal},
    BodyProgram{"slide", Capability::slide, Takes::thing_and_goal},
    BodyProgram{"push", Capability::push, Takes::thing_and_goal},
    BodyProgram{"turn", Capability::turn, Takes::thing},
    BodyProgram{"turn_by", Capability::turn, Takes::thing_and_angle},
    BodyProgram{"retract", Capability::retract, Takes::nothing},
    BodyProgram{"stop", Capability::stop, Takes::nothing},
    BodyProgram{"reach", Capability::reach, Takes::thing_or_place},
    BodyProgram{"look_at", Capability::look, Takes::thing_or_place},
    BodyProgram{"point", Capability::point, Takes::last_is_thing_or_place},
};

const Row& row_of(Capability what) { return acts[static_cast<std::size_t>(what)]; }

}  // namespace

std::string name_of(Capability what) { return std::string(row_of(what).name); }
ActEffect effect_of(Capability what) { return row_of(what).effect; }
ToGoal to_goal(Capability what) { return row_of(what).to_goal; }

const BodyProgram* body_program(std::string_view name) {
  const auto found =
      std::find_if(programs.begin(), programs.end(), [&](const BodyProgram& program) { return program.name == name; });
  return found == programs.end() ? nullptr : &*found;
}

std::size_t most_arguments(const BodyProgram& program) {
  if (program.takes == Takes::nothing) return 0;
  return program.takes == Takes::thing || program.takes == Takes::thing_or_place ? 1 : 2;
}

}  // namespace continua
