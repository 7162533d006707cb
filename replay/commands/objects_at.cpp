#include "continua/replay/commands/objects_at.h"

#include <memory>
#include <sstream>

#include "continua/replay/scene/run_poses.h"
#include "continua/replay/session/expectation.h"
#include "continua/replay/session/session.h"
#include "continua/world/geometry.h"

namespace continua {

Result<std::vector<std::pair<std::string, ObjectStart>>> objects_at(const std::string& trace, SimTime t) {
  ReplayOptions options;
  options.physics = false;
  auto session = Session::load(trace, options);
  if (!session) return session.error();
  std::vector<std::string> objects;
  std::ostringstream log;
  session->run(log, [&](const Situation& situation) {
    if (objects.empty())
      for (const auto& object : situation.world.objects) objects.push_back(object.name);
    return situation.world.t >= t;
  });
  auto run = RunIndex::of_text(std::move(log).str(), trace);
  if (!run) return run.error();
  RunPoses poses(std::make_shared<const RunIndex>(*std::move(run)));
  const auto at_start = poses.at({}), then = poses.at(t - SimTime{1});
  std::vector<std::pair<std::string, ObjectStart>> places;
  for (const auto& name : objects) {
    const auto found = then.find(name), before = at_start.find(name);
    if (found == then.end() || (before != at_start.end() && before->second == found->second)) continue;
    const auto& pose = found->second;
    ObjectStart start;
    start.position_W = Vec3(pose[0], pose[1], pose[2]);
    start.yaw_rad = yaw_of({pose[3], pose[4], pose[5], pose[6]});
    places.emplace_back(name, start);
  }
  return places;
}

}  // namespace continua
