#include "continua/replay/recorder/recorder.h"

#include <algorithm>
#include <tuple>

#include "continua/term/term_text.h"

namespace continua {
int Recorder::write(const log::Record& record) { return log_.write(record, next_.t, next_.cause, next_.measured); }

int Recorder::input(const TraceEvent& event, const std::string& symbol) {
  next_.t = event.t;
  next_.cause = std::nullopt;
  Json said = event.json;
  said.erase("t");
  const auto* input = std::get_if<InputEvent>(&event.what);
  const bool is_speech = input && input->modality == Modality::speech;
  const auto superseded = is_speech ? std::exchange(interim_, std::nullopt) : std::nullopt;
  latest_input_ = write(log::Input{static_cast<std::int64_t>(event.line), std::move(said), symbol, superseded});
  if (is_speech && !input->final) interim_ = latest_input_;
  next_.cause = latest_input_;
  return latest_input_;
}

int Recorder::trace_event(const TraceEvent& event, const log::Record& record) {
  next_.t = event.t;
  next_.cause = std::nullopt;
  return write(record);
}

template <class Event>
void Recorder::one(const Event& event) {
  // A gesture that became a command is told by the act that it asked for; an input that is attended to again, by the
  // percept that it becomes.
  if constexpr (std::is_same_v<Event, GestureCommand> || std::is_same_v<Event, Reattended>)
    return;
  else if constexpr (requires { record_of(event, *machine_); })
    write(record_of(event, *machine_));
  else if constexpr (requires { record_of(event, source_record_); })
    write(record_of(event, source_record_));
  else
    write(record_of(event));
}

void Recorder::engine(const std::vector<EngineEvent>& events, SimTime t) {
  next_.t = t;
  for (const auto& event : events) std::visit([this](const auto& what) { one(what); }, event);
  next_.measured = false;
}

// The beginning and the end of an act are inputs that no line of the trace tells; when they come is measured.
void Recorder::one(const Perceived& perceived) {
  if (perceived.act) {
    const RecordedAct& act = acts_.at(perceived.act);
    const Json event{
        {"kind", "act"}, {"act", perceived.act}, {"program", act.program}, {"status", name_of(act.status)}};
    next_.measured = true;
    next_.cause = act.latest;
    latest_input_ = write(log::Input{std::nullopt, event, perceived.symbol, std::nullopt});
    next_.cause = latest_input_;
  }
  source_record_.add(perceived.serial, latest_input_);
}

void Recorder::one(const Attended& attended) {
  next_.cause = source_record_.find(attended.serial);
  if (attended.bound.empty() && attended.assured.empty() && attended.at == attended.happened) return;
  next_.cause = write(record_of(attended, source_record_));
}

void Recorder::one(const Understood& understood) {
  if (const auto referents = referents_of(understood.move); referents && understood.taken) last_referents_ = *referents;
  const int n = write(record_of(understood, source_record_));
  if (understood.taken) next_.cause = n;
}

void Recorder::one(const StepEvent& step) {
  std::visit([this](const auto& what) { one(what); }, step);
}

void Recorder::one(const MadeSymbol& made) {
  source_record_.add(source_of_symbol(made.id), write(record_of(made, *machine_, source_record_)));
}

void Recorder::one(const Remembered& remembered) {
  source_record_.add(source_of_write(remembered.number), write(record_of(remembered, *machine_, source_record_)));
}

void Recorder::one(const Fired& fired) { next_.cause = write(record_of(fired, *machine_)); }

void Recorder::one(const Said& said) {
  moves_.push_back({"speech", said.text, write(record_of(said, source_record_))});
}

void Recorder::one(const Gestured& gestured) {
  auto record = record_of(gestured, source_record_);
  const int n = write(record);
  moves_.push_back({"gesture", std::move(record.gesture), n});
}

void Recorder::one(const Acted& acted) {
  const auto program = print(acted.term);
  const int number = static_cast<int>(acts_.size()) + 1;
  const int n = write(log::Act{number, program, "asked", {}, records_of(acted.because, source_record_), {}});
  acts_[number] = {n, program};
  moves_.push_back({"action", program, n});
}

// The record that the event would be if its branch led. Lessons are none: they are known only once they are learned.
void Recorder::one(const Branched& branched) {
  const auto of = [this](const auto& event) -> std::optional<log::Record> {
    using Event = std::decay_t<decltype(event)>;
    if constexpr (std::is_same_v<Event, Acted>)
      return log::Act{0, print(event.term), "asked", {}, records_of(event.because, source_record_), {}};
    else if constexpr (std::is_same_v<Event, Reattended> || std::is_same_v<Event, Taught> ||
                       std::is_same_v<Event, Forgotten>)
      return std::nullopt;
    else if constexpr (requires { record_of(event, *machine_, source_record_); })
      return record_of(event, *machine_, source_record_);
    else if constexpr (requires { record_of(event, *machine_); })
      return record_of(event, *machine_);
    else if constexpr (requires { record_of(event, source_record_); })
      return record_of(event, source_record_);
    else
      return record_of(event);
  };
  const auto record = std::visit(of, branched.event);
  if (!record) return;
  const int n = write(
      log::Branched{branched.branch, branched.parent, std::string(log::kind_of(*record)), log::members_of(*record)});
  if (const auto* made = std::get_if<MadeSymbol>(&branched.event)) source_record_.add(source_of_symbol(made->id), n);
  if (const auto* one = std::get_if<Remembered>(&branched.event)) source_record_.add(source_of_write(one->number), n);
}

void Recorder::write_act(int number, log::Act record, SimTime t) {
  auto& act = acts_.at(number);
  record.act = number;
  if (record.program.empty()) record.program = act.program;
  act.latest = log_.write(record, t, act.record);
}

void Recorder::one(const ActStep& step) {
  if (step.step == 1) write_act(step.act, {.status = "started"}, next_.t);
  if (step.command)
    steps_[step.command->id] = step;
  else
    write_act(step.act,
              {.program = print(step.program), .status = "done", .step = step.step, .result = result_of(step)},
              next_.t);
}

void Recorder::one(const ActEnd& end) {
  acts_.at(end.act.number).status = end.status;
  write_act(end.act.number, {.status = name_of(end.status), .result = result_of(end)}, next_.t);
}

void Recorder::world(const WorldReport& report) {
  struct Line {
    SimTime t;
    int rank;  // at one instant: poses, acts, rests
    std::size_t index;
  };
  std::vector<Line> lines;
  for (std::size_t i = 0; i < report.poses.size(); ++i) lines.push_back({report.poses[i].t, 0, i});
  for (std::size_t i = 0; i < report.acts.size(); ++i) lines.push_back({report.acts[i].t, 1, i});
  for (std::size_t i = 0; i < report.rests.size(); ++i) lines.push_back({report.rests[i].to, 2, i});
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return std::tie(a.t, a.rank) < std::tie(b.t, b.rank); });
  for (const auto& line : lines) {
    if (line.rank == 0)
      pose(report.poses[line.index]);
    else if (line.rank == 1)
      this->report(report.acts[line.index]);
    else
      rest(report.rests[line.index]);
  }
}

void Recorder::pose(const PoseSample& sample) {
  finish();
  log_.write(record_of(sample), sample.t);
}

void Recorder::rest(const RestSpan& span) {
  if (lasting_rest_ && lasting_rest_->to == span.from) {
    lasting_rest_->to = span.to;
    return;
  }
  finish();
  lasting_rest_ = span;
}

void Recorder::finish() {
  if (lasting_rest_) log_.write(record_of(*lasting_rest_), lasting_rest_->to);
  lasting_rest_.reset();
}

void Recorder::report(const ActReport& report) {
  const auto found = steps_.find(report.id);
  if (found == steps_.end()) return;
  const auto& step = found->second;
  log::Act record{.program = print(step.program), .status = name_of(report.status), .step = step.step};
  if (report.status != ActReport::Status::started) record.result = result_of(report);
  write_act(step.act, std::move(record), report.t);
}

void Recorder::expectation(const log::Expect& checked, SimTime t) {
  next_.t = t;
  next_.cause = std::nullopt;
  write(checked);
}

void Recorder::problem(std::size_t line, const std::string& message, SimTime t) {
  log_.write(log::Problem{static_cast<std::int64_t>(line), message}, t);
}

}  // namespace continua
