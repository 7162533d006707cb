// Programs performed from their voxemes, step by step (semantics §4): put(cup, on(plate)) is what the subevents of
// `put` say, down to what the body itself can do. Acts run one after the other; each step waits for the body's report.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "continua/behaviour/circumstances.h"
#include "continua/body/body.h"
#include "continua/term/term.h"
#include "continua/voxml/catalogue.h"

namespace continua {

/// An act that is asked for: a closed program.
struct AskedAct {
  int number = 0;  ///< names the act
  Term program;
  std::vector<int> because;  ///< serials of the inputs that it comes from
};

/// A step of an act that the body does itself; without a command it was done already, and `reason` says why.
struct ActStep {
  int act = 0;
  int step = 0;  ///< running number within the act, from 1
  Term program;  ///< grasp(cup), move(cup, on(plate))
  std::optional<AvatarCommand> command;
  Reason reason;
};

/// What came of an act, as its steps have reported it: the last errors, reason and touches of any, what was moved aside
/// and tried again in all of them.
struct ActEnd {
  AskedAct act;
  ActStatus status = ActStatus::done;
  double position_error_m = 0;
  Reason reason = {};
  std::vector<std::string> moved_aside = {};
  double yaw_error = 0;  ///< radians
  std::vector<std::string> touches = {};
  std::vector<Reason> retries = {};
};

/// What the body is told to do for a gesture, whose turn has come.
struct GestureCommand {
  AvatarCommand command;
};

using PerformanceEvent = std::variant<ActStep, ActEnd, GestureCommand>;

/// A program under way: its subevents and where it is in them.
struct ProgramFrame {
  Term program;
  bool own = false;  ///< is done by the body itself; it has no subevents then
  std::vector<Subevent> body;
  Bindings bindings;
  std::size_t at = 0;                                      ///< the next subevent
  int times = 1;                                           ///< how often the body is still to be done
  bool prepared = false;                                   ///< of `own`: a precondition was brought about
  std::optional<std::map<std::string, Vec3>> before = {};  ///< of a loop: where things were before its last turn
  bool retried = false;                                    ///< of a loop: a turn has moved nothing
};

struct ActUnderWay {
  ActEnd end;
  std::vector<ProgramFrame> frames;  ///< the innermost last
  int steps = 0;
  int subevents = 0;             ///< looked at so far, against endless programs
  std::optional<int> in_flight;  ///< command that the body has not reported on yet
  bool ending = false;
  std::string held_before;
  std::map<std::string, Vec3> before;  ///< where things were when it began
  Bindings places_before;              ///< the same as place terms
  std::set<std::string> brought;       ///< the things that its steps have carried so far
};

/// All that is being done or waits for it: a value.
struct Performance {
  std::deque<std::variant<AskedAct, AvatarCommand>> waiting;  ///< acts, and gestures that go after them
  std::optional<ActUnderWay> doing;
  bool stopping = false;  ///< one of them stops the body
  std::deque<ActEnd> given_up;
  Bindings was;      ///< object → where it was before the act that last moved it
  int commands = 0;  ///< running number of the latest

  bool idle() const { return waiting.empty() && !doing && given_up.empty(); }
};

class Performer {
 public:
  /// `perspective` is whose sides place terms mean. `catalogue` must outlive the performer; without it the
  /// body's own programs alone are known.
  Performer(const Catalogue* catalogue, Perspective perspective) : catalogue_(catalogue), circumstances_(perspective) {}

  /// Asks for an act. One that stops the body gives up all those before it.
  void begin(Performance& performance, AskedAct act) const;
  /// A gesture of the arm waits for the acts that were asked for before it; others are begun at once.
  std::optional<AvatarCommand> begin(Performance& performance, AvatarCommand gesture) const;
  /// What happens next, until nothing does before the body reports.
  std::optional<PerformanceEvent> next(Performance& performance, const WorldSnapshot& world);
  void reported(Performance& performance, const ActReport& report) const;

 private:
  void give_up(Performance& performance, const WorldSnapshot& world) const;

  const Catalogue* catalogue_;
  Circumstances circumstances_;
};

}  // namespace continua
