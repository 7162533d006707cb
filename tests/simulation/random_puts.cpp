#include "random_puts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "continua/core/random.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/physics_body.h"

namespace continua {

namespace {

using Status = ActReport::Status;

constexpr int puts_per_setting = 6;
constexpr double at_goal_m = 0.02;  // the body's own bound for a successful put
constexpr double tipped_m = 0.005;  // an object's height has changed by more: it does not stand as it stood
constexpr double longest_act_s = 120;

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }
int below(Random& random, std::size_t count) { return static_cast<int>(random.next() % count); }
Vec3 half_of(const Box& box) { return (box.max - box.min) / 2; }

/// The reach of the arm, told from its bones as the scene shows them: a shoulder, two equal limbs, and a hand that
/// comes from above. Between surely and surely not lie the cases that depend on the grip. An arm that is built of other
/// bones cannot be judged: std::invalid_argument.
class Bones {
 public:
  explicit Bones(const Scene& scene) {
    const Json bodies = scene.description()["bodies"];
    const auto at = [&](const char* name) {
      if (!bodies.contains(name)) throw std::invalid_argument(fmt::format("its arm has no body '{}'", name));
      const Json& pose = bodies.at(name);
      return Vec3(pose[0], pose[1], pose[2]);
    };
    shoulder_W_ = at("shoulder");
    limbs_m_ = (at("forearm") - shoulder_W_).norm() + (at("wrist") - at("forearm")).norm();
    hand_m_ = (at("finger_left") - at("hand")).norm() + finger_m;
  }

  bool surely(const Vec3& p_W) const {
    const double wrist_m = (p_W + Vec3(0, 0, hand_m_) - shoulder_W_).norm();
    return wrist_m < limbs_m_ - edge_m && wrist_m > nearest_m;
  }
  bool surely_not(const Vec3& p_W) const { return (p_W - shoulder_W_).norm() > limbs_m_ + hand_m_ + edge_m; }

 private:
  static constexpr double finger_m = 0.1, edge_m = 0.06, nearest_m = 0.3;
  Vec3 shoulder_W_;
  double limbs_m_ = 0, hand_m_ = 0;
};

/// A model of its own, set to the reported poses.
class Depths {
 public:
  explicit Depths(const Scene& scene) : scene_(scene), data_(mj_makeData(&scene.model())) {
    std::copy(scene.initial_qpos().begin(), scene.initial_qpos().end(), data_->qpos);
  }

  void look(const PoseSample& sample) {
    const mjModel& model = scene_.model();
    for (const auto& object : scene_.objects()) {
      const auto pose = sample.bodies.find(object.name);
      if (pose == sample.bodies.end()) continue;
      mjtNum* q = data_->qpos + model.jnt_qposadr[model.body_jntadr[object.body]];
      const auto& [p, R] = pose->second;
      const double values[] = {p.x(), p.y(), p.z(), R.w(), R.x(), R.y(), R.z()};
      std::copy(values, values + 7, q);
    }
    mj_fwdPosition(&model, data_.get());
    for (int i = 0; i < data_->ncon; ++i) {
      const mjContact& contact = data_->contact[i];
      const int body1 = model.geom_bodyid[contact.geom1], body2 = model.geom_bodyid[contact.geom2];
      if (!is_thing(body1) || !is_thing(body2) || -contact.dist <= deepest_m) continue;
      deepest_m = -contact.dist;
      deepest = name_of(model, mjOBJ_BODY, body1) + " and " + name_of(model, mjOBJ_BODY, body2);
    }
  }

  double deepest_m = 0;
  std::string deepest;

 private:
  bool is_thing(int body) const {
    const auto of_body = [&](const SceneObject& object) { return object.body == body; };
    return scene_.model().body_weldid[body] == 0 ||
           std::any_of(scene_.objects().begin(), scene_.objects().end(), of_body);
  }

  const Scene& scene_;
  DataOwner data_;
};

/// Where things stand at the start: anywhere on the table where the arm reaches, apart.
std::vector<ObjectOverride> setting(const Scene& scene, const Bones& bones, Random& random) {
  std::vector<ObjectOverride> all;
  std::vector<std::pair<Vec3, double>> taken;  // centre, radius
  for (const auto& object : scene.objects()) {
    const double radius_m = object.half_extents_m.head<2>().norm();
    const Box& table = scene.table();
    for (int tries = 0; tries < 200; ++tries) {
      const double edge_m = std::min(radius_m, half_of(table).y() - 0.01);
      const Vec3 p(between(random, table.min.x() + edge_m, table.max.x() - edge_m),
                   between(random, table.min.y() + edge_m, table.max.y() - edge_m), object.half_extents_m.z());
      const double yaw = between(random, -3, 3);
      const auto near = [&](const auto& other) {
        return (other.first - p).template head<2>().norm() < radius_m + other.second + 0.005;
      };
      if (!bones.surely(p) || std::any_of(taken.begin(), taken.end(), near)) continue;
      taken.push_back({p, radius_m});
      all.push_back({object.name, p.x(), p.y(), {}, yaw, false});
      break;
    }
  }
  return all;
}

/// One setting of the scene and the puts in it.
class Table {
 public:
  Table(const Scene& scene, const Bones& bones)
      : scene_(scene), bones_(bones), body_(PhysicsBody::create(scene).value()), depths_(scene) {}

  /// False when the world is no longer fit for more: something has fallen.
  bool fit() const {
    const WorldSnapshot world = body_->snapshot();
    return std::all_of(world.objects.begin(), world.objects.end(), [&](const ObjectState& object) {
      return object.p_WO.z() > 0 && std::abs(object.half_extents_m.z() - half_height_m(object.name)) < tipped_m;
    });
  }

  /// Most puts that do not count are passed over: then nothing.
  std::optional<PutTrial> random_put(Random& random, bool in_steps) {
    const WorldSnapshot world = body_->snapshot();
    const ObjectState& object = world.objects[static_cast<std::size_t>(below(random, world.objects.size()))];
    AvatarCommand put;
    put.what = Capability::put;
    put.object = object.name;
    put.goal.perspective = random.uniform() < 0.5 ? Perspective::avatar : Perspective::human;
    PutTrial trial;
    if (random.uniform() < 0.6 || world.objects.size() < 2) {
      const Vec3 half = half_of(object.bounds_W());
      put.goal.p_WG = {between(random, world.table.min.x() + half.x(), world.table.max.x() - half.x()),
                       between(random, world.table.min.y() + half.y(), world.table.max.y() - half.y()), 0};
      trial.what = fmt::format("put({}, <{:.4f}, {:.4f}, 0>)", put.object, put.goal.p_WG.x(), put.goal.p_WG.y());
      trial.counted = !bears_something(object, world);
    } else {
      constexpr Relation relations[] = {Relation::on,       Relation::in,     Relation::left,     Relation::right,
                                        Relation::in_front, Relation::behind, Relation::touching, Relation::beside};
      put.goal.relation = relations[below(random, std::size(relations))];
      const ObjectState* landmark = &object;
      while (landmark == &object)
        landmark = &world.objects[static_cast<std::size_t>(below(random, world.objects.size()))];
      put.goal.landmarks = {landmark->name};
      trial.what = fmt::format("put({}, {}({}))", put.object, name_of(*put.goal.relation), landmark->name);
      trial.counted = is_sensible(object, *put.goal.relation, *landmark, world);
    }
    const auto place = placement(put, world, Occupied::avoided);
    const Vec3 goal = place ? place->p_WO : put.goal.p_WG;
    trial.counted = trial.counted && place && bones_.surely(object.p_WO) && bones_.surely(goal);
    trial.hopeless = bones_.surely_not(object.p_WO) || (place && bones_.surely_not(goal));
    if (!trial.counted && random.uniform() > 0.3) return std::nullopt;
    if (in_steps) trial.what += " in steps";
    run(put, in_steps, trial);
    judge(put, world, trial);
    return trial;
  }

 private:
  double half_height_m(const std::string& name) const {
    for (const auto& object : scene_.objects())
      if (object.name == name) return object.half_extents_m.z();
    return 0;
  }

  static bool bears_something(const ObjectState& object, const WorldSnapshot& world) {
    const Box box = object.bounds_W();
    return std::any_of(world.objects.begin(), world.objects.end(), [&](const ObjectState& other) {
      const Vec3 depth = depth_of(box, other.bounds_W());
      return other.name != object.name && depth.x() > 0 && depth.y() > 0 && other.p_WO.z() > object.p_WO.z() + 1e-3;
    });
  }

  /// A person would do it without a second thought: one thing on another that is no smaller and free, or into a hollow
  /// that is free, or next to a thing on the table.
  static bool is_sensible(const ObjectState& object, Relation relation, const ObjectState& landmark,
                          const WorldSnapshot& world) {
    if (bears_something(object, world)) return false;
    const bool free = !bears_something(landmark, world);
    const Vec3 half = half_of(object.bounds_W()), below = half_of(landmark.bounds_W());
    if (relation == Relation::on)
      return free && !landmark.interior && below.x() >= 0.9 * half.x() && below.y() >= 0.9 * half.y();
    if (relation == Relation::in) {
      const bool thin = std::min(object.half_extents_m.x(), object.half_extents_m.y()) < 0.014;
      return free && landmark.interior && thin && object.p_WO.z() < 0.02;
    }
    return landmark.p_WO.z() - landmark.half_extents_m.z() < 2e-3;
  }

  void run(AvatarCommand put, bool in_steps, PutTrial& trial) {
    const SimTime from = now_;
    const bool in_hand = body_->snapshot().held == put.object;
    if (!in_steps) {
      trial.end = act(put);
    } else {
      AvatarCommand grasp = put, move = put, ungrasp;
      grasp.what = Capability::grasp;
      grasp.next = put.goal;
      move.what = Capability::move;
      ungrasp.what = Capability::ungrasp;
      if (!in_hand) trial.end = act(grasp);
      if (trial.end.status == Status::done) trial.end = act(move);
      const ActReport let_go = act(ungrasp);
      if (trial.end.status == Status::done && let_go.status != Status::done) trial.end = let_go;
    }
    rest();
    trial.seconds = (now_ - from).seconds();
    trial.deepest_m = depths_.deepest_m;
    trial.deepest = depths_.deepest;
    depths_.deepest_m = 0;
  }

  ActReport act(AvatarCommand command) {
    command.id = ++id_;
    body_->command(command);
    ActReport end;
    end.status = Status::started;
    const SimTime last = now_ + SimTime::from_seconds(longest_act_s);
    while (now_ < last && end.status == Status::started) {
      for (const auto& report : advance(last).acts)
        if (report.id == command.id && report.status != Status::started) end = report;
    }
    return end;
  }

  void rest() {
    const SimTime last = now_ + SimTime::from_seconds(longest_act_s);
    while (!body_->at_rest() && now_ < last) advance(now_ + SimTime::from_seconds(0.1));
  }

  WorldReport advance(SimTime t) {
    WorldReport report = body_->advance(t);
    for (const auto& sample : report.poses) depths_.look(sample);
    now_ = report.until;
    return report;
  }

  void judge(const AvatarCommand& put, const WorldSnapshot& before, PutTrial& trial) const {
    const WorldSnapshot world = body_->snapshot();
    const ObjectState& object = *world.find(put.object);
    double moved_m = 0;
    for (const auto& other : before.objects)
      moved_m = std::max(moved_m, (world.find(other.name)->p_WO - other.p_WO).norm());
    const bool failed = trial.end.status == Status::unreachable || trial.end.status == Status::blocked;
    trial.refused = failed && moved_m < 1e-3 && trial.seconds < 0.5;
    if (!put.goal.relation) {
      trial.error_m = (object.p_WO - put.goal.p_WG).head<2>().norm();
      trial.measured = fmt::format("it is {:.1f} mm off", 1000 * *trial.error_m);
      trial.at_goal = *trial.error_m <= at_goal_m && object.p_WO.z() > 0;
      return;
    }
    const std::vector<Landmark> landmarks{*Landmark::named(put.goal.landmarks.front(), world)};
    const double margin_m = holds_by(*put.goal.relation, object, landmarks, world.table, put.goal.perspective);
    constexpr double settling_m = 5e-4;  // an object still gives way by this much when the hand has left it
    trial.at_goal = margin_m > -settling_m;
    if (!trial.at_goal) {
      trial.measured = fmt::format("the relation fails by {:.1f} mm, it was turned by {:.2f} rad", -1000 * margin_m,
                                   object.yaw - before.find(put.object)->yaw);
    }
    if (*put.goal.relation == Relation::on && trial.at_goal)
      trial.error_m = (object.p_WO - landmarks.front().thing->p_WO).head<2>().norm();
  }

  const Scene& scene_;
  const Bones& bones_;
  std::unique_ptr<PhysicsBody> body_;
  Depths depths_;
  SimTime now_;
  int id_ = 0;
};

std::string told(const PutTrial& trial) {
  return fmt::format("{}: {}{}{}", trial.what, name_of(trial.end.status), trial.end.reason.empty() ? "" : ", ",
                     words_of(trial.end.reason));
}

}  // namespace

std::vector<PutTrial> random_puts(const std::string& path, std::uint64_t seed, int counted) {
  Random random(seed);
  const Scene plain = load_scene(path).value();
  const Bones bones(plain);
  std::vector<PutTrial> trials;
  const int most_settings = 10 * counted;
  for (int settings = 0; counted > 0 && settings < most_settings; ++settings) {
    const Scene scene = load_scene(path, setting(plain, bones, random)).value();
    Table table(scene, bones);
    for (int put = 0; put < puts_per_setting && counted > 0 && table.fit(); ++put) {
      auto trial = table.random_put(random, put % 3 == 2);
      if (!trial) continue;
      trial->what = fmt::format("{} seed {}, setting {}: {}", std::filesystem::path(path).stem().string(), seed,
                                settings, trial->what);
      counted -= trial->counted;
      trials.push_back(*std::move(trial));
    }
  }
  return trials;
}

PutFigures figures_of(const std::vector<PutTrial>& trials) {
  constexpr double deep_m = 0.002;
  PutFigures figures;
  std::vector<double> errors;
  for (const auto& trial : trials) {
    const bool done = trial.end.status == Status::done;
    ++figures.trials;
    figures.refused += trial.refused;
    figures.counted += trial.counted;
    figures.done += trial.counted && done;
    figures.seconds += trial.seconds;
    if (done && trial.error_m) errors.push_back(*trial.error_m);
    if (trial.counted && !done) figures.failures.push_back(told(trial));
    if (done && (!trial.at_goal || trial.hopeless)) figures.lies.push_back(told(trial) + "; but " + trial.measured);
    if (trial.deepest_m > deep_m)
      figures.depths.push_back(fmt::format("{}: {}, {:.1f} mm", trial.what, trial.deepest, 1000 * trial.deepest_m));
    figures.deepest_m = std::max(figures.deepest_m, trial.deepest_m);
  }
  std::sort(errors.begin(), errors.end());
  if (!errors.empty()) {
    figures.median_m = errors[errors.size() / 2];
    figures.most_m = errors[std::min(errors.size() - 1, errors.size() * 95 / 100)];
  }
  return figures;
}

}  // namespace continua
