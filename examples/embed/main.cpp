// Continua's engine in another program: a world of three things, a body without physics, and a conversation.
//
//   embed "put the knife in the cup" "the blue one"
//
// A robot of yours takes the place of KinematicBody: a class that implements continua::Body.
#include <continua/continua.h>

#include <iostream>

using namespace continua;

namespace {

ObjectState thing(const std::string& name, const std::string& type, const std::string& color, Vec3 centre_W) {
  ObjectState object;
  object.name = name;
  object.attributes = {{"type", type}, {"color", color}};
  object.half_extents_m = {0.03, 0.03, 0.03};
  object.p_WO = centre_W;
  return object;
}

// Metres; the table's top is the plane z = 0, and the human sits at its far side.
WorldSnapshot small_world() {
  WorldSnapshot world;
  world.table = {{-0.4, -0.4, 0}, {0.4, 0.4, 0}};
  world.objects = {thing("b1", "block", "red", {0, 0.15, 0.03}), thing("b2", "block", "blue", {0, -0.15, 0.03}),
                   thing("b3", "block", "green", {0.1, 0, 0.03})};
  return world;
}

void tell(const Thought& thought) {
  for (const auto& event : thought.events) {
    if (const auto* step = std::get_if<StepEvent>(&event))
      if (const auto* said = std::get_if<Said>(step)) std::cout << "avatar: " << said->text << "\n";
    if (const auto* act = std::get_if<ActEnd>(&event)) std::cout << "avatar did " << print(act->act.program) << "\n";
  }
}

void tell(const WorldReport&) {}

void tell(const std::vector<Happening>& happenings) {
  for (const auto& happening : happenings) std::visit([](const auto& what) { tell(what); }, happening);
}

}  // namespace

int main(int count, char** words) {
  const auto data = data_paths_of(CONTINUA_DATA_DIR);
  const auto parts = data ? load_engine_parts("interaction", *data) : data.error();
  if (!parts) {
    std::cerr << parts.error().text() << "\n";
    return 2;
  }
  KinematicBody body(small_world());
  Conversation conversation(*parts, body);
  tell(conversation.begin());
  for (int i = 1; i < count; ++i) {
    InputEvent event;
    event.t = conversation.now();
    event.text = words[i];
    std::cout << "human: " << event.text << "\n";
    tell(conversation.hear(event));
    tell(conversation.advance(conversation.now() + SimTime::from_seconds(10)));
  }
}
