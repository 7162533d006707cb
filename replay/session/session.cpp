#include "continua/replay/session/session.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <tuple>

#include <fmt/format.h>

#include "continua/body/kinematic_body.h"
#include "continua/core/located_json.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/knowledge_shelf.h"
#include "continua/machine_file/machine_parameters.h"
#include "continua/machine_file/machine_weights.h"
#include "continua/replay/session/learned_file.h"
#include "continua/replay/session/outside_choice.h"
#include "continua/replay/session/scene_voxemes.h"
#include "continua/replay/session/session_loop.h"
#include "continua/replay/session/session_parts.h"
#include "continua/simulation/feasibility.h"
#include "continua/simulation/physics_body.h"

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

// The objects of a header, as a trace writes them.
std::string objects_text(const TraceHeader& header) {
  TraceHeader objects;
  objects.objects = header.objects;
  return write_header(objects);
}

std::string header_line(const Trace& trace) { return trace.name + ":1"; }

Result<std::string> scene_of(const Trace& trace, const std::string& option, const DataPaths& data) {
  const auto& name = option.empty() ? trace.header.scene : option;
  if (name.empty()) return Error{header_line(trace), "no scene; expected \"scene\" in the trace's header, or --scene"};
  return resolve_scene(name, data, fs::path(trace.name).parent_path(), option.empty() ? header_line(trace) : "--scene");
}

Result<std::string> machine_of(const Trace& trace, const std::string& option, const DataPaths& data) {
  const auto& name = option.empty() ? trace.header.machine : option;
  if (name.empty())
    return Error{header_line(trace), "no machine; expected \"machine\" in the trace's header, or --machine"};
  return resolve_machine(name, data, fs::path(trace.name).parent_path(),
                         option.empty() ? header_line(trace) : "--machine");
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
Outcome set_parameters_of(const Trace& trace, const ReplayOptions& options, Machine& machine) {
  Json values = trace.header.parameters;
  if (!options.machine.empty()) {
    const auto known = parameter_values(machine);
    for (const auto& [name, value] : trace.header.parameters.items())
      if (!known.contains(name)) values.erase(name);
  }
  return set_parameters(machine, values, header_line(trace));
}

// The engine that answers the human of a trace, with the options' changes.
Result<EngineParts> load_parts(const Trace& trace, const ReplayOptions& options) {
  const auto data = find_data_paths(options.knowledge);
  if (!data) return data.error();
  const auto path = machine_of(trace, options.machine, *data);
  if (!path) return path.error();
  const auto& language_name = options.language.empty() ? trace.header.language : options.language;
  const auto shelf = options.shelf ? options.shelf : std::make_shared<KnowledgeShelf>();
  auto machine =
      shelf->machine(*path, *data, language_name, options.language.empty() ? header_line(trace) : "--language");
  if (!machine) return machine.error();
  if (const auto problem = set_parameters_of(trace, options, *machine)) return *problem;
  if (options.own_weights) {
    if (const auto problem = set_weights(*machine, *options.own_weights)) return *problem;
  } else if (!options.weights.empty()) {
    const auto weights = read_weights(options.weights, *machine);
    if (!weights) return weights.error();
    if (const auto problem = set_weights(*machine, *weights)) return *problem;
  }
  const bool own_perspective = !machine->perspective.empty();
  auto parts = load_engine_parts(*std::move(machine), *data, *shelf);
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

// The edited trace, whose scene cannot be another one: the world is in the midst of it.
Result<Trace> read_edited(const Trace& original, const ReplayOptions& options, const DataPaths& data) {
  auto edited = read_trace(options.with);
  if (!edited) return edited.error();
  const auto cannot = [&](const char* what) {
    return Error{header_line(*edited),
                 fmt::format("found {} than in {}; expected the same, since they cannot change in mid-run", what,
                             header_line(original))};
  };
  if (options.scene.empty()) {
    const auto was = scene_of(original, "", data);
    if (!was) return was.error();
    const auto now = edited->header.scene.empty() ? was : scene_of(*edited, "", data);
    if (!now) return now.error();
    std::error_code unknown;
    if (*was != *now && !fs::equivalent(*was, *now, unknown)) return cannot("another 'scene'");
  }
  if (objects_text(original.header) != objects_text(edited->header)) return cannot("other 'objects'");
  if (edited->header.machine.empty()) {
    const auto machine = machine_of(original, "", data);
    if (!machine) return machine.error();
    edited->header.machine = *machine;
    if (edited->header.language.empty()) edited->header.language = original.header.language;
  }
  return edited;
}

bool same_note(const Note& a, const Note& b) { return a.line == b.line && a.sentence == b.sentence; }

// Puts the edited trace's events from the instant on in the place of the trace's own.
void splice(Trace& trace, Trace edited, WhatIf& what_if) {
  const auto before = [&](const TraceEvent& event) { return event.t < what_if.from; };
  std::erase_if(trace.events, [&](const TraceEvent& event) { return !before(event); });
  for (const auto& note : edited.notes) {
    const auto on_line = [&](const TraceEvent& event) { return event.line == note.line && !before(event); };
    const auto known = [&](const Note& one) { return same_note(one, note); };
    if (std::any_of(edited.events.begin(), edited.events.end(), on_line) &&
        std::none_of(trace.notes.begin(), trace.notes.end(), known))
      what_if.notes.push_back(note);
  }
  std::erase_if(edited.events, before);
  std::move(edited.events.begin(), edited.events.end(), std::back_inserter(trace.events));
  what_if.trace = {fs::path(edited.name).filename().string(), edited.digest};
}

// The options' changes from their instant on, if they name one. The trace gets its events from then on.
Result<std::optional<WhatIf>> load_what_if(Trace& trace, const ReplayOptions& options, const DataPaths& data) {
  if (!options.from) {
    if (options.with.empty()) return std::optional<WhatIf>();
    return Error{"--with", "found no --from; expected the instant from which on the trace's events are those of this"};
  }
  WhatIf what_if;
  what_if.from = SimTime::from_seconds(*options.from);
  std::optional<Trace> edited;
  if (!options.with.empty()) {
    auto read = read_edited(trace, options, data);
    if (!read) return read.error();
    edited = std::move(*read);
  }
  auto parts = load_parts(edited ? *edited : trace, options);
  if (!parts) return parts.error();
  what_if.parts = std::move(*parts);
  if (edited) splice(trace, std::move(*edited), what_if);
  return std::optional(std::move(what_if));
}

// The scene as the trace's header has its objects; what is wrong with them is wrong there.
Result<Scene> load_placed(const std::string& path, const Trace& trace) {
  auto scene = load_scene(path, overrides_of(trace.header));
  if (!scene && scene.error().where.empty()) return Error{header_line(trace), scene.error().sentence};
  return scene;
}

// The options of the run before any change.
ReplayOptions before_change(const ReplayOptions& options) {
  if (!options.from) return options;
  if (options.before) return *options.before;
  ReplayOptions before;
  before.scene = options.scene;
  before.learned = options.learned;
  return before;
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

std::string name_of(Variant variant) {
  return variant == Variant::free ? "free" : variant == Variant::world ? "world" : "teacher";
}

std::optional<Variant> parse_variant(std::string_view name) {
  for (const auto variant : {Variant::free, Variant::world, Variant::teacher})
    if (name_of(variant) == name) return variant;
  return std::nullopt;
}

Result<std::unique_ptr<Body>> body_of(const Scene& scene, bool physics) {
  if (!physics) {
    auto ability = arm_ability(scene);
    if (!ability) return ability.error();
    return std::unique_ptr<Body>(
        std::make_unique<KinematicBody>(scene.initial_snapshot(), Occupied::avoided, *std::move(ability)));
  }
  auto body = PhysicsBody::create(scene);
  if (!body) return body.error();
  return std::unique_ptr<Body>(std::move(*body));
}

Result<Session> Session::load(const std::string& trace_path, ReplayOptions options) {
  auto trace = read_trace(trace_path);
  if (!trace) return trace.error();
  const auto before = before_change(options);
  const auto data = find_data_paths(before.knowledge);
  if (!data) return data.error();

  const auto scene_path = scene_of(*trace, before.scene, *data);
  if (!scene_path) return scene_path.error();
  auto scene = load_placed(*scene_path, *trace);
  if (!scene) return scene.error();
  auto parts = load_parts(*trace, before);
  if (!parts) return parts.error();
  auto learned = before.learned.empty() ? Result<Learned>(Learned())
                                        : read_learned(before.learned, *parts->machine, *parts->language);
  if (!learned) return learned.error();
  if (const auto problem = refused_variant(options, parts->choice)) return *problem;
  auto what_if = load_what_if(*trace, options, *data);
  if (!what_if) return what_if.error();
  if (const auto body = body_of(*scene, options.physics); !body) return body.error();

  auto warning = warning_of_voxemes(*scene, *parts->language->voxemes, data->knowledge.string());
  auto loaded = std::make_unique<LoadedSession>(LoadedSession{std::move(options),
                                                              std::move(*trace),
                                                              std::move(*parts),
                                                              std::move(*what_if),
                                                              std::move(*scene),
                                                              std::move(*learned),
                                                              std::move(warning),
                                                              {},
                                                              {}});
  loaded->header = header_of(*loaded);
  return Session(std::move(loaded));
}

Session::Session(std::unique_ptr<LoadedSession> loaded) : loaded_(std::move(loaded)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const std::optional<Error>& Session::warning() const { return loaded_->warning; }
const Trace& Session::trace() const { return loaded_->trace; }
const ReplayOptions& Session::options() const { return loaded_->options; }
const GestureCatalogue* Session::gestures() const { return loaded_->parts.language->gestures.get(); }
Blanks Session::blanks() const { return blanks_of(loaded_->scene.initial_snapshot()); }
const EngineParts& Session::parts() const { return loaded_->parts; }
const Machine& Session::machine() const { return *loaded_->parts.machine; }

std::vector<std::string> Session::files() const {
  const auto& options = loaded_->options;
  std::vector<std::string> files = {loaded_->trace.name, loaded_->scene.path(), options.with,   options.weights,
                                    options.learned,     options.scene,         options.machine};
  if (const auto data = find_data_paths(options.knowledge))
    if (const auto machine = machine_of(loaded_->trace, options.machine, *data)) files.push_back(*machine);
  if (constexpr std::string_view run = "run:"; options.outside.starts_with(run))
    files.push_back(options.outside.substr(run.size()));
  return files;
}

ReplaySummary Session::run(std::ostream& log) {
  auto summary = run(loaded_->trace, {}, log);
  require(summary.ok(), "a session that was loaded can be run");
  return *summary;
}

Result<ReplaySummary> Session::run(const Trace& trace, const Watch& watch, std::ostream& log) {
  if (objects_text(trace.header) != objects_text(loaded_->trace.header)) {
    auto scene = load_placed(loaded_->scene.path(), trace);
    if (!scene) return scene.error();
    loaded_->scene = std::move(*scene);
    loaded_->trace.header.objects = trace.header.objects;
    loaded_->header = header_of(*loaded_);
  }
  auto loop = begin(watch, log, trace.notes);
  if (!loop) return loop.error();
  const auto& progress = loaded_->options.progress;
  for (auto next = trace.events.begin(); next != trace.events.end() && !(*loop)->is_over();) {
    const auto end = std::find_if(next, trace.events.end(), [&](const TraceEvent& each) { return each.t != next->t; });
    (*loop)->wait_until(next->t);
    for (const auto* event : (*loop)->in_order({next, end})) {
      if ((*loop)->is_over()) break;
      (*loop)->wait_until(event->t);
      (*loop)->take(*event);
      const auto i = event - trace.events.data();
      if (progress && i % 64 == 0) progress(static_cast<double>(i) / static_cast<double>(trace.events.size()));
    }
    next = end;
  }
  return end(**loop);
}

Result<std::unique_ptr<SessionLoop>> Session::begin(const Watch& watch, std::ostream& log,
                                                    const std::vector<Note>& notes) {
  auto body = body_of(loaded_->scene, loaded_->options.physics);
  if (!body) return body.error();
  auto loop = std::make_unique<SessionLoop>(*loaded_, std::move(*body), watch, log);
  loop->begin(notes);
  return loop;
}

ReplaySummary Session::end(SessionLoop& loop) {
  auto [summary, learned] = loop.finish();
  loaded_->learned_at_end = std::move(learned);
  return summary;
}

Outcome Session::keep_learned() const {
  require(loaded_->learned_at_end.has_value(), "what was learned is kept after the run");
  const auto& path = loaded_->options.learned;
  if (path.empty() || loaded_->what_if || *loaded_->learned_at_end == loaded_->learned) return std::nullopt;
  return write_learned(path, *loaded_->learned_at_end);
}

}  // namespace continua
