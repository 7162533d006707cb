#include "continua/replay/session/session_load.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/machine_file/machine_settings.h"
#include "continua/machine_file/machine_weights.h"
#include "continua/replay/session/learned_file.h"
#include "continua/replay/session/outside_choice.h"
#include "continua/replay/session/scene_voxemes.h"
#include "continua/replay/session/shelf.h"
#include "continua/simulation/scene.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

std::vector<ObjectOverride> overrides_of(const TraceHeader& header) {
  std::vector<ObjectOverride> overrides;
  for (const auto& [name, start] : header.objects) {
    ObjectOverride one;
    one.object = name;
    one.removed = start.removed;
    if (start.position_W)
      std::tie(one.x_m, one.y_m, one.z_m) =
          std::tuple(start.position_W->x(), start.position_W->y(), start.position_W->z());
    one.yaw = start.yaw_rad;
    overrides.push_back(std::move(one));
  }
  return overrides;
}

// The transitions that the options force, by index.
Result<std::map<int, std::size_t>> forced_of(const std::map<int, std::string>& options, Choice choice,
                                             const Machine& machine) {
  std::map<int, std::size_t> forced;
  if (!options.empty() && choice == Choice::explore)
    return Error{"--force", "nothing is chosen under explore, which takes all; expected another --choice"};
  for (const auto& [step, id] : options) {
    const auto found = std::find_if(machine.transitions.begin(), machine.transitions.end(),
                                    [&id = id](const Transition& transition) { return transition.id == id; });
    if (found == machine.transitions.end()) {
      std::vector<std::string> known;
      for (const auto& transition : machine.transitions) known.push_back(transition.id);
      return Error{
          fmt::format("--force {}={}", step, id),
          fmt::format("the machine {} has no transition {}{}", machine.name, in_quotes(id), did_you_mean(id, known))};
    }
    forced[step] = static_cast<std::size_t>(found - machine.transitions.begin());
  }
  return forced;
}

// Those of the trace are its own machine's: another one has the values that it knows.
Outcome apply_settings_of(const TraceHead& trace, const ReplayOptions& options, Machine& machine) {
  Json values = trace.header.parameters;
  if (!options.machine.empty() && !values.empty()) {
    const auto known = names_of_settings(machine);
    for (const auto& [name, value] : trace.header.parameters.items())
      if (std::find(known.begin(), known.end(), name) == known.end()) values.erase(name);
  }
  return apply_settings(machine, values, header_line(trace));
}

Outcome set_weights_of(const ReplayOptions& options, Machine& machine) {
  if (options.own_weights) return set_weights(machine, *options.own_weights);
  if (options.weights.empty()) return std::nullopt;
  const auto weights = read_weights(options.weights, machine);
  if (!weights) return weights.error();
  return set_weights(machine, *weights);
}

// The machine with the numbers of the trace and of the options; the machine itself where none is told.
Result<std::shared_ptr<const Machine>> machine_with_settings(const TraceHead& trace, const ReplayOptions& options,
                                                             std::shared_ptr<const Machine> machine) {
  if (trace.header.parameters.empty() && options.settings.empty() && !options.own_weights && options.weights.empty())
    return machine;
  auto changed = std::make_shared<Machine>(*machine);
  if (auto problem = apply_settings_of(trace, options, *changed)) return *std::move(problem);
  if (auto problem = set_weights_of(options, *changed)) return *std::move(problem);
  if (auto problem = apply_settings(*changed, options.settings, "--set")) return *std::move(problem);
  return std::shared_ptr<const Machine>(std::move(changed));
}

Outcome refused_variant(const ReplayOptions& options, Choice choice) {
  if (options.variant == Variant::free) return std::nullopt;
  if (options.physics)
    return Error{"--variant", "what was observed moves the kinematic world alone; expected --no-physics with it"};
  if (options.from) return Error{"--variant", "found --from; expected a run that is the trace's from its beginning"};
  if (options.variant == Variant::teacher && choice == Choice::explore)
    return Error{"--variant",
                 "one configuration is corrected, and under explore there are many; expected another --choice"};
  return std::nullopt;
}

}  // namespace

std::string objects_text(const TraceHeader& header) {
  TraceHeader objects;
  objects.objects = header.objects;
  return write_header(objects);
}

std::string header_line(const TraceHead& trace) { return trace.name + ":1"; }

Result<std::string> scene_of(const TraceHead& trace, const std::string& option, const DataPaths& data) {
  const auto& name = option.empty() ? trace.header.scene : option;
  if (name.empty()) return Error{header_line(trace), "no scene; expected \"scene\" in the trace's header, or --scene"};
  return resolve_scene(name, data, fs::path(trace.name).parent_path(), option.empty() ? header_line(trace) : "--scene");
}

Result<std::string> machine_of(const TraceHead& trace, const std::string& option, const DataPaths& data) {
  const auto& name = option.empty() ? trace.header.machine : option;
  if (name.empty())
    return Error{header_line(trace), "no machine; expected \"machine\" in the trace's header, or --machine"};
  return resolve_machine(name, data, fs::path(trace.name).parent_path(),
                         option.empty() ? header_line(trace) : "--machine");
}

Result<Scene> load_placed(const std::string& path, const TraceHead& trace, Shelf& shelf) {
  auto scene = shelf.scene(path + '\n' + objects_text(trace.header),
                           [&] { return load_scene(path, overrides_of(trace.header)); });
  if (!scene && scene.error().where.empty()) return Error{header_line(trace), scene.error().sentence};
  return scene;
}

Result<EngineParts> load_parts(const TraceHead& trace, const ReplayOptions& options) {
  const auto data = find_data_paths(options.knowledge);
  if (!data) return data.error();
  const auto path = machine_of(trace, options.machine, *data);
  if (!path) return path.error();
  const auto& language_name = options.language.empty() ? trace.header.language : options.language;
  const auto shared = options.shelf ? options.shelf : std::make_shared<Shelf>();
  auto& shelf = shared->knowledge();
  auto machine =
      shelf.machine(*path, *data, language_name, options.language.empty() ? header_line(trace) : "--language");
  if (machine) machine = machine_with_settings(trace, options, *std::move(machine));
  if (!machine) return machine.error();
  const bool own_perspective = !(*machine)->perspective.empty();
  auto parts = load_engine_parts(*std::move(machine), *data, shelf);
  if (!parts) return parts.error();
  parts->choice = options.choice.value_or(parts->choice);
  if (!options.outside.empty()) {
    auto outside = open_outside_choice(options.outside, parts->machine);
    if (!outside) return outside.error();
    parts->outside = std::move(outside->policy);
    parts->choice_told = std::move(outside->told);
    if (parts->choice == Choice::explore) parts->choice = Choice::likeliest;
  }
  parts->seed = options.seed.value_or(trace.header.seed);
  if (!own_perspective) parts->perspective = trace.header.perspective;
  auto forced = forced_of(options.forced, parts->choice, *parts->machine);
  if (!forced) return forced.error();
  parts->forced = std::move(*forced);
  return parts;
}

Result<LoadedSession> load_session(const std::string& trace_path, ReplayOptions options) {
  auto trace = TraceSource::open(trace_path);
  if (!trace) return trace.error();
  if (!options.shelf) options.shelf = std::make_shared<Shelf>();
  const auto before = before_change(options);
  const auto data = find_data_paths(before.knowledge);
  if (!data) return data.error();

  const auto scene_path = scene_of(trace->head(), before.scene, *data);
  if (!scene_path) return scene_path.error();
  auto scene = load_placed(*scene_path, trace->head(), *options.shelf);
  if (!scene) return scene.error();
  auto parts = load_parts(trace->head(), before);
  if (!parts) return parts.error();
  auto learned = before.learned.empty() ? Result<Learned>(Learned())
                                        : read_learned(before.learned, *parts->machine, *parts->language);
  if (!learned) return learned.error();
  if (const auto problem = refused_variant(options, parts->choice)) return *problem;
  auto what_if = load_what_if(*trace, options, *data);
  if (!what_if) return what_if.error();
  if (const auto body = body_of(*scene, options.physics); !body) return body.error();

  auto warning = warning_of_voxemes(*scene, *parts->language->voxemes, data->knowledge.string());
  LoadedSession loaded{std::move(options),
                       *trace,
                       objects_text(trace->head().header),
                       std::move(*parts),
                       std::move(*what_if),
                       std::move(*scene),
                       std::move(*learned),
                       std::move(warning),
                       {},
                       {}};
  loaded.header = header_of(loaded);
  return loaded;
}

}  // namespace continua
