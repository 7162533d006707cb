// The cost of a replay with physics: recorded sessions replayed, and MuJoCo alone stepping the same scene through the
// same time. bench_physics LOG… writes a table; see README.md.
#include <algorithm>
#include <ctime>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "continua/replay/session/session.h"
#include "continua/replay/trace/session_import.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/scene.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Processor time of `simulated_s` of MuJoCo alone: the arm is commanded to stay as it is.
double plain_steps_s(const Scene& scene, double simulated_s) {
  const mjModel& model = scene.model();
  const DataOwner data(mj_makeData(&model));
  std::copy(scene.initial_qpos().begin(), scene.initial_qpos().end(), data->qpos);
  for (int i = 0; i < model.nu; ++i) data->ctrl[i] = data->qpos[model.jnt_qposadr[model.actuator_trnid[2 * i]]];
  const auto steps = static_cast<long>(simulated_s / model.opt.timestep);
  const double before = processor_s();
  for (long i = 0; i < steps; ++i) {
    for (int dof = 0; dof < model.nu; ++dof) {
      const int address = model.jnt_dofadr[model.actuator_trnid[2 * dof]];
      data->qfrc_applied[address] = data->qfrc_bias[address];
    }
    mj_step(&model, data.get());
  }
  return processor_s() - before;
}

int fail(const Error& error) {
  fmt::print(stderr, "bench_physics: {}\n", error.text());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print("bench_physics: skipped, no session logs were named\n");
    return 0;
  }
  const TemporaryFolder folder;
  double replays_s = 0, steps_s = 0, simulated_s = 0;
  int acts = 0, done = 0;
  fmt::print(
      "| log | simulated, s | replay, s | MuJoCo alone, s | ratio | acts done |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (int i = 1; i < argc; ++i) {
    auto trace = import_session(argv[i]);
    if (!trace) return fail(trace.error());
    const double before = processor_s();
    auto session = Session::load(folder.file("session.trace.jsonl", write_trace(*trace)), {});
    if (!session) return fail(session.error());
    std::ofstream log(folder.at("session.run.jsonl"), std::ios::binary);
    const auto summary = session->run(log);
    const double replay_s = processor_s() - before;
    const auto scene = load_scene(fmt::format("{}/mjcf/scenes/{}.xml", source_dir(), trace->header.scene));
    if (!scene) return fail(scene.error());
    const double alone_s = plain_steps_s(*scene, summary.end.seconds());
    fmt::print("| {} | {:.0f} | {:.1f} | {:.1f} | {:.2f} | {} of {} |\n", trace->header.source, summary.end.seconds(),
               replay_s, alone_s, replay_s / alone_s, summary.acts_done, summary.acts);
    std::fflush(stdout);
    replays_s += replay_s;
    steps_s += alone_s;
    simulated_s += summary.end.seconds();
    acts += summary.acts;
    done += summary.acts_done;
  }
  fmt::print("| all | {:.0f} | {:.1f} | {:.1f} | {:.2f} | {} of {} |\n", simulated_s, replays_s, steps_s,
             replays_s / steps_s, done, acts);
}
