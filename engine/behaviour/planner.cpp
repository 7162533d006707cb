#include "continua/behaviour/planner.h"

#include <algorithm>
#include <array>
#include <optional>

#include "continua/core/angles.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

// Rise of a lifted object: clear of its neighbours, and low enough for the arm everywhere on the table.
constexpr double lift_height_m = 0.1;

Vec3 center(const Place& place) {
  return (Vec3(place.min[0], place.min[1], place.min[2]) + Vec3(place.max[0], place.max[1], place.max[2])) / 2;
}

std::optional<Goal> goal_of(const Term& term, Perspective perspective) {
  const auto [head, arguments] = term.spine();
  const auto relation = head.kind() == Term::Kind::constant ? relation_named(head.name()) : std::nullopt;
  if (relation && arguments.size() == landmarks_of(*relation) &&
      std::all_of(arguments.begin(), arguments.end(), is_thing)) {
    Goal goal{relation, {}, perspective};
    for (const auto& landmark : arguments) goal.landmarks.push_back(landmark.name());
    return goal;
  }
  if (const Term* place = first_place(term)) return Goal{{}, {}, perspective, center(place->place_value())};
  return std::nullopt;
}

OrReason<AvatarCommand> planned_grip(AvatarCommand command, const std::vector<Term>& arguments, const Term& program) {
  const auto is_text = [](const Term& term) { return term.kind() == Term::Kind::text; };
  const bool right = arguments.size() == 3 && is_thing(arguments[0]) && is_text(arguments[1]) && is_text(arguments[2]);
  const auto approach = right ? value_in(approach_names, arguments[2].text_value()) : std::nullopt;
  if (!approach) return Reason{ReasonCode::incomplete, {}, {print(program)}};
  command.object = arguments[0].name();
  command.approach = *approach;
  command.only_parts = !arguments[1].text_value().empty();
  if (command.only_parts) command.parts = {arguments[1].text_value()};
  return command;
}

}  // namespace

OrReason<AvatarCommand> plan(const Term& program, bool gesture, Perspective perspective) {
  AvatarCommand command;
  const auto [head, arguments] = program.spine();
  const auto* known = head.kind() == Term::Kind::constant ? body_program(head.name()) : nullptr;
  if (!known) {
    if (!gesture) return Reason{ReasonCode::unknown_program, {}, {print(program)}};
    command.name = program.kind() == Term::Kind::text ? program.text_value() : print(program);
    return command;
  }
  command.what = known->what;
  const auto wrong = [&] { return Reason{ReasonCode::incomplete, {}, {print(program)}}; };
  // The agent and the pointing hand may be left out.
  const std::size_t least = known->takes == Takes::last_is_thing_or_place ? 1 : most_arguments(*known);
  if (arguments.size() < least || arguments.size() > most_arguments(*known)) return wrong();
  if (known->takes == Takes::nothing) return command;
  if (known->takes == Takes::thing_and_angle) {
    if (!is_thing(arguments[0]) || arguments[1].kind() != Term::Kind::number) return wrong();
    command.object = arguments[0].name();
    command.turn_rad = rad_per_deg * arguments[1].number_value();
    return command;
  }
  if (known->takes == Takes::thing_and_grip) return planned_grip(std::move(command), arguments, program);
  if (known->takes == Takes::thing || known->takes == Takes::thing_and_goal) {
    if (!is_thing(arguments[0])) return wrong();
    command.object = arguments[0].name();
    if (known->what == Capability::lift) command.height_m = lift_height_m;
    if (known->what == Capability::turn) command.turn_rad = quarter_turn;
  } else if (is_thing(arguments.back())) {
    command.object = arguments.back().name();
    return command;
  }
  if (known->takes != Takes::thing) {
    const auto goal = goal_of(arguments.back(), perspective);
    if (!goal) return wrong();
    command.goal = *goal;
  }
  return command;
}

std::optional<std::size_t> most_arguments(std::string_view program) {
  const auto* known = body_program(program);
  return known ? std::optional(most_arguments(*known)) : std::nullopt;
}

}  // namespace continua
