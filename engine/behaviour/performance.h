// Programs performed from their voxemes, step by step (SEMANTICS.md §4). The subevents of `put` turn put(cup,
// on(plate)) into acts of the body. Acts run one after the other; each step waits for the body's report.
#pragma once

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

/// A requested act: a closed program.
struct AskedAct {
  int number = 0;  ///< names the act
  Term program;
  std::vector<int> because;  ///< serials of the inputs that contributed
};

/// A step that the body does itself. Without a command the step was done already, and `reason` says why.
struct ActStep {
  int act = 0;
  int step = 0;  ///< running number within the act, from 1
  Term program;  ///< grasp(cup), move(cup, on(plate))
  std::optional<AvatarCommand> command;
  Reason reason;
};

/// The end of an act, from the reports of its steps: the last errors, reason and touches, and all things moved aside
/// and all retries.
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

/// The body's command for an avatar gesture whose turn has come.
struct GestureCommand {
  AvatarCommand command;
};

/// The body has accepted the first command of an act: nothing speaks against it now.
struct ActBegun {
  AskedAct act;
};

using PerformanceEvent = std::variant<ActStep, ActBegun, ActEnd, GestureCommand>;

/// A program under way: its subevents and the progress in them.
struct ProgramFrame {
  Term program;
  bool own = false;  ///< the body does it itself; there are no subevents then
  std::vector<Subevent> body;
  Bindings bindings;
  std::size_t at = 0;                                      ///< the next subevent
  int times = 1;                                           ///< remaining repetitions of the subevents
  bool prepared = false;                                   ///< if `own`: a precondition was brought about
  std::optional<std::map<std::string, Vec3>> before = {};  ///< in a loop: positions before its last turn
  bool retried = false;                                    ///< in a loop: a turn has moved nothing
};

struct ActUnderWay {
  ActEnd end;
  std::vector<ProgramFrame> frames;  ///< the innermost last
  int steps = 0;
  int subevents = 0;             ///< so far, against endless programs
  std::optional<int> in_flight;  ///< id of the command under way
  bool accepted = false;         ///< the body has begun a command that did not fail at once
  bool begun = false;            ///< ActBegun was told
  bool ending = false;
  std::string held_before;
  std::map<std::string, Vec3> before;  ///< positions of things at the beginning
  Bindings places_before;              ///< the same as place terms
  std::set<std::string> brought;       ///< things that the steps have carried so far
};

/// The act under way and everything that waits: a value.
struct Performance {
  std::vector<std::variant<AskedAct, AvatarCommand>> waiting;  ///< acts, and avatar gestures behind them
  std::optional<ActUnderWay> doing;
  bool stopping = false;  ///< a waiting act stops the body
  std::vector<ActEnd> given_up;
  EarlierPlaces earlier;
  int commands = 0;  ///< number of the latest command

  bool idle() const { return waiting.empty() && !doing && given_up.empty(); }
};

class Performer {
 public:
  /// Sides in place terms are those of `perspective`. `catalogue` must outlive the performer; without a catalogue only
  /// the body's own programs are known.
  Performer(const Catalogue* catalogue, Perspective perspective) : catalogue_(catalogue), perspective_(perspective) {}

  /// Asks for an act. An act that stops the body cancels all earlier ones.
  void begin(Performance& performance, AskedAct act) const;
  /// Begins an avatar gesture. A gesture of the arm waits behind the acts; others are returned and begin at once.
  std::optional<AvatarCommand> begin(Performance& performance, AvatarCommand gesture) const;
  /// The next event; nothing if a report of the body has to come first.
  std::optional<PerformanceEvent> next(Performance& performance, const WorldSnapshot& world) const;
  void reported(Performance& performance, const ActReport& report) const;

 private:
  void give_up(Performance& performance, const WorldSnapshot& world) const;

  const Catalogue* catalogue_;
  Perspective perspective_;
};

}  // namespace continua
