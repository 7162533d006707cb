#include "continua/behaviour/performance_turn.h"

#include <algorithm>
#include <utility>

#include "continua/behaviour/planner.h"
#include "continua/behaviour/preconditions.h"
#include "continua/body/placement.h"
#include "continua/facts/affordances.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

using Code = ReasonCode;
using Status = ActStatus;
using Kind = Expression::Kind;

// Depth of programs in programs, and subevents of an act: bounds against endless programs.
constexpr std::size_t deepest = 16;
constexpr int most_subevents = 1000;
// Labels and arguments may be built from each other and grow without end; no useful program is so large.
constexpr std::size_t largest_term = 200;

bool is_call(const Expression& expression, std::string_view name, std::size_t arguments) {
  return expression.kind == Kind::call && expression.name == name && expression.arguments.size() == arguments;
}

// The goal of a loop: the at(y,z) of the first !at(y,z) in its condition.
const Expression* goal_of_loop(const Expression& condition) {
  if (condition.kind == Kind::negation && condition.arguments.size() == 1 && is_call(condition.arguments[0], "at", 2))
    return &condition.arguments[0];
  for (const auto& each : condition.arguments)
    if (const auto* found = condition.kind == Kind::both ? goal_of_loop(each) : nullptr) return found;
  return nullptr;
}

std::string name_of(const Term& program) {
  const auto [head, arguments] = program.spine();
  return head.kind() == Term::Kind::constant ? head.name() : std::string();
}

const Voxeme* voxeme_of(const ObjectState& object, const Catalogue* catalogue) {
  if (!catalogue) return nullptr;
  const auto type = object.attributes.find("type");
  return catalogue->for_object(object.name, type == object.attributes.end() ? std::string() : type->second);
}

// A turn of a loop was in vain if all things are where they were. Less than the distance of touch is no movement.
bool same_places(const std::map<std::string, Vec3>& before, const std::map<std::string, Vec3>& now) {
  return std::all_of(now.begin(), now.end(), [&](const auto& one) {
    const auto found = before.find(one.first);
    return found != before.end() && (found->second - one.second).norm() <= contact_m;
  });
}

}  // namespace

std::map<std::string, Vec3> places_of(const WorldSnapshot& world) {
  std::map<std::string, Vec3> places;
  for (const auto& object : world.objects) places[object.name] = object.p_WO;
  return places;
}

void PerformanceTurn::fail(Reason reason) {
  act_.end.status = status_of(reason.code);
  act_.end.reason = std::move(reason);
  act_.ending = true;
}

void PerformanceTurn::begin(const EarlierPlaces& earlier) { perform(resolved(act_.end.act.program, earlier), false); }

// Replaces was(cup), originally(cup) and loc(cup) by places in any program. An object that was never moved is where it
// was.
Term PerformanceTurn::resolved(const Term& term, const EarlierPlaces& earlier) const {
  if (term.kind() != Term::Kind::apply) return term;
  const auto [head, arguments] = term.spine();
  const auto name = name_of(term);
  if ((name == "was" || name == "originally" || name == "loc") && arguments.size() == 1 && is_thing(arguments[0])) {
    const auto& thing = arguments[0].name();
    const auto& places = name == "was" ? earlier.was : earlier.originally;
    if (const auto found = places.find(thing); name != "loc" && found != places.end()) return found->second;
    if (const auto* object = world().find(thing)) return place_term(*object, world());
    return term;
  }
  Term whole = head;
  for (const auto& each : arguments) whole = Term::apply(whole, resolved(each, earlier));
  return whole;
}

// A side of the thing itself is one step in that direction; the step's end becomes a point, since the thing moves away
// from the side. A term with a point that is no relation, as part('left', 'front', <0.1, 0, 0>), becomes that point.
Term PerformanceTurn::fixed_place(const Term& thing, const Term& place) const {
  const auto [head, landmarks] = place.spine();
  const bool is_relation = head.kind() == Term::Kind::constant && relation_named(head.name());
  const Term* point = place.kind() == Term::Kind::apply && !is_relation ? first_place(place) : nullptr;
  if (point) return *point;
  if (std::find(landmarks.begin(), landmarks.end(), thing) == landmarks.end()) return place;
  const auto move = plan(Term::apply(Term::apply(Term::constant("move", Type::term()), thing), place), false,
                         circumstances_.perspective());
  if (!move || missing_thing(*move, world())) return place;
  const auto there = placement(*move, world(), Occupied::avoided);
  return there ? Term::point(there->p_WO.x(), there->p_WO.y(), world().table.max.z()) : place;
}

// Values of the program's arguments. Surplus arguments of calls in documents are dropped.
std::optional<Bindings> PerformanceTurn::bind(const Voxeme& voxeme, const Term& program, bool documented) {
  auto arguments = program.spine().arguments;
  const auto& wanted = voxeme.arguments;
  const auto agent =
      std::find_if(wanted.begin(), wanted.end(), [](const auto& argument) { return argument.type == "agent"; });
  if (agent != wanted.end()) {
    const auto place = static_cast<std::size_t>(agent - wanted.begin());
    const bool named = place < arguments.size() && is_thing(arguments[place]) &&
                       participant_named(arguments[place].name()).has_value();
    const bool lacks_one = arguments.size() + 1 == wanted.size();
    if (place <= arguments.size() && (lacks_one || !named)) arguments.insert(arguments.begin() + place, agent_term());
  }
  if (documented && arguments.size() > wanted.size()) arguments.resize(wanted.size());
  if (arguments.size() != wanted.size()) {
    fail({Code::incomplete, {}, {print(program)}});
    return std::nullopt;
  }
  const auto theme = std::find_if(arguments.begin(), arguments.end(), [&](const Term& argument) {
    return is_thing(argument) && world().find(argument.name());
  });
  Bindings bindings;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    bindings[wanted[i].name] = theme == arguments.end() ? arguments[i] : fixed_place(*theme, arguments[i]);
  return bindings;
}

const Term* PerformanceTurn::there_already(const Voxeme& voxeme, const Bindings& bindings) const {
  for (const auto& subevent : voxeme.body) {
    const auto* goal = subevent.when == Subevent::When::during ? goal_of_loop(subevent.condition) : nullptr;
    if (!goal || goal->arguments[0].kind != Kind::name) continue;
    const auto thing = bindings.find(goal->arguments[0].name);
    if (thing == bindings.end() || !is_thing(thing->second) || thing->second.name() == world().held) continue;
    if (circumstances_.hold(*goal, bindings) == true) return &thing->second;
  }
  return nullptr;
}

void PerformanceTurn::push(Frame frame) {
  if (act_.frames.size() >= deepest) return fail({Code::too_deep, {}, {print(frame.program), std::to_string(deepest)}});
  act_.frames.push_back(std::move(frame));
}

// `documented`: the program is a subevent of a document.
void PerformanceTurn::perform(const Term& program, bool documented) {
  const auto name = name_of(program);
  const bool own = !act_.frames.empty() && !name.empty() && name_of(act_.frames.back().program) == name;
  const auto* voxeme = own || name.empty() || !catalogue_ ? nullptr : catalogue_->find(Voxeme::Entity::program, name);
  // The body does an assignment as a whole: it extends the finger, and whoever looks on names what the vector meets.
  const bool whole = !voxeme || voxeme->body.empty() || voxeme->head.name == "assignment";
  if (whole) return push({of_body(program, documented), true, {}, {}});
  const auto bindings = bind(*voxeme, program, documented);
  if (!bindings) return;
  if (const auto* thing = there_already(*voxeme, *bindings)) {
    if (!documented) act_.end.reason = {Code::there_already, {thing->name()}};
    return;
  }
  push({program, false, voxeme->body, *bindings});
}

// The program as the body takes it: without the agent, and in subevents without surplus arguments.
Term PerformanceTurn::of_body(const Term& program, bool documented) const {
  auto [head, arguments] = program.spine();
  const auto most = most_arguments(name_of(program));
  if (!most || arguments.size() <= *most) return program;
  if (arguments[0] == agent_term()) arguments.erase(arguments.begin());
  if (documented && arguments.size() > *most) arguments.resize(*most);
  const bool has_place = arguments.size() == 2 && is_thing(arguments[0]);
  Term whole = head;
  for (std::size_t i = 0; i < arguments.size(); ++i)
    whole = Term::apply(whole, has_place && i == 1 ? fixed_place(arguments[0], arguments[1]) : arguments[i]);
  return whole;
}

std::optional<bool> PerformanceTurn::decided(const Expression& condition, const Bindings& bindings) {
  const auto holds = circumstances_.hold(condition, bindings);
  if (!holds) fail({Code::undecided, {}, {print(condition)}});
  return holds;
}

// The event of a loop without one: the body carries the thing to the place.
Expression PerformanceTurn::event_of(const Subevent& subevent) const {
  const bool is_empty = subevent.event.kind == Kind::name && subevent.event.name.empty();
  const auto* goal = subevent.when == Subevent::When::during && is_empty ? goal_of_loop(subevent.condition) : nullptr;
  return goal ? Expression{Kind::call, "move", goal->arguments} : subevent.event;
}

void PerformanceTurn::define(const Expression& event) {
  const auto& label = event.arguments[1];
  const bool is_label = is_call(label, "as", 1) && label.arguments[0].arguments.empty();
  Term value = circumstances_.value(event.arguments[0], act_.frames.back().bindings);
  if (!is_label || value.is_null() || value.size() > largest_term)
    return fail({Code::defines_nothing, {}, {print(event)}});
  act_.frames.back().bindings[label.arguments[0].name] = std::move(value);
}

void PerformanceTurn::repeat(const Expression& event) {
  const auto& count = event.arguments[0].name;
  const bool is_count = !count.empty() && count.size() <= 6 &&
                        std::all_of(count.begin(), count.end(), [](char c) { return c >= '0' && c <= '9'; });
  const auto& repeated = event.arguments[1];
  auto subevent = repeated.kind == Kind::text ? parse_subevent(repeated.name)
                                              : Result<Subevent>(Subevent{Subevent::When::always, {}, repeated});
  if (!is_count || !subevent) return fail({Code::repeats_nothing, {}, {print(event)}});
  const Frame& frame = act_.frames.back();
  Frame again{frame.program, false, {*std::move(subevent)}, frame.bindings};
  again.times = std::stoi(count);
  push(std::move(again));
}

void PerformanceTurn::perform_event(const Expression& event) {
  if (is_call(event, "def", 2)) return define(event);
  if (is_call(event, "repeat", 2)) return repeat(event);
  if (event.kind == Kind::name && event.name.empty()) return;
  const auto program = circumstances_.value(event, act_.frames.back().bindings);
  if (program.size() > largest_term) return fail({Code::too_large, {}, {print(event)}});
  perform(program, true);
}

// Goes on by one subevent, or leaves a program at its end.
void PerformanceTurn::advance() {
  Frame& frame = act_.frames.back();
  if (++act_.subevents > most_subevents) return fail(too_long());
  if (frame.times <= 0 || frame.at >= frame.body.size()) {
    if (--frame.times > 0)
      frame.at = 0;
    else
      act_.frames.pop_back();
    return;
  }
  const Subevent subevent = frame.body[frame.at];
  if (subevent.when == Subevent::When::during) return advance_loop(subevent);
  if (subevent.when == Subevent::When::once) {
    const auto holds = decided(subevent.condition, frame.bindings);
    if (!holds) return;
    if (!*holds) {
      ++frame.at;
      return;
    }
  }
  ++frame.at;
  perform_event(event_of(subevent));
}

void PerformanceTurn::advance_loop(const Subevent& loop) {
  Frame& frame = act_.frames.back();
  const auto holds = decided(loop.condition, frame.bindings);
  if (!holds) return;
  const auto event = event_of(loop);
  if (!*holds || (event.kind == Kind::name && event.name.empty())) {
    frame.before.reset();
    frame.retried = false;
    ++frame.at;
    return;
  }
  auto now = places_of(world());
  const bool in_vain = frame.before && same_places(*frame.before, now);
  if (in_vain && frame.retried) {
    const auto program = of_body(circumstances_.value(event, frame.bindings), true);
    return fail({Code::in_vain, {}, {print(program)}});
  }
  frame.retried = in_vain;
  frame.before = std::move(now);
  perform_event(event);
}

std::optional<ActStep> PerformanceTurn::step() {
  while (!act_.ending && !act_.frames.empty()) {
    if (!act_.frames.back().own)
      advance();
    else if (auto step = own_step())
      return step;
  }
  act_.ending = true;
  return let_go();
}

// Brings about a precondition, or fails for lack of a way. False if all preconditions hold.
bool PerformanceTurn::prepare(Frame& frame) {
  for (const auto& argument : frame.program.spine().arguments) {
    const auto* object = is_thing(argument) ? world().find(argument.name()) : nullptr;
    const auto* voxeme = object ? voxeme_of(*object, catalogue_) : nullptr;
    const auto lacks = voxeme ? outstanding(frame.program, argument, *voxeme, circumstances_) : std::nullopt;
    if (!lacks) continue;
    const auto tried = [&](const Term& program) {
      return std::any_of(act_.frames.begin(), act_.frames.end(),
                         [&](const Frame& one) { return name_of(one.program) == name_of(program); });
    };
    const auto fresh = std::find_if_not(lacks->programs.begin(), lacks->programs.end(), tried);
    if (frame.prepared || fresh == lacks->programs.end()) {
      fail({Code::needs_condition, {}, {print(frame.program), lacks->condition}});
    } else {
      frame.prepared = true;
      perform(*fresh, true);
    }
    return true;
  }
  return false;
}

Reason PerformanceTurn::too_long() const {
  return {Code::too_long, {}, {print(act_.end.act.program), std::to_string(most_subevents)}};
}

std::optional<ActStep> PerformanceTurn::own_step() {
  if (++act_.subevents > most_subevents) {
    fail(too_long());
    return std::nullopt;
  }
  auto command = plan(act_.frames.back().program, false, circumstances_.perspective());
  if (!command) {
    fail(command.reason());
    return std::nullopt;
  }
  if (prepare(act_.frames.back())) return std::nullopt;
  auto step = new_step(act_.frames.back().program);
  act_.frames.pop_back();
  if (command->what == Capability::grasp) {
    if (command->object == world().held) {
      step.reason = {Code::held_already, {command->object}};
      return step;
    }
    command->next = next_goal(command->object);
    if (const auto* object = world().find(command->object); object && !command->only_parts)
      command->parts = grasp_parts(*object);
  }
  if (moves_to_goal(command->what)) act_.brought.insert(command->object);
  step.command = *std::move(command);
  return step;
}

// The components by which the object's voxeme affords grasping; the whole is left out.
std::vector<std::string> PerformanceTurn::grasp_parts(const ObjectState& object) const {
  std::vector<std::string> parts;
  const auto* voxeme = voxeme_of(object, catalogue_);
  return voxeme ? continua::grasp_parts(*voxeme) : std::vector<std::string>();
}

// The goal to which the programs under way will take the object after the grasp.
std::optional<Goal> PerformanceTurn::next_goal(const std::string& object) const {
  for (auto frame = act_.frames.rbegin(); frame != act_.frames.rend(); ++frame)
    for (auto i = frame->at; i < frame->body.size(); ++i) {
      const auto event = event_of(frame->body[i]);
      if (event.kind != Kind::call) continue;
      const auto program = of_body(circumstances_.value(event, frame->bindings), true);
      const auto command = plan(program, false, circumstances_.perspective());
      if (!command || command->object != object) continue;
      if (command->what == Capability::ungrasp) return std::nullopt;
      if (moves_to_goal(command->what)) return command->goal;
    }
  return std::nullopt;
}

// A failed act lets go of its object. A stopped act keeps it in the hand.
std::optional<ActStep> PerformanceTurn::let_go() {
  const auto& held = world().held;
  if (act_.end.status == Status::done || act_.end.status == Status::stopped) return std::nullopt;
  if (held.empty() || held == act_.held_before) return std::nullopt;
  auto step = new_step(Term::apply(Term::constant("ungrasp", Type::term()), Term::entity(held)));
  auto command = plan(step.program, false, circumstances_.perspective());
  require(bool(command), "the body can let go");
  step.command = *std::move(command);
  act_.held_before = held;  // once
  return step;
}

}  // namespace continua
