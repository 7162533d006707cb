#include "continua/replay/session/session.h"

#include <fmt/format.h>

#include "continua/body/kinematic_body.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/session/learned_file.h"
#include "continua/replay/session/session_load.h"
#include "continua/replay/session/session_loop.h"
#include "continua/replay/session/shelf.h"
#include "continua/simulation/feasibility.h"
#include "continua/simulation/physics_body.h"

namespace continua {

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
  auto loaded = load_session(trace_path, std::move(options));
  if (!loaded) return loaded.error();
  return Session(std::make_unique<LoadedSession>(*std::move(loaded)));
}

Session::Session(std::unique_ptr<LoadedSession> loaded) : loaded_(std::move(loaded)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

const std::optional<Error>& Session::warning() const { return loaded_->warning; }
const TraceSource& Session::trace() const { return loaded_->trace; }
const ReplayOptions& Session::options() const { return loaded_->options; }
const GestureCatalogue* Session::gestures() const { return loaded_->parts.language->gestures.get(); }
Blanks Session::blanks() const { return blanks_of(loaded_->scene.initial_snapshot()); }
const EngineParts& Session::parts() const { return loaded_->parts; }
const Machine& Session::machine() const { return *loaded_->parts.machine; }

std::vector<std::string> Session::files() const {
  const auto& options = loaded_->options;
  std::vector<std::string> files = {loaded_->trace.head().name,
                                    loaded_->scene.path(),
                                    options.with,
                                    options.weights,
                                    options.learned,
                                    options.scene,
                                    options.machine};
  if (const auto data = find_data_paths(options.knowledge))
    if (const auto machine = machine_of(loaded_->trace.head(), options.machine, *data)) files.push_back(*machine);
  if (constexpr std::string_view run = "run:"; options.outside.starts_with(run))
    files.push_back(options.outside.substr(run.size()));
  return files;
}

ReplaySummary Session::run(std::ostream& log, const Watch& watch) {
  auto loop = begin(watch, log, loaded_->trace.head().notes);
  require(loop.ok(), "a session that was loaded can be run");
  play(**loop, loaded_->trace.read(), loaded_->trace.size());
  return end(**loop);
}

Result<ReplaySummary> Session::run(const Trace& trace, const Watch& watch, std::ostream& log) {
  if (auto placed = objects_text(trace.header); placed != loaded_->placed) {
    Shelf shelf;
    auto scene = load_placed(loaded_->scene.path(), trace, shelf);
    if (!scene) return scene.error();
    loaded_->scene = std::move(*scene);
    loaded_->placed = std::move(placed);
    loaded_->header = header_of(*loaded_);
  }
  auto loop = begin(watch, log, trace.notes);
  if (!loop) return loop.error();
  play(**loop, reading_of(trace.events), trace.events.size());
  return end(**loop);
}

// The events of an instant are taken together.
void Session::play(SessionLoop& loop, const NextEvent& next, std::size_t size) const {
  const auto& progress = loaded_->options.progress;
  std::size_t taken = 0;
  std::vector<TraceEvent> instant;
  auto event = next();
  while (event && *event && !loop.is_over()) {
    const auto t = (*event)->t;
    for (instant.clear(); event && *event && (*event)->t == t; event = next()) instant.push_back(**std::move(event));
    loop.wait_until(t);
    for (const auto* each : loop.in_order(instant)) {
      if (loop.is_over()) break;
      loop.wait_until(each->t);
      loop.take(*each);
      if (progress && taken % 64 == 0) progress(static_cast<double>(taken) / static_cast<double>(size));
      ++taken;
    }
  }
  if (!event) loop.stop(event.error());
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

Error UnmetExpectation::error(const std::string& trace) const {
  return {fmt::format("{}:{}", trace, line), fmt::format("expected {}, found {}", expected, found)};
}

Outcome Session::keep_learned() const {
  require(loaded_->learned_at_end.has_value(), "what was learned is kept after the run");
  const auto& path = loaded_->options.learned;
  if (path.empty() || loaded_->what_if || *loaded_->learned_at_end == loaded_->learned) return std::nullopt;
  return write_learned(path, *loaded_->learned_at_end);
}

}  // namespace continua
