// A trace with all that it needs, loaded once, and the runs of it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/score/episodes.h"
#include "continua/replay/trace/trace_source.h"

namespace continua {

/// How far a replay follows another avatar's moves that the trace has observed.
enum class Variant {
  free,     ///< not at all: the run is the engine's own
  world,    ///< the observed acts move the world, and the engine's own do not
  teacher,  ///< as well, where the engine did otherwise, it goes on as if it had done the observed moves
};

std::string name_of(Variant variant);
/// Nothing for another name.
std::optional<Variant> parse_variant(std::string_view name);

struct EngineParts;
struct EngineState;
struct MachineWeights;
class Shelf;
class Pipeline;

/// Looks at an input of the human before it is received, and returns the transitions to force at the steps to come.
using BeforeInput = std::function<std::map<int, std::size_t>(const Pipeline&, const EngineState&, const InputEvent&,
                                                             const WorldSnapshot&, std::size_t line)>;

struct ReplayOptions {
  std::optional<std::uint64_t> seed;  ///< else the trace's
  std::optional<Choice> choice;       ///< else the machine's
  std::string outside;                ///< a policy from outside in its place (outside_choice.h); empty: none
  std::string weights;                ///< file of weights in place of the machine's (machine_weights.h); empty: none
  Json settings = Json::object();     ///< {name: value} for the machine (machine_settings.h)
  std::shared_ptr<const MachineWeights> own_weights;  ///< in place of a file of them; null: none
  std::string scene, machine;                         ///< names or paths; empty: the trace's
  std::string language;          ///< of speech and phrases, a name; empty: the trace's, else the machine's
  std::string knowledge;         ///< folder; empty: the program's own
  std::shared_ptr<Shelf> shelf;  ///< what other runs have read too; null: nothing
  std::string learned;           ///< file of the lessons of earlier runs; empty: none
  /// What if: seed, choice, machine, language, knowledge, forced and `with` count from this instant of the run on,
  /// seconds; until then it is the trace's own run. The configuration goes over by names.
  std::optional<double> from;
  /// With `from`: the options until then, in place of those of the trace's own run.
  std::shared_ptr<const ReplayOptions> before;
  std::string with;                   ///< with `from`: the trace whose events count from then on; else empty
  std::map<int, std::string> forced;  ///< step → id of the transition to take there
  std::size_t most_branches = 0;      ///< under `explore`; 0: the engine's own bound
  bool physics = true;                ///< else the kinematic world
  Variant variant = Variant::free;    ///< others than free need the kinematic world
  bool episodes = false;              ///< they are wanted in ReplaySummary, where they grow with the trace
  bool live = false;                  ///< the trace is still being written: its digest is not known
  BeforeInput before_input;           ///< empty: nothing is done
  /// Asked now and then, also while nothing but physics happens; true ends the run. Empty: nobody asks.
  std::function<bool()> give_up;
  std::function<void(double done)> progress;  ///< called now and then with the part of the trace that is done
};

/// A line of a trace, the fields of its expectation, and their values then, as compact JSON.
struct UnmetExpectation {
  std::size_t line = 0;
  SimTime t;
  std::string expected, found;

  Error error(const std::string& trace) const;
};

/// A run at a glance, for a person.
struct ReplaySummary {
  SimTime end;
  int inputs = 0, refusals = 0, utterances = 0, acts = 0, acts_done = 0;
  int expectations = 0, expectations_met = 0;
  std::vector<UnmetExpectation> unmet;  ///< the first few of the others
  int problems = 0;
  int fragile = 0;                        ///< decisions that the smallest step of the world could have changed
  int pruned = 0;                         ///< configurations given up under `explore`
  std::map<int, std::string> not_forced;  ///< of ReplayOptions::forced, those that did not apply at their step
  bool changed = false;                   ///< ReplayOptions::from was reached
  std::vector<Episode> episodes;          ///< the human's inputs, each with both answers; only if wanted
  std::optional<Error> stopped = {};      ///< the reason why the run could not go on; the log ends there
};

struct GestureCatalogue;
struct LoadedSession;
struct Situation;
class SessionLoop;

/// Watches the run: called after all that the engine did at an instant, with the situation then. Where it returns true
/// the replay ends, and its log with it.
using Watch = std::function<bool(const Situation&)>;

/// A trace with its machine and its scene, ready to be replayed.
class Session {
 public:
  /// Errors: the trace, its scene or its machine cannot be used; a forced transition is not the machine's.
  static Result<Session> load(const std::string& trace_path, ReplayOptions options);
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// The unknown things of the scene; it can be used all the same.
  const std::optional<Error>& warning() const;

  /// The trace; where ReplayOptions::with is given, with its events from then on.
  const TraceSource& trace() const;
  const Machine& machine() const;
  const EngineParts& parts() const;
  /// The names of the scene's objects and attributes.
  Blanks blanks() const;
  /// The gestures whose meanings the machine knows; null: it knows gestures by their names.
  const GestureCatalogue* gestures() const;
  const ReplayOptions& options() const;
  /// The files that it was loaded from, except those that a scene or the knowledge includes.
  std::vector<std::string> files() const;

  /// Replays the trace and writes its run log. Every run begins anew.
  ReplaySummary run(std::ostream& log, const Watch& watch = {});

  /// The same for another trace, with the loaded parts: only its events, its notes and the header's `objects` are used;
  /// the rest of its header is ignored. Errors: the scene cannot be set out like that.
  Result<ReplaySummary> run(const Trace& trace, const Watch& watch, std::ostream& log);

  /// A run whose events are not known beforehand: see session_loop.h. All must outlive it. Errors: the scene's avatar
  /// is incomplete.
  Result<std::unique_ptr<SessionLoop>> begin(const Watch& watch, std::ostream& log,
                                             const std::vector<Note>& notes = {});
  /// Nothing more happens in that run.
  ReplaySummary end(SessionLoop& loop);

  /// Writes ReplayOptions::learned, if the run taught or forgot something. A run with changes writes nothing. REQUIRES
  /// that it has run.
  Outcome keep_learned() const;

 private:
  explicit Session(std::unique_ptr<LoadedSession> loaded);
  void play(SessionLoop& loop, const NextEvent& next, std::size_t size) const;
  std::unique_ptr<LoadedSession> loaded_;
};

}  // namespace continua
