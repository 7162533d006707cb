#include "continua/facts/affordances.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "continua/body/capability.h"
#include "continua/world/relations.h"

namespace continua {
namespace {

using Code = ReasonCode;
using Kind = Expression::Kind;

// Bounds on the steps of a program: the depth of programs in programs, and the number of events.
constexpr int deepest = 10;
constexpr std::size_t most_events = 1000;

// Whether the body itself moves an object to another place or attitude by that program.
bool moves_something(std::string_view program) {
  const auto* known = body_program(program);
  return known && effect_of(known->what) == ActEffect::moved;
}

bool takes_part(const Expression& call) {
  return std::any_of(call.arguments.begin(), call.arguments.end(),
                     [](const Expression& argument) { return argument.kind == Kind::component; });
}

bool names(const Expression& event, std::string_view what) {
  if (event.kind == Kind::call && event.name == what && takes_part(event)) return true;
  return std::any_of(event.arguments.begin(), event.arguments.end(),
                     [&](const Expression& part) { return names(part, what); });
}

std::string without_spaces(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

// Documents write both Concave and concave.
bool is_concave(const Voxeme& voxeme) { return voxeme.concavity.name.ends_with("oncave"); }

// Whether a habitat is the upright one: Y of the object upward, and its top not below.
bool is_upright(const Voxeme& voxeme, const std::string& habitat) {
  bool up = false, top_down = false;
  for (const auto* clauses : {&voxeme.intrinsic, &voxeme.extrinsic})
    for (const auto& clause : *clauses) {
      if (clause.name.number != habitat) continue;
      up = up || without_spaces(clause.value) == "align(Y,E_y)";
      top_down = top_down || without_spaces(clause.value) == "top(-Y)";
    }
  return up && !top_down;
}

// Whether a habitat holds. Only one kind can be tested: a hollow object that stands upright has an interior in the
// snapshot. All other habitats are taken to hold.
bool holds(const Voxeme& voxeme, const std::string& habitat, const ObjectState& object) {
  const bool told = !habitat.empty() && is_concave(voxeme) && is_upright(voxeme, habitat);
  return !told || object.interior.has_value();
}

// The part of an event's argument that matters here: an object, or a relation to objects.
struct Argument {
  std::string object;
  std::string relation;
  std::vector<std::string> landmarks;
  bool agent = false;
};
struct Event {
  std::string program;
  std::vector<Argument> arguments;
};

Argument argument_of(const Term& term) {
  Argument argument;
  const auto [head, arguments] = term.spine();
  if (head.kind() != Term::Kind::constant) return argument;
  if (arguments.empty()) {
    argument.object = head.name();
    return argument;
  }
  argument.relation = head.name();
  for (const auto& each : arguments)
    if (each.kind() == Term::Kind::constant) argument.landmarks.push_back(each.name());
  return argument;
}

using Bound = std::map<std::string, Argument>;

Argument argument_of(const Expression& expression, const Bound& bound) {
  if (expression.kind == Kind::name) {
    const auto found = bound.find(expression.name);
    return found == bound.end() ? Argument{} : found->second;
  }
  if (expression.kind != Kind::call) return {};
  Argument argument;
  argument.relation = expression.name;
  for (const auto& each : expression.arguments)
    if (auto inner = argument_of(each, bound); !inner.object.empty()) argument.landmarks.push_back(inner.object);
  return argument;
}

class Steps {
 public:
  explicit Steps(const Catalogue& catalogue) : catalogue_(catalogue) {}

  // Adds the event, then the events that it consists of, down to those of the body itself.
  void add(Event event, int depth = 0) {
    if (events.size() >= most_events) return;
    const auto* voxeme = catalogue_.find(Voxeme::Entity::program, event.program);
    events.push_back(std::move(event));
    if (!voxeme || depth == deepest) return;
    const Event whole = events.back();
    const auto bound = bound_by(*voxeme, whole);
    for (const auto& step : voxeme->body) {
      if (step.event.kind != Kind::call || step.event.name == whole.program) continue;
      Event part{step.event.name, {}};
      for (const auto& each : step.event.arguments)
        if (auto argument = argument_of(each, bound); !argument.agent) part.arguments.push_back(std::move(argument));
      add(std::move(part), depth + 1);
    }
  }

  std::vector<Event> events;

 private:
  // The values of the program's variables. The first variable, the agent, is not an argument of a command.
  static Bound bound_by(const Voxeme& program, const Event& event) {
    Bound bound;
    std::size_t next = 0;
    for (const auto& variable : program.arguments) {
      if (variable.type == "agent")
        bound[variable.name].agent = true;
      else if (next < event.arguments.size())
        bound[variable.name] = event.arguments[next++];
    }
    return bound;
  }

  const Catalogue& catalogue_;
};

class Obstacles {
 public:
  Obstacles(const WorldSnapshot& world, const Catalogue& catalogue) : world_(world), catalogue_(catalogue) {}

  Code of(const Event& event) const {
    const auto thing = std::find_if(event.arguments.begin(), event.arguments.end(),
                                    [&](const Argument& argument) { return world_.find(argument.object); });
    const auto* object = thing == event.arguments.end() ? nullptr : world_.find(thing->object);
    if (object && event.program == "grasp" && refuses(*object, "grasp") && refuses(*object, "lift"))
      return Code::no_grasp;
    if (object && moves_something(event.program)) {
      const auto* voxeme = voxeme_of(*object, catalogue_);
      if (voxeme && !voxeme->movable) return Code::immovable;
    }
    for (const auto& argument : event.arguments)
      if (const auto reason = of_place(argument, object); reason != Code::none) return reason;
    return Code::none;
  }

 private:
  bool refuses(const ObjectState& object, std::string_view what) const {
    return affords(object, catalogue_, what) == false;
  }

  Code of_place(const Argument& place, const ObjectState* object) const {
    const auto relation = relation_named(place.relation);
    if (relation != Relation::in && relation != Relation::on) return Code::none;
    for (const auto& name : place.landmarks) {
      const auto* landmark = world_.find(name);
      if (!landmark) continue;
      if (landmark == object) return Code::itself;
      if (!refuses(*landmark, place.relation)) continue;
      const auto& affordances = voxeme_of(*landmark, catalogue_)->affordances;
      if (std::any_of(affordances.begin(), affordances.end(),
                      [&](const Affordance& each) { return names(each.event, place.relation); }))
        return Code::wrong_habitat;
      return relation == Relation::in ? Code::no_containment : Code::no_support;
    }
    return Code::none;
  }

  const WorldSnapshot& world_;
  const Catalogue& catalogue_;
};

// Whether the program grips a thing by a part at which its voxeme affords no grasp.
bool lacks_part(std::string_view program, const std::vector<Term>& arguments, const WorldSnapshot& world,
                const Catalogue& catalogue) {
  const auto* known = body_program(program);
  if (!known || known->takes != Takes::thing_and_grip || arguments.size() < 2) return false;
  const auto& part = arguments[1];
  if (part.kind() != Term::Kind::text || part.text_value().empty()) return false;
  const auto* object = arguments[0].kind() == Term::Kind::constant ? world.find(arguments[0].name()) : nullptr;
  const auto* voxeme = object ? voxeme_of(*object, catalogue) : nullptr;
  if (!voxeme) return false;
  const auto parts = grasp_parts(*voxeme);
  return std::find(parts.begin(), parts.end(), part.text_value()) == parts.end();
}

}  // namespace

const Voxeme* voxeme_of(const ObjectState& object, const Catalogue& catalogue) {
  const auto type = object.attributes.find("type");
  return catalogue.for_object(object.name, type == object.attributes.end() ? "" : type->second);
}

std::optional<bool> affords(const ObjectState& object, const Catalogue& catalogue, std::string_view what) {
  const auto* voxeme = voxeme_of(object, catalogue);
  if (!voxeme) return std::nullopt;
  return std::any_of(voxeme->affordances.begin(), voxeme->affordances.end(), [&](const Affordance& affordance) {
    return names(affordance.event, what) && holds(*voxeme, affordance.habitat, object);
  });
}

std::vector<std::string> grasp_parts(const Voxeme& voxeme) {
  std::vector<std::string> parts;
  for (const auto& affordance : voxeme.affordances) {
    if (affordance.event.name != "grasp") continue;
    for (const auto& argument : affordance.event.arguments)
      for (const auto& component : voxeme.components)
        if (argument.kind == Kind::component && argument.name == component.number && !component.number.empty())
          parts.push_back(component.name);
  }
  return parts;
}

ReasonCode obstacle(const Term& program, const WorldSnapshot& world, const Catalogue& catalogue) {
  const auto [head, arguments] = program.spine();
  if (head.kind() != Term::Kind::constant) return Code::none;
  if (lacks_part(head.name(), arguments, world, catalogue)) return Code::no_such_hold;
  Event event{head.name(), {}};
  for (const auto& each : arguments) event.arguments.push_back(argument_of(each));
  Steps steps(catalogue);
  steps.add(std::move(event));
  const Obstacles obstacles(world, catalogue);
  for (const auto& each : steps.events)
    if (const auto reason = obstacles.of(each); reason != Code::none) return reason;
  return Code::none;
}

}  // namespace continua
