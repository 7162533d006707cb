#include "continua/simulation/world_pace.h"

#include <ctime>

#include <algorithm>

#include <fmt/format.h>

#include "continua/simulation/mujoco_model.h"

namespace continua {
namespace {

constexpr double looked_at_s = 0.02;  // of the world's time

}  // namespace

double processor_s() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Outcome check_pace(const Scene& scene) {
  const mjModel& model = scene.model();
  const DataOwner data(mj_makeData(&model));
  std::copy(scene.initial_qpos().begin(), scene.initial_qpos().end(), data->qpos);
  const double latest_s = processor_s() + slowest_pace * looked_at_s;
  const double steps = looked_at_s / model.opt.timestep;
  const auto fault = fatal_error_of([&] {
    // Counted, as a world that diverges is set back to time zero again and again.
    for (double step = 0; step < steps && processor_s() <= latest_s; ++step) mj_step(&model, data.get());
  });
  if (!fault.empty()) return Error{scene.path(), "MuJoCo cannot step this scene: " + fault};
  if (processor_s() <= latest_s) return std::nullopt;
  return Error{
      scene.path(),
      fmt::format("physics takes over {} times as long as it lasts, at time steps of {} s, with {} geoms and {} "
                  "contacts; expected longer steps, fewer things, or things that do not overlap",
                  slowest_pace, model.opt.timestep, model.ngeom, data->ncon)};
}

}  // namespace continua
