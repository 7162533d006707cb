// A replay: the only loop there is. Events of a trace go to the engine and time to the world; what both did goes to the
// log.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "automaton/machine.h"
#include "core/result.h"
#include "core/sim_time.h"

namespace continua {

struct ReplayOptions {
  std::optional<std::uint64_t> seed;          ///< else the trace's
  std::optional<Choice> choice;               ///< else the machine's
  std::string scene, machine;                 ///< names or paths; empty: the trace's
  std::string knowledge;                      ///< folder; empty: the program's own
  std::string learned;                        ///< file of what was taught in earlier runs; empty: none
  std::map<int, std::string> forced;          ///< step → id of the transition to take there
  std::size_t most_branches = 0;              ///< under `explore`; 0: the engine's own bound
  bool physics = true;                        ///< else the kinematic world
  std::function<void(double done)> progress;  ///< called now and then with the part of the trace that is done
};

/// What a person wants to know of a run at a glance.
struct ReplaySummary {
  SimTime end;
  int inputs = 0, refusals = 0, utterances = 0, acts = 0, acts_done = 0;
  int expectations = 0, expectations_met = 0;
  int problems = 0;
  int pruned = 0;                         ///< configurations given up under `explore`
  std::map<int, std::string> not_forced;  ///< of ReplayOptions::forced, those that did not apply at their step
};

struct LoadedSession;

/// A trace with its machine and its scene, ready to be replayed.
class Session {
 public:
  /// Errors: the trace, its scene or its machine cannot be used; a forced transition is none of the machine's.
  static Result<Session> load(const std::string& trace_path, ReplayOptions options);
  ~Session();
  Session(Session&&) noexcept;

  /// What of the scene is not known; it can be used all the same.
  const std::optional<Error>& warning() const;

  /// Replays the trace and writes its run log. The world is used up by it: REQUIRES that it is called once.
  ReplaySummary run(std::ostream& log);

  /// Writes ReplayOptions::learned, if the run taught or forgot something. REQUIRES that it has run.
  Outcome keep_learned() const;

 private:
  explicit Session(std::unique_ptr<LoadedSession> loaded);
  std::unique_ptr<LoadedSession> loaded_;
};

}  // namespace continua
