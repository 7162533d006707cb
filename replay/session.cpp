#include "replay/session.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "behaviour/kinematic_body.h"
#include "composition/learning_file.h"
#include "core/digest.h"
#include "pipeline/pipeline.h"
#include "replay/data_paths.h"
#include "replay/expectation.h"
#include "replay/language_loading.h"
#include "replay/learned_file.h"
#include "replay/recorder.h"
#include "replay/run_record.h"
#include "replay/scene_voxemes.h"
#include "replay/trace_file.h"
#include "replay/version.h"
#include "simulation/physics_body.h"
#include "simulation/scene.h"
#include "voxml/catalogue.h"

namespace continua {

struct LoadedSession {
  ReplayOptions options;
  Trace trace;
  std::shared_ptr<const Machine> machine;
  std::shared_ptr<const Language> language;
  Scene scene;
  std::optional<Error> warning;
  std::unique_ptr<Body> body;
  std::map<int, std::size_t> forced;  ///< step → transition
  Learned learned;                    ///< when the run begins
  Json knowledge;                     ///< digests of its files
  std::optional<Learned> learned_at_end;
};

namespace {

// After the last event the world may go on until it rests, but not longer.
constexpr double longest_tail_s = 120;
// An act may be answered with another one that is done at once, and so on: so often before time goes on.
constexpr int most_rounds = 1000;

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

// The loop over a trace's events, with all that it carries along.
class Loop {
 public:
  Loop(const LoadedSession& loaded, std::ostream& out)
      : loaded_(loaded),
        choice_(loaded.options.choice.value_or(loaded.machine->choice)),
        perspective_(perspective()),
        seed_(loaded.options.seed.value_or(loaded.trace.header.seed)),
        log_(out),
        recorder_(log_, *loaded.machine),
        pipeline_(loaded.machine, loaded.language, perspective_, most_branches()),
        body_(*loaded.body) {}

  ReplaySummary run() {
    write_header();
    take(pipeline_.begin({choice_, Random(seed_), loaded_.forced, 0}, body_.snapshot(), loaded_.learned), SimTime{});
    const auto& events = loaded_.trace.events;
    for (const auto& note : loaded_.trace.notes) recorder_.problem(note.line, note.sentence, SimTime{});
    for (std::size_t i = 0; i < events.size(); ++i) {
      wait_until(std::max(now_, events[i].t));
      std::visit([&](const auto& what) { take(events[i], what); }, events[i].what);
      if (loaded_.options.progress && i % 64 == 0)
        loaded_.options.progress(static_cast<double>(i) / static_cast<double>(events.size()));
    }
    settle();
    return finish();
  }

  /// Of the run so far.
  const Learned& learned() const { return state_->learned; }

 private:
  std::size_t most_branches() const {
    return loaded_.options.most_branches ? loaded_.options.most_branches : default_most_branches;
  }

  Perspective perspective() const {
    const auto& machines = loaded_.machine->perspective;
    if (machines.empty()) return loaded_.trace.header.perspective;
    return machines == "avatar" ? Perspective::avatar : Perspective::human;
  }

  void write_header() {
    RunHeader header;
    header.continua_version = program_version();
    header.trace_name = std::filesystem::path(loaded_.trace.name).filename().string();
    header.trace_digest = loaded_.trace.digest;
    header.seed = seed_;
    header.choice = text(choice_);
    header.forced = loaded_.options.forced;
    if (choice_ == Choice::explore) header.most_branches = most_branches();
    header.world = loaded_.options.physics ? "physics" : "kinematic";
    header.perspective = text(perspective_);
    header.fingerprint = fingerprint();
    header.machine_name = loaded_.machine->name;
    header.machine_digest = digest(loaded_.machine->document);
    header.machine_document = Json::parse(loaded_.machine->document);
    if (!loaded_.machine->phrases.empty()) {
      header.phrases_name = loaded_.machine->phrases;
      header.phrases_digest = digest(loaded_.machine->phrase_document);
      header.phrases_document = Json::parse(loaded_.machine->phrase_document);
    }
    if (!(loaded_.learned == Learned())) header.learned = Json::parse(print_learned(loaded_.learned));
    header.graph = graph_of(*loaded_.machine);
    if (loaded_.language->lexicon) {
      header.lexicon_name = loaded_.machine->lexicon;
      header.lexicon_digest = loaded_.language->lexicon->digest;
    }
    header.knowledge = loaded_.knowledge;
    header.voxemes_digest = loaded_.language->voxemes->digest();
    header.scene_name = std::filesystem::path(loaded_.scene.path()).stem().string();
    header.scene_digest = digest(loaded_.scene.text());
    header.scene_mjcf = loaded_.scene.text();
    header.scene_description = loaded_.scene.description();
    header.without_voxeme = objects_without_voxeme(loaded_.scene, *loaded_.language->voxemes);
    log_.write("run", SimTime{}, run_fields(header));
  }

  void take(const TraceEvent& event, const InputEvent& input) {
    ++summary_.inputs;
    recorder_.input(event, symbol_of(input));
    take(pipeline_.receive(*state_, input, body_.snapshot()), now_);
    attend();
  }
  void take(const TraceEvent& event, const Observed& observed) { recorder_.observed(event, observed); }
  // What is expected is checked once all that happened before has been attended to.
  void take(const TraceEvent& event, const Expectation& expectation) {
    expected_.push_back({&event, &expectation, state_->inputs});
    check_expectations();
  }
  void take(const TraceEvent&, const End&) {}
  void take(const TraceEvent&, const UnknownKind&) {}

  void check_expectations() {
    for (; !expected_.empty() && !state_->waits(expected_.front().inputs); expected_.pop_front())
      check_expectation(*expected_.front().event, *expected_.front().what);
  }
  void check_expectation(const TraceEvent& event, const Expectation& expectation) {
    const auto checked = check(expectation, {pipeline_.machine(), state_->configuration, body_.snapshot(),
                                             said_since_input_, recorder_.last_act(), recorder_.last_referents()});
    recorder_.expectation(event, checked.met, checked.found);
    ++summary_.expectations;
    summary_.expectations_met += checked.met;
  }

  void take(Tick tick, SimTime t) {
    obey(std::move(tick), t);
    go_on(t);  // what is done at once is done before the next event
  }

  void obey(Tick tick, SimTime t) {
    recorder_.engine(tick.events, t);
    for (const auto& event : tick.events) {
      if (const auto* gesture = std::get_if<GestureCommand>(&event)) body_.command(gesture->command);
      if (const auto* act = std::get_if<ActStep>(&event); act && act->command) body_.command(*act->command);
      if (const auto* explored = std::get_if<Explored>(&event)) summary_.pruned += explored->pruned;
      if (const auto* step = std::get_if<StepEvent>(&event))
        if (const auto* said = std::get_if<Said>(step)) said_since_input_.push_back(said->text);
    }
    state_ = std::move(tick.after);
  }

  // Lets the world go on until then. What ends on the way is told to the engine at its time, and what follows from it
  // begins at once.
  void go_on(SimTime t) {
    for (int rounds = 0; rounds < most_rounds; ++rounds) {
      const auto report = body_.advance(t);
      recorder_.world(report);
      if (report.until > now_) rounds = 0;
      now_ = report.until;
      const bool ended = std::any_of(report.acts.begin(), report.acts.end(),
                                     [](const ActReport& act) { return act.status != ActReport::Status::started; });
      if (ended) obey(pipeline_.reported(*state_, report.acts, body_.snapshot()), now_);
      if (!ended && now_ >= t) return;
    }
  }

  // Attends to what is complete, one after the other.
  void attend() {
    while (!state_->complete.empty()) {
      said_since_input_.clear();
      take(pipeline_.attend(*state_, body_.snapshot()), now_);
      check_expectations();
    }
  }

  // Time goes on; what has waited long enough on the way is attended to.
  void wait_until(SimTime t) {
    for (auto due = pipeline_.due(*state_); due && *due <= t; due = pipeline_.due(*state_)) {
      go_on(std::max(now_, *due));
      take(pipeline_.wake(*state_, now_), now_);
      attend();
    }
    go_on(t);
  }

  // Acts that are under way when the trace ends are still finished.
  void settle() {
    while (const auto due = pipeline_.due(*state_)) wait_until(std::max(now_, *due));
    const SimTime last = now_ + SimTime::from_seconds(longest_tail_s);
    while (!body_.at_rest() && now_ < last) go_on(now_ + SimTime::from_seconds(0.1));
  }

  ReplaySummary finish() {
    recorder_.finish();
    const auto& counts = log_.counts();
    const auto count = [&](const char* kind) { return counts.contains(kind) ? counts.at(kind) : 0; };
    summary_.utterances = count("utterance");
    summary_.refusals = count("refusal");
    summary_.problems = count("problem");
    for (const auto& [number, act] : recorder_.acts()) {
      ++summary_.acts;
      summary_.acts_done += act.status == ActReport::Status::done;
    }
    for (const auto& [step, transition] : state_->chooser.forced)
      summary_.not_forced[step] = loaded_.machine->transitions[transition].id;
    summary_.end = now_;
    log_.finish(now_);
    return summary_;
  }

  const LoadedSession& loaded_;
  Choice choice_;
  Perspective perspective_;
  std::uint64_t seed_;
  RunLog log_;
  Recorder recorder_;
  Pipeline pipeline_;
  std::optional<EngineState> state_;  // once the run has begun
  Body& body_;
  SimTime now_;
  std::vector<std::string> said_since_input_;
  struct Expected {
    const TraceEvent* event;
    const Expectation* what;
    int inputs;  ///< that it comes after
  };
  std::deque<Expected> expected_;
  ReplaySummary summary_;
};

// The transitions that the options force, by index.
Result<std::map<int, std::size_t>> forced_of(const ReplayOptions& options, const Machine& machine) {
  std::map<int, std::size_t> forced;
  if (!options.forced.empty() && options.choice.value_or(machine.choice) == Choice::explore)
    return Error{"--force", "nothing is chosen under explore, which takes all; expected another --choice"};
  for (const auto& [step, id] : options.forced) {
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

}  // namespace

Result<Session> Session::load(const std::string& trace_path, ReplayOptions options) {
  auto trace = read_trace(trace_path);
  if (!trace) return trace.error();
  const auto data = find_data_paths(options.knowledge);
  if (!data) return data.error();
  const auto folder = std::filesystem::path(trace_path).parent_path();
  const auto header_line = trace_path + ":1";

  const auto& scene_name = options.scene.empty() ? trace->header.scene : options.scene;
  if (scene_name.empty()) return Error{header_line, "no scene; expected \"scene\" in the trace's header, or --scene"};
  const auto scene_path = resolve_scene(scene_name, *data, folder, options.scene.empty() ? header_line : "--scene");
  if (!scene_path) return scene_path.error();
  auto scene = load_scene(*scene_path, overrides_of(trace->header));
  if (!scene) return scene.error();

  const auto& machine_name = options.machine.empty() ? trace->header.machine : options.machine;
  if (machine_name.empty())
    return Error{header_line, "no machine; expected \"machine\" in the trace's header, or --machine"};
  const auto machine_path =
      resolve_machine(machine_name, *data, folder, options.machine.empty() ? header_line : "--machine");
  if (!machine_path) return machine_path.error();
  auto machine = load_machine(*machine_path, *data);
  if (!machine) return machine.error();
  auto language = load_language(*data, *machine);
  if (!language) return language.error();
  auto learned =
      options.learned.empty() ? Result<Learned>(Learned()) : read_learned(options.learned, *machine, *language);
  if (!learned) return learned.error();
  auto forced = forced_of(options, *machine);
  if (!forced) return forced.error();

  auto knowledge = knowledge_digests(*data, *machine);
  auto warning = warning_of_voxemes(*scene, *language->voxemes, data->knowledge.string());
  std::unique_ptr<Body> body;
  if (options.physics) {
    auto physics = PhysicsBody::create(*scene);
    if (!physics) return physics.error();
    body = std::move(*physics);
  } else {
    body = std::make_unique<KinematicBody>(scene->initial_snapshot());
  }
  return Session(std::make_unique<LoadedSession>(LoadedSession{std::move(options),
                                                               std::move(*trace),
                                                               std::make_shared<const Machine>(std::move(*machine)),
                                                               std::make_shared<const Language>(std::move(*language)),
                                                               std::move(*scene),
                                                               std::move(warning),
                                                               std::move(body),
                                                               std::move(*forced),
                                                               std::move(*learned),
                                                               std::move(knowledge),
                                                               {}}));
}

Session::Session(std::unique_ptr<LoadedSession> loaded) : loaded_(std::move(loaded)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;

const std::optional<Error>& Session::warning() const { return loaded_->warning; }

ReplaySummary Session::run(std::ostream& log) {
  Loop loop(*loaded_, log);
  auto summary = loop.run();
  loaded_->learned_at_end = loop.learned();
  return summary;
}

Outcome Session::keep_learned() const {
  require(loaded_->learned_at_end.has_value(), "what was learned is kept after the run");
  if (loaded_->options.learned.empty() || *loaded_->learned_at_end == loaded_->learned) return std::nullopt;
  return write_learned(loaded_->options.learned, *loaded_->learned_at_end);
}

}  // namespace continua
