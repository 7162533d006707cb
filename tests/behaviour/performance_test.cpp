// Programs as steps: commands to the body, its reports, and the end of the act.
#include "continua/behaviour/performance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/body/kinematic_body.h"
#include "continua/term/term_text.h"
#include "support/catch.h"

using namespace continua;

namespace {

const Signature& names() {
  static const Signature all = [] {
    Signature names = core_signature();
    const auto type = [](const char* text) { return *Type::parse(text); };
    for (const char* object : {"cup", "plate", "knife", "block", "avatar"}) names.emplace(object, Type::entity());
    for (const char* program : {"grasp", "ungrasp", "lift", "polish", "show", "spin", "fetch", "around", "wave"})
      names.emplace(program, type("e -> t"));
    for (const char* program : {"put", "slide", "set", "carry"}) names.emplace(program, type("e -> loc -> t"));
    for (const char* program : {"swap"}) names.emplace(program, type("e -> e -> t"));
    for (const char* place : {"left", "on", "in", "near", "was"}) names.emplace(place, type("e -> loc"));
    names.emplace("part", type("text -> loc -> loc"));
    names.emplace("stop", Type::truth());
    return names;
  }();
  return all;
}

Term term(const std::string& text) {
  const auto read = parse_term(text, names());
  if (!read) FAIL(read.error().text());
  return *read;
}

template <class T>
T readable(Result<T> read) {
  if (!read) FAIL(read.error().text());
  return *std::move(read);
}

void program(Catalogue& catalogue, const std::string& name, std::vector<std::string> arguments,
             std::vector<std::string> body) {
  Voxeme voxeme;
  voxeme.entity = Voxeme::Entity::program;
  voxeme.predicate = name;
  for (const auto& argument : arguments) voxeme.arguments.push_back({argument, argument == "x" ? "agent" : "physobj"});
  for (const auto& subevent : body) voxeme.body.push_back(readable(parse_subevent(subevent)));
  catalogue.add(voxeme);
}

Voxeme thing(const std::string& name, std::vector<std::string> affordances) {
  Voxeme voxeme;
  voxeme.predicate = name;
  for (const auto& affordance : affordances) voxeme.affordances.push_back(readable(parse_affordance(affordance)));
  return voxeme;
}

const Catalogue& catalogue() {
  static const Catalogue all = [] {
    Catalogue some;
    program(some, "grasp", {"x", "y"}, {"grasp(x,y)"});
    program(
        some, "put", {"x", "y", "z"},
        {"grasp(x,y)", "while(hold(x,y)^!at(y,z)):move(x,y,z,'Planner.Path',loc(y),z,y)", "if(at(y,z)):ungrasp(x,y)"});
    program(some, "set", {"x", "y", "z"}, {"grasp(x,y)", "while(hold(x,y)^!at(y,z))", "at(y,z)->ungrasp(x,y)"});
    program(some, "carry", {"x", "y", "z"}, {"grasp(y)", "[while(hold(x,y),move(y,z)]"});
    program(some, "swap", {"x", "y", "z"},
            {"def(loc(y),as('l1'))", "def(loc(z),as('l2'))", "put(y,near(plate))", "put(z,l1)", "put(y,'l2')"});
    program(some, "fetch", {"x", "y"}, {"repeat(2,'lift(y)')"});
    program(some, "around", {"x", "y"}, {"around_again(y)"});
    program(some, "around_again", {"x", "y"}, {"around(y)"});
    program(some, "spin", {"x", "y"}, {"repeat(99999,def(loc(y),as('l')))"});
    program(some, "polish", {"x", "y"}, {"if(shiny(y)):lift(y)"});
    program(some, "show", {"x", "y"}, {"grasp(y)", "wave(y)"});
    some.add(thing("knife", {"H,hold(x,[1])->[lift([1])]", "H->[grasp(x,[1])]hold(x,[1])"}));
    some.add(thing("block", {"H,hold(x,[1])->[lift([1])]"}));
    return some;
  }();
  return all;
}

ObjectState box(const std::string& name, double x, double y, const Vec3& half_extents_m) {
  ObjectState object;
  object.name = name;
  object.half_extents_m = half_extents_m;
  object.p_WO = Vec3(x, y, half_extents_m.z());
  return object;
}

WorldSnapshot table() {
  WorldSnapshot world;
  world.table = {{-0.5, -0.4, 0}, {0.5, 0.4, 0}};
  world.objects = {box("cup", 0.2, 0, {0.04, 0.04, 0.05}), box("plate", -0.2, 0, {0.1, 0.1, 0.01}),
                   box("knife", 0, 0.2, {0.1, 0.01, 0.005}), box("block", 0.2, 0.2, {0.03, 0.03, 0.03})};
  return world;
}

/// An avatar that gives its acts as text: their steps, and their end.
class Avatar {
 public:
  explicit Avatar(WorldSnapshot world = table()) : body_(std::move(world)) {}

  /// From now on the body reports this of commands of that kind.
  void answers(Capability what, ActReport::Status status) { answers_[what] = status; }

  void ask(const std::string& program) { performer_.begin(performance_, {++acts_, term(program), {}}); }

  /// The events until the body has to report.
  std::string begin() {
    std::vector<std::string> told;
    const auto world = body_.snapshot();
    while (const auto event = performer_.next(performance_, world))
      std::visit([&](const auto& e) { tell(e, told); }, *event);
    return fmt::to_string(fmt::join(told, ", "));
  }
  /// The body performs its command, and reports.
  bool work() {
    if (!under_way_) return false;
    ActReport end{under_way_->id, {}, ActReport::Status::done, 0, {}};
    if (const auto answer = answers_.find(under_way_->what); answer != answers_.end()) {
      end.status = answer->second;
      if (end.status != ActReport::Status::done) end.reason = {ReasonCode::no_way};
    } else {
      body_.command(*under_way_);
      while (!body_.at_rest())
        for (const auto& report : body_.advance(SimTime{}).acts) end = report;
    }
    under_way_.reset();
    performer_.reported(performance_, end);
    return true;
  }
  std::string rest() {
    std::string all = begin();
    while (work())
      if (const auto more = begin(); !more.empty()) all += ", " + more;
    return all;
  }
  std::string does(const std::string& program) {
    ask(program);
    return rest();
  }
  std::string where(const std::string& object) const {
    return print(place_term(*body_.snapshot().find(object), body_.snapshot()));
  }
  /// The held object moves although no act moves it.
  void drifts(const std::string& held, const Vec3& p_W) {
    AvatarCommand drift;
    drift.what = Capability::move;
    drift.object = held;
    drift.goal.p_WG = p_W;
    body_.command(drift);
    while (!body_.at_rest()) body_.advance(SimTime{});
  }
  const std::string& held() { return held_ = body_.snapshot().held; }
  /// The programs that the body has begun, in order.
  const std::string& begun() const { return begun_; }

 private:
  void tell(const ActStep& step, std::vector<std::string>& told) {
    std::string next;
    if (step.command && step.command->next)
      next = step.command->next->relation ? fmt::format(" for {}", name_of(*step.command->next->relation))
                                          : " for a place";
    told.push_back(print(step.program) + next + (step.command ? "" : " [" + words_of(step.reason) + "]"));
    if (step.command) under_way_ = step.command;
  }
  void tell(const ActBegun& begun, std::vector<std::string>&) {
    begun_ += (begun_.empty() ? "" : ", ") + print(begun.act.program);
  }
  void tell(const ActEnd& end, std::vector<std::string>& told) {
    told.push_back(fmt::format("{}: {}{}", print(end.act.program), name_of(end.status),
                               end.reason.empty() ? "" : " (" + words_of(end.reason) + ")"));
  }
  void tell(const GestureCommand& gesture, std::vector<std::string>& told) {
    told.push_back("gesture " + name_of(gesture.command.what));
  }

  Performer performer_{&catalogue(), Perspective::human};
  Performance performance_;
  KinematicBody body_;
  std::map<Capability, ActReport::Status> answers_;
  std::optional<AvatarCommand> under_way_;
  std::string held_, begun_;
  int acts_ = 0;
};

}  // namespace

TEST_CASE("a program is performed by its subevents, down to what the body does") {
  CHECK(Avatar().does("put(cup, on(plate))") ==
        "grasp(cup) for on, move(cup, on(plate)), ungrasp(cup), put(cup, on(plate)): done");
  CHECK(Avatar().does("grasp(cup)") == "grasp(cup), grasp(cup): done");
  CHECK(Avatar().does("lift(cup)") == "lift(cup), lift(cup): done");
  CHECK(Avatar().does("slide(cup, left(plate))") == "slide(cup, left(plate)), slide(cup, left(plate)): done");
}

TEST_CASE("an act has begun once the body has accepted its first command, and never if that failed at once") {
  Avatar avatar;
  avatar.does("put(cup, on(plate))");
  CHECK(avatar.begun() == "put(cup, on(plate))");
  avatar.answers(Capability::grasp, ActReport::Status::unreachable);
  avatar.does("put(block, on(plate))");
  avatar.does("put(cup, on(plate))");  // is there already: nothing begins
  CHECK(avatar.begun() == "put(cup, on(plate))");
  avatar.answers(Capability::grasp, ActReport::Status::done);
  avatar.answers(Capability::move, ActReport::Status::blocked);
  avatar.does("put(knife, on(plate))");
  CHECK(avatar.begun() == "put(cup, on(plate)), put(knife, on(plate))");
}

TEST_CASE("a loop without an event of its own is ended by carrying the thing to its place") {
  CHECK(Avatar().does("set(cup, on(plate))") ==
        "grasp(cup) for on, move(cup, on(plate)), ungrasp(cup), set(cup, on(plate)): done");
}

TEST_CASE("what holds already is not done again") {
  Avatar avatar;
  avatar.does("put(cup, on(plate))");
  CHECK(avatar.does("put(cup, on(plate))") == "put(cup, on(plate)): done (cup is there already)");
  avatar.does("grasp(cup)");
  CHECK(avatar.does("grasp(cup)") == "grasp(cup) [cup is held already], grasp(cup): done");
  CHECK(avatar.does("put(cup, <0.3, 0.1, 0>)") ==
        "grasp(cup) [cup is held already], move(cup, <0.3, 0.1, 0>), ungrasp(cup), put(cup, <0.3, 0.1, 0>): done");
}

TEST_CASE("a place beside where the thing itself is stays where it was meant") {
  Avatar avatar;
  CHECK(avatar.does("put(cup, left(cup))") ==
        "grasp(cup) for a place, move(cup, <0.1, 0, 0>), ungrasp(cup), put(cup, left(cup)): done");
}

TEST_CASE("a place that is no relation is the point that it says") {
  CHECK(Avatar().does("put(cup, part('front', <0.3, 0.1, 0>))") ==
        "grasp(cup) for a place, move(cup, <0.3, 0.1, 0>), ungrasp(cup), put(cup, part('front', <0.3, 0.1, 0>)): done");
}

TEST_CASE("was is where a thing was before the act that last moved it") {
  Avatar avatar;
  CHECK(avatar.does("put(cup, was(cup))") == "put(cup, was(cup)): done (cup is there already)");
  avatar.does("put(cup, on(plate))");
  avatar.does("grasp(cup)");
  avatar.does("put(cup, was(cup))");
  CHECK(avatar.where("cup") == "<0.2, 0, 0>");
  avatar.does("put(cup, was(cup))");
  CHECK(avatar.where("cup") == "on(plate)");
}

TEST_CASE("what goes on moving while the body stops was moved by the act that is stopped") {
  Avatar avatar;
  const auto before = avatar.where("cup");
  avatar.ask("put(cup, on(plate))");
  avatar.begin();
  avatar.work();
  CHECK(avatar.begin() == "move(cup, on(plate))");
  avatar.work();
  avatar.ask("stop");
  CHECK(avatar.begin() == "put(cup, on(plate)): stopped, stop");
  avatar.drifts("cup", {-0.1, 0.05, 0});
  avatar.work();
  CHECK(avatar.rest() == "stop: done");
  avatar.does("put(cup, was(cup))");
  CHECK(avatar.where("cup") == before);
}

TEST_CASE("labels are places that a program remembers") {
  Avatar avatar;
  avatar.does("swap(cup, block)");
  CHECK(avatar.where("cup") == "<0.2, 0.2, 0>");
  CHECK(avatar.where("block") == "<0.2, 0, 0>");
}

TEST_CASE("what an affordance needs is brought about by one whose result it is") {
  CHECK(Avatar().does("lift(knife)") == "grasp(knife), lift(knife), lift(knife): done");
  CHECK(Avatar().does("lift(block)") == "lift(block): blocked (lift(block) needs hold(avatar, block))");
  CHECK(Avatar().does("fetch(knife)") == "grasp(knife), lift(knife), lift(knife), fetch(knife): done");
}

TEST_CASE("a failing step ends the act, and what it has grasped is let go") {
  Avatar avatar;
  avatar.answers(Capability::move, ActReport::Status::unreachable);
  CHECK(avatar.does("put(cup, on(plate))") ==
        "grasp(cup) for on, move(cup, on(plate)), ungrasp(cup), put(cup, on(plate)): unreachable (the arm does not get "
        "there)");
  CHECK(avatar.held().empty());
  avatar.does("grasp(cup)");
  CHECK(avatar.does("put(cup, on(plate))") ==
        "grasp(cup) [cup is held already], move(cup, on(plate)), put(cup, on(plate)): unreachable (the arm does not "
        "get there)");
  CHECK(avatar.held() == "cup");
}

TEST_CASE("a loop whose event moves nothing is tried once more") {
  Avatar avatar;
  avatar.answers(Capability::move, ActReport::Status::done);
  CHECK(avatar.does("put(cup, on(plate))") ==
        "grasp(cup) for on, move(cup, on(plate)), move(cup, on(plate)), ungrasp(cup), put(cup, on(plate)): missed "
        "(move(cup, on(plate)) moves nothing any more)");
  CHECK(Avatar().does("carry(cup, <0.3, 0.1, 0>)") ==
        "grasp(cup) for a place, move(cup, <0.3, 0.1, 0>), move(cup, <0.3, 0.1, 0>), move(cup, <0.3, 0.1, 0>), "
        "ungrasp(cup), carry(cup, <0.3, 0.1, 0>): missed (move(cup, <0.3, 0.1, 0>) moves nothing any more)");
}

TEST_CASE("stop gives up what is under way and what waits") {
  Avatar avatar;
  avatar.ask("put(cup, on(plate))");
  avatar.ask("lift(knife)");
  CHECK(avatar.begin() == "grasp(cup) for on");
  avatar.work();
  CHECK(avatar.begin() == "move(cup, on(plate))");
  avatar.ask("stop");
  avatar.ask("grasp(knife)");
  CHECK(avatar.begin() == "put(cup, on(plate)): stopped, lift(knife): stopped, stop");
  avatar.work();
  CHECK(avatar.rest() == "stop: done, grasp(knife), grasp(knife): done");
}

TEST_CASE("programs that cannot be performed say why, and all end") {
  CHECK(Avatar().does("around(cup)") == "around(cup): blocked (around(cup) goes more than 16 programs deep)");
  CHECK(Avatar().does("spin(cup)") == "spin(cup): blocked (spin(cup) takes more than 1000 steps)");
  CHECK(Avatar().does("polish(cup)") == "polish(cup): blocked (nothing tells whether shiny(y) holds)");
  CHECK(Avatar().does("show(cup)") ==
        "grasp(cup), ungrasp(cup), show(cup): blocked (wave(cup) is no program that the body can perform)");
  CHECK(Avatar().does("\\x. grasp(x)") ==
        "\\x. grasp(x): blocked (\\x. grasp(x) is no program that the body can perform)");
}
