// The effect of step size, solver, contacts and the rest rule on the cost and the quality of acts: bench_settings
// [PUTS] writes two tables; README.md describes them.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>

#include <fmt/format.h>

#include "continua/simulation/avatar.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/physics.h"
#include "simulation/random_puts.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string scenes = source_dir() + "/mjcf/scenes/";

/// Processor time of this program alone.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Writes the scene with other options.
std::string with_option(const TemporaryFolder& folder, const std::string& scene, const std::string& option) {
  std::string text = load_scene(scenes + scene).value().text();
  const auto from = text.find("<option ");
  text.replace(from, text.find("/>", from) + 2 - from, "<option " + option + "/>");
  return folder.file(scene, text);
}

/// The world under an avatar that does nothing, or one act.
struct World {
  std::unique_ptr<Physics> physics;
  Avatar avatar;
  double simulated_s = 0;

  explicit World(const Scene& scene) : physics(Physics::create(scene).value()), avatar(*physics) {}

  bool step() {
    simulated_s += physics->timestep_s();
    return physics->step(avatar.update());
  }
  void run(double seconds) {
    for (const double until = simulated_s + seconds; simulated_s < until;)
      if (!step()) return;
  }
  void act(Capability what, const std::string& object, const Vec3& p_WG = Vec3::Zero()) {
    constexpr double longest_s = 60;
    AvatarCommand command;
    command.what = what;
    command.object = object;
    command.goal.p_WG = p_WG;
    command.height_m = 0.1;
    avatar.begin(command);
    for (const double until = simulated_s + longest_s; avatar.busy() && simulated_s < until;)
      if (!step()) return;
  }
  std::vector<Vec3> places() const {
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < physics->objects().size(); ++i)
      all.push_back(physics->object_pose(static_cast<int>(i)).p_WB);
    return all;
  }
  Vec3 in_hand(const std::string& object) const {
    std::map<std::string, Pose> poses;
    for (const auto& [name, pose] : physics->poses()) poses[name] = pose;
    const Pose& hand = poses.at("hand");
    return hand.R_WB.conjugate() * (poses.at(object).p_WB - hand.p_WB);
  }
};

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

/// Creep of a stack of six, in ten seconds after it has settled for half a second.
double stack_drift_m(const std::string& path) {
  std::vector<ObjectOverride> stack;
  double z = 0.03;
  for (const char* block : {"block1", "block3", "block4", "block5", "block6", "block7"}) {
    stack.push_back({block, 0.1, 0.0, z, 0.0, false});
    z += 0.06;
  }
  World world(load_scene(path, stack).value());
  world.run(0.5);
  const auto before = world.places();
  world.run(10);
  return farthest(before, world.places());
}

/// Slip of a lifted block in the hand, carried to and fro.
double slip_m(const std::string& path) {
  World world(load_scene(path).value());
  world.act(Capability::grasp, "block1");
  const Vec3 before = world.in_hand("block1");
  world.act(Capability::lift, "");
  for (const double x : {0.2, -0.3, 0.05}) world.act(Capability::move, "block1", {x, -0.05, 0});
  world.act(Capability::lift, "");
  return world.physics->held() < 0 ? 1 : (world.in_hand("block1") - before).norm();
}

/// Processor time per simulated second: during an act, and without one.
std::pair<double, double> cost_s(const std::string& path) {
  World world(load_scene(path).value());
  double before = processor_s();
  for (const double x : {0.1, -0.1, 0.05}) world.act(Capability::put, "block1", {x, -0.04, 0});
  const double moving_s = (processor_s() - before) / world.simulated_s;
  const double from = world.simulated_s;
  before = processor_s();
  world.run(10);
  return {moving_s, (processor_s() - before) / (world.simulated_s - from)};
}

void settings_table(int puts) {
  const std::string base = R"(integrator="implicit" cone="elliptic" impratio="10")";
  const std::pair<const char*, std::string> variants[] = {
      {"as the scenes have it", R"(timestep="0.002" )" + base},
      {"1 ms", R"(timestep="0.001" )" + base},
      {"3 ms", R"(timestep="0.003" )" + base},
      {"4 ms", R"(timestep="0.004" )" + base},
      {"solver CG", R"(timestep="0.002" solver="CG" )" + base},
      {"solver PGS", R"(timestep="0.002" solver="PGS" )" + base},
      {"sparse Jacobian", R"(timestep="0.002" jacobian="sparse" )" + base},
      {"pyramidal cone", R"(timestep="0.002" integrator="implicit" cone="pyramidal" impratio="10")"},
      {"impratio 1", R"(timestep="0.002" integrator="implicit" cone="elliptic" impratio="1")"},
      {"impratio 100", R"(timestep="0.002" integrator="implicit" cone="elliptic" impratio="100")"},
      {"integrator Euler", R"(timestep="0.002" integrator="Euler" cone="elliptic" impratio="10")"},
      {"Euler, sparse", R"(timestep="0.002" integrator="Euler" jacobian="sparse" cone="elliptic" impratio="10")"},
      {"integrator RK4", R"(timestep="0.002" integrator="RK4" cone="elliptic" impratio="10")"},
  };
  fmt::print(
      "| setting | moving, ms/s | resting, ms/s | puts done | median, mm | 95 %, mm | deepest, mm | stack drift, mm | "
      "slip, mm |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const auto& [name, option] : variants) {
    const TemporaryFolder folder;
    std::vector<PutTrial> trials;
    for (const char* scene : {"staircase.xml", "place_setting.xml"}) {
      const auto of_scene = random_puts(with_option(folder, scene, option), 11, puts);
      trials.insert(trials.end(), of_scene.begin(), of_scene.end());
    }
    const auto figures = figures_of(trials);
    const auto path = with_option(folder, "staircase.xml", option);
    const auto [moving_s, resting_s] = cost_s(path);
    fmt::print("| {} | {:.1f} | {:.1f} | {} of {} | {:.1f} | {:.1f} | {:.1f} | {:.3f} | {:.2f} |\n", name,
               1000 * moving_s, 1000 * resting_s, figures.done, figures.counted, 1000 * figures.median_m,
               1000 * figures.most_m, 1000 * figures.deepest_m, 1000 * stack_drift_m(path), 1000 * slip_m(path));
    std::fflush(stdout);
  }
}

/// Nothing faster than these for so long is at rest.
struct RestRule {
  double m_per_s, rad_per_s, for_s;
  int still_steps = 0;
  std::vector<Vec3> at_rest = {};
  double sum_waited_s = 0, worst_m = 0;
  int rests = 0;
};

/// Each rule watches the same world after each put; motion after its word of rest is its error.
void rest_table() {
  constexpr double watched_s = 5;
  std::vector<RestRule> rules;
  for (const auto& [m_per_s, rad_per_s] : {std::pair(5e-4, 0.0125), std::pair(2e-3, 0.05), std::pair(1e-2, 0.25)})
    for (const double for_s : {0.02, 0.05, 0.1, 0.2, 0.5}) rules.push_back({m_per_s, rad_per_s, for_s});
  int watches = 0;
  for (const char* name : {"staircase.xml", "place_setting.xml"}) {
    const Scene scene = load_scene(scenes + name).value();
    World world(scene);
    const double dt_s = world.physics->timestep_s();
    for (int put = 0; put < 2 * static_cast<int>(scene.objects().size()); ++put) {
      const auto& object = scene.objects()[static_cast<std::size_t>(put) % scene.objects().size()];
      world.act(Capability::put, object.name, {-0.3 + 0.07 * ((put * 5) % 9), -0.06 + 0.04 * (put % 3), 0});
      for (auto& rule : rules) rule.still_steps = 0, rule.at_rest.clear();
      for (double t = 0; t < watched_s; t += dt_s) {
        if (!world.step()) return;
        for (auto& rule : rules) {
          if (!rule.at_rest.empty()) continue;
          const bool still = world.physics->slower_than(rule.m_per_s, rule.rad_per_s);
          rule.still_steps = still ? rule.still_steps + 1 : 0;
          if (rule.still_steps * dt_s < rule.for_s) continue;
          rule.at_rest = world.places();
          rule.sum_waited_s += t;
          ++rule.rests;
        }
      }
      ++watches;
      for (auto& rule : rules)
        if (!rule.at_rest.empty()) rule.worst_m = std::max(rule.worst_m, farthest(rule.at_rest, world.places()));
    }
  }
  fmt::print(
      "\n| slower than, mm/s | rad/s | for, s | rests | mean wait, s | moved afterwards, mm |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (const auto& rule : rules)
    fmt::print("| {:.1f} | {:.4f} | {:.2f} | {} of {} | {:.3f} | {:.3f} |\n", 1000 * rule.m_per_s, rule.rad_per_s,
               rule.for_s, rule.rests, watches, rule.sum_waited_s / std::max(1, rule.rests), 1000 * rule.worst_m);
}

}  // namespace

int main(int argc, char** argv) {
  settings_table(argc > 1 ? std::atoi(argv[1]) : 30);
  rest_table();
}
