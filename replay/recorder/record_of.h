// The record of a run log that each event of the engine and the world becomes: pure functions. The recorder numbers
// the records, and knows the acts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/pipeline/engine_state.h"
#include "continua/replay/log/records.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The number of the record that tells of each source (automaton/stack.h): of an input, of a symbol, of a register's
/// value. Four bytes a source, however long the session.
class SourceRecords {
 public:
  void add(int source, int record);
  std::optional<int> find(int source) const;

 private:
  std::vector<int> inputs_, values_;  // by the source, or its opposite; -1: it has no record
};

/// The numbers of these sources' records, as `because` has them. Sources without a record are left out.
std::vector<std::int64_t> records_of(const std::vector<int>& sources, const SourceRecords& records);

// Input
log::Percept record_of(const Attended& attended, const SourceRecords& sources);
log::Reading record_of(const Understood& understood, const SourceRecords& sources);
log::Learned record_of(const Taught& taught, const SourceRecords& sources);
log::Forgotten record_of(const Forgotten& forgotten, const SourceRecords& sources);

/// Names of the objects that the move can mean, the likeliest first; nothing for a move without a noun phrase or
/// pointing.
std::optional<std::vector<std::string>> referents_of(const Move& move);

// Events of the trace that are no inputs
inline log::Observed record_of(const TraceEvent& event, const Observed& observed) {
  return {static_cast<std::int64_t>(event.line), observed.channel, observed.content};
}
inline log::Mark record_of(const TraceEvent& event, const Mark& mark) {
  return {static_cast<std::int64_t>(event.line), mark.text};
}

// Automaton
log::Belief record_of(const BeliefChange& change);
log::Memory record_of(const Remembered& remembered, const Machine& machine, const SourceRecords& sources);
log::Transition record_of(const Fired& fired, const Machine& machine);
log::Branches record_of(const Explored& explored, const Machine& machine);
log::Correction record_of(const Corrected& corrected, const Machine& machine);
log::Symbol record_of(const MadeSymbol& made, const Machine& machine, const SourceRecords& sources);
log::Rewrite record_of(const Rewrote& rewrote, const Machine& machine);
log::Application record_of(const Applied& applied, const SourceRecords& sources);
log::Refusal record_of(const RefusedInput& refused, const Machine& machine);
log::Problem record_of(const Trouble& trouble);

// Avatar
log::Utterance record_of(const Said& said, const SourceRecords& sources);
log::AvatarGesture record_of(const Gestured& gestured, const SourceRecords& sources);
log::Problem record_of(const Unplanned& unplanned);
/// The outcome of an act or of a step of one.
log::ActResult result_of(const ActReport& report);
log::ActResult result_of(const ActEnd& end);
/// A step that needed no doing.
log::ActResult result_of(const ActStep& step);
log::Pose record_of(const PoseSample& sample);
log::Rest record_of(const RestSpan& span);

}  // namespace continua
