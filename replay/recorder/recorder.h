// Turns the events of engine and world into lines of the run log, each with the number of its cause.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "continua/pipeline/pipeline.h"
#include "continua/replay/log/run_log.h"
#include "continua/replay/recorder/record_of.h"
#include "continua/replay/score/agreement.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// An act that was asked for.
struct RecordedAct {
  int record = 0;  ///< in which it was asked for
  std::string program;
  ActStatus status = ActStatus::started;
  int latest = 0;  ///< record of its latest news
};

class Recorder {
 public:
  /// Both must outlive the recorder.
  Recorder(RunLog& log, const Machine& machine) : log_(log), machine_(&machine) {}

  /// Later events are of this machine, which must outlive the recorder.
  void go_on_with(const Machine& machine) { machine_ = &machine; }

  /// These return the number of their record.
  int input(const TraceEvent& event, const std::string& symbol);
  int trace_event(const TraceEvent& event, const log::Record& record);
  void engine(const std::vector<EngineEvent>& events, SimTime t);
  /// Acts, poses and rests in order of their times. A rest is one record, however many reports it lasts for.
  void world(const WorldReport& report);
  /// Writes the record that is still held back: a rest that lasts.
  void finish();
  void expectation(const log::Expect& checked, SimTime t);
  void problem(std::size_t line, const std::string& message, SimTime t);

  /// By number, from 1.
  const std::map<int, RecordedAct>& acts() const { return acts_; }
  /// The avatar's moves since the last call.
  std::vector<AvatarMove> take_moves() { return std::exchange(moves_, {}); }
  /// The candidates of the last noun phrase or pointing, the likeliest first.
  const std::vector<std::string>& last_referents() const { return last_referents_; }

 private:
  // Events that only become a record.
  template <class Event>
  void one(const Event& event);
  // Events that the recorder also remembers, or that cause later ones.
  void one(const Perceived& perceived);
  void one(const Attended& attended);
  void one(const Understood& understood);
  void one(const StepEvent& step);
  void one(const ActStep& step);
  void one(const ActEnd& end);
  void one(const MadeSymbol& made);
  void one(const Remembered& remembered);
  void one(const Fired& fired);
  void one(const Said& said);
  void one(const Gestured& gestured);
  void one(const Acted& acted);
  void one(const Branched& branched);

  void report(const ActReport& act);
  void pose(const PoseSample& sample);
  void rest(const RestSpan& span);
  int write(const log::Record& record);
  /// A record of an act that was asked for before. `record` lacks the act's number and, if empty, its program.
  void write_act(int number, log::Act record, SimTime t);

  RunLog& log_;
  const Machine* machine_;
  struct {
    SimTime t;
    std::optional<int> cause;  ///< number of the record that brought it about
    bool measured = false;     ///< its time depends on the length of an act
  } next_;                     ///< of the next record
  SourceRecords source_record_;
  std::vector<AvatarMove> moves_;
  int latest_input_ = 0;
  std::optional<std::int64_t> interim_;  ///< record of the latest words that were not final, until others came
  std::map<int, RecordedAct> acts_;
  std::map<int, ActStep> steps_;  ///< by command
  std::optional<RestSpan> lasting_rest_;
  std::vector<std::string> last_referents_;
};

}  // namespace continua
