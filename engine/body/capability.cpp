#include "continua/body/capability.h"

#include <algorithm>

namespace continua {

namespace {

constexpr bool capabilities_in_order() {
  for (std::size_t i = 0; i < body_acts.size(); ++i)
    if (static_cast<std::size_t>(body_acts[i].what) != i) return false;
  return true;
}
static_assert(capabilities_in_order(), "a row is found by its capability");

}  // namespace

const BodyProgram* body_program(std::string_view name) {
  const auto found = std::find_if(body_programs.begin(), body_programs.end(),
                                  [&](const BodyProgram& program) { return program.name == name; });
  return found == body_programs.end() ? nullptr : &*found;
}

std::size_t most_arguments(const BodyProgram& program) {
  if (program.takes == Takes::nothing) return 0;
  if (program.takes == Takes::thing_and_grip) return 3;
  return program.takes == Takes::thing || program.takes == Takes::thing_or_place ? 1 : 2;
}

}  // namespace continua
