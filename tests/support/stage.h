// A scene with the avatar's body in MuJoCo, commanded one act after another.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continua/simulation/physics_body.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {

/// A place of the table.
inline Goal at(double x, double y) { return {{}, {}, Perspective::avatar, {x, y, 0}}; }
inline Goal by(Relation relation, const std::string& landmark) { return {relation, {landmark}}; }

inline Scene shipped_scene(const std::string& name, const std::vector<ObjectOverride>& overrides = {}) {
  return load_scene(source_dir() + "/mjcf/scenes/" + name + ".xml", overrides).value();
}

struct Stage {
  std::unique_ptr<PhysicsBody> body;
  SimTime now = {};
  std::vector<ActReport> ends = {};

  explicit Stage(const Scene& scene) : body(PhysicsBody::create(scene).value()) {}

  /// Lets the world go on for so long, or until it is at rest.
  void run(double seconds) {
    const SimTime until = now + SimTime::from_seconds(seconds);
    while (now < until && !body->at_rest()) {
      const WorldReport report = body->advance(until);
      for (const auto& act : report.acts)
        if (act.status != ActReport::Status::started) ends.push_back(act);
      now = report.until;
    }
  }

  /// The grip suits the goal.
  void tell(Capability what, const std::string& object = "", const std::optional<Goal>& goal = {}) {
    AvatarCommand command;
    command.what = what;
    command.object = object;
    if (what == Capability::grasp) command.next = goal;
    if (what != Capability::grasp && goal) command.goal = *goal;
    command.height_m = 0.1;
    body->command(command);
  }

  ActReport act(Capability what, const std::string& object = "", const std::optional<Goal>& goal = {}) {
    tell(what, object, goal);
    run(90);
    REQUIRE(body->at_rest());
    return ends.back();
  }

  ObjectState object(const std::string& name) const { return *body->snapshot().find(name); }
  Vec3 place(const std::string& name) const { return object(name).p_WO; }
  std::string held() const { return body->snapshot().held; }

  bool holds(Relation relation, const std::string& object_name, const std::string& landmark) const {
    const WorldSnapshot world = body->snapshot();
    const std::vector<Landmark> landmarks{*Landmark::named(landmark, world)};
    return holds_by(relation, *world.find(object_name), landmarks, world.table, Perspective::avatar) > 0;
  }
};

}  // namespace continua
