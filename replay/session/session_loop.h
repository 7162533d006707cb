// The loop of replays and live sessions: a conversation, its log, and the trace's expectations and observed moves. A
// replay knows all events beforehand, a live session does not; how time is cut into pieces makes no difference.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "continua/body/body.h"
#include "continua/conversation/conversation.h"
#include "continua/replay/recorder/recorder.h"
#include "continua/replay/session/following.h"
#include "continua/replay/session/session_parts.h"

namespace continua {

struct Replayed {
  ReplaySummary summary;
  Learned learned;  ///< when the run has ended
};

class SessionLoop {
 public:
  /// All but the body must outlive the loop.
  SessionLoop(const LoadedSession& loaded, std::unique_ptr<Body> body, const Watch& watch, std::ostream& log);

  /// The records before the first event; `notes` are those on the trace, as far as it is known.
  void begin(const std::vector<Note>& notes);
  /// Lets time go on; percepts that have waited long enough on the way are attended to. A time in the past does
  /// nothing.
  void wait_until(SimTime t);
  /// REQUIRES wait_until(event.t). In order of time; the inputs of one instant in_order().
  void take(const TraceEvent& event);
  /// The events of one instant as they are to be taken, now: neighbouring inputs by their content, not as they were
  /// told.
  std::vector<const TraceEvent*> in_order(std::span<const TraceEvent> events) const;
  /// The run cannot go on: nothing more happens in it.
  void stop(const Error& reason);
  /// Attends to all that waits, finishes acts that are under way, and writes the log's last line.
  Replayed finish();

  SimTime now() const { return conversation_.now(); }
  /// Nothing more is to happen.
  bool is_over() const { return over_; }
  /// The world stands still until a command comes.
  bool is_at_rest() const { return body_->at_rest(); }
  /// The instant at which waiting inputs are attended to at the latest; nothing when none waits.
  std::optional<SimTime> due() const { return conversation_.due(); }
  /// The name of the machine's state.
  const std::string& state() const;

 private:
  using Step = Conversation::Step;

  bool ready();
  Situation situation() const;
  void look_on();
  void take(const TraceEvent& event, const InputEvent& input);
  void prepare(const TraceEvent& event, const InputEvent& input);
  void take(const TraceEvent& event, const Observed& observed);
  void take(const TraceEvent& event, const Expectation& expectation);
  /// Events that only the log takes, if they become a record at all.
  template <class What>
  void take(const TraceEvent& event, const What& what);
  void follow_observed();
  void heed_outside();
  void check_expectations();
  void run(std::optional<SimTime> t);
  void record(const Thought& thought);
  void record(const WorldReport& report) { recorder_.world(report); }
  void settle();
  void look_around_until(SimTime t);
  void give_up_if_asked();
  void write_end();

  const LoadedSession& loaded_;
  const Watch& watch_;
  RunLog log_;
  Episodes episodes_;
  bool open_ = false;                     // something may still be observed of the last input
  std::unique_ptr<Following> following_;  // null in a free run
  Recorder recorder_;
  std::unique_ptr<Body> body_;
  Conversation conversation_;
  bool over_ = false;
  std::vector<std::string> said_since_input_;
  struct Expected {
    TraceEvent event;
    int inputs;  // that it comes after
  };
  std::deque<Expected> expected_;
  ReplaySummary summary_;
};

}  // namespace continua
