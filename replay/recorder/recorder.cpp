#include "continua/replay/recorder/recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/learning/learning_file.h"
#include "continua/replay/recorder/reading_record.h"

namespace continua {
namespace {

double rounded(double value, double steps_per_unit) {
  return std::round(value * steps_per_unit) / steps_per_unit + 0.0;
}

// Metres to a hundredth of a millimetre, quaternions to a millionth.
Json json_of(const Pose& pose) {
  Json numbers = Json::array();
  for (int i = 0; i < 3; ++i) numbers.push_back(rounded(pose.p_WB[i], 1e5));
  for (const double q : {pose.R_WB.w(), pose.R_WB.x(), pose.R_WB.y(), pose.R_WB.z()})
    numbers.push_back(rounded(q, 1e6));
  return numbers;
}

Json optional_text(const std::optional<std::string>& text) { return text ? Json(*text) : Json(nullptr); }

bool is_empty(const Term& term) {
  return term.is_null() || (term.kind() == Term::Kind::list && term.elements().empty());
}

std::string text_of(Lesson lesson, const Term& value) {
  return lesson == Lesson::word ? print(Program{value}) : print(value);
}

void add_reason(Json& result, const Reason& reason) {
  if (reason.empty()) return;
  result["reason"] = words_of(reason);
  result["code"] = name_of(reason.code);
  if (!reason.objects.empty()) result["objects"] = reason.objects;
}

// What an act, or a step of it, came to.
template <typename End>
Json result_of(const End& end) {
  Json result{{"position_error_m", rounded(end.position_error_m, 1e5)}, {"yaw_error", rounded(end.yaw_error, 1e3)}};
  add_reason(result, end.reason);
  if (!end.touches.empty()) result["touches"] = end.touches;
  if (!end.moved_aside.empty()) result["moved_aside"] = end.moved_aside;
  for (const auto& reason : end.retries) result["retries"].push_back(words_of(reason));
  return result;
}

// An operation's name, and what the machine file says of it, unless it is none.
void add_operation(Json& object, const Operation& operation) {
  const auto source = Json::parse(operation.source);
  object["operation"] = source.begin().key();
  object["content"] = operation.kind == Operation::Kind::none ? Json(nullptr) : source.begin().value();
}

}  // namespace

Json graph_of(const Machine& machine) {
  Json states = Json::array(), edges = Json::array();
  for (const auto& state : machine.states) {
    states.push_back({{"id", state.name}, {"accepting", state.accepting}});
    if (!state.gate) continue;
    auto& gate = states.back()["gate"];
    gate = {{"condition", print(state.gate->when)}, {"else", machine.states[state.gate->otherwise].name}};
    add_operation(gate, state.gate->operation);
  }
  for (const auto& transition : machine.transitions)
    for (const auto from : transition.from) {
      edges.push_back({{"id", transition.id},
                       {"from", machine.states[from].name},
                       {"to", machine.states[transition.to].name},
                       {"input", transition.on ? transition.on_text : "ε"},
                       {"condition", transition.when ? Json(print(*transition.when)) : Json(nullptr)},
                       {"weight", transition.weight}});
      add_operation(edges.back(), transition.operation);
    }
  return {{"states", std::move(states)}, {"start", machine.states[machine.start].name}, {"edges", std::move(edges)}};
}

int Recorder::write(std::string_view kind, Json fields) {
  if (measured_) fields["measured"] = true;
  return log_.write(kind, now_, fields, cause_);
}

int Recorder::input(const TraceEvent& event, const std::string& symbol) {
  now_ = event.t;
  cause_ = std::nullopt;
  Json fields{{"line", event.line}, {"event", event.json}, {"symbol", symbol}};
  fields["event"].erase("t");
  latest_input_ = write("input", fields);
  cause_ = latest_input_;
  return latest_input_;
}

int Recorder::observed(const TraceEvent& event, const Observed& observed) {
  now_ = event.t;
  cause_ = std::nullopt;
  return write("observed", {{"line", event.line}, {"channel", observed.channel}, {"content", observed.content}});
}

void Recorder::engine(const std::vector<EngineEvent>& events, SimTime t) {
  now_ = t;
  for (const auto& event : events) std::visit([this](const auto& what) { one(what); }, event);
  measured_ = false;
}

// The end of an act is an input that no line of the trace tells; when it comes is measured.
void Recorder::one(const Perceived& perceived) {
  if (perceived.act) {
    const Act& act = acts_.at(perceived.act);
    const Json event{
        {"kind", "act"}, {"act", perceived.act}, {"program", act.program}, {"status", name_of(act.status)}};
    measured_ = true;
    cause_ = act.ended;
    latest_input_ = write("input", {{"line", nullptr}, {"event", event}, {"symbol", perceived.symbol}});
    cause_ = latest_input_;
  }
  input_record_[perceived.serial] = latest_input_;
}

void Recorder::one(const Attended& attended) {
  cause_ = std::nullopt;
  if (const auto record = input_record_.find(attended.serial); record != input_record_.end()) cause_ = record->second;
  if (attended.bound.empty() && attended.at == attended.arrived) return;
  Json bound = Json::array();
  std::set<int> because = {attended.serial};
  for (const auto& [words, pointing] : attended.bound) {
    bound.push_back({{"words", fmt::to_string(fmt::join(words, " "))}, {"deixis", fields_of(pointing)}});
    because.insert(pointing.serials.begin(), pointing.serials.end());
  }
  cause_ = write("percept", {{"waited_s", (attended.at - attended.arrived).seconds()},
                             {"bound", std::move(bound)},
                             {"because", inputs({because.begin(), because.end()})}});
}

Json Recorder::fields_of(const Deixis& pointing) {
  return {{"place", {rounded(pointing.place_W.x(), 1e5), rounded(pointing.place_W.y(), 1e5)}},
          {"from", pointing.from.seconds()},
          {"until", pointing.until.seconds()},
          {"hand", pointing.hand.empty() ? Json(nullptr) : Json(pointing.hand)},
          {"gesture", pointing.gesture},
          {"spread_m", rounded(pointing.spread_m, 1e5)},
          {"samples", pointing.samples},
          {"left_out", pointing.left_out}};
}

void Recorder::one(const Understood& understood) {
  if (const auto referents = referents_of(understood.move); referents && understood.taken) last_referents_ = *referents;
  auto fields = reading_fields(understood.move, inputs(understood.because));
  if (understood.alternative) {
    fields["alternative"] = *understood.alternative;
    fields["confidence"] = understood.confidence;
    fields["taken"] = understood.taken;
  }
  const int n = write("reading", fields);
  if (understood.taken) cause_ = n;
}

void Recorder::one(const BeliefChange& change) {
  write("belief", {{"concept", change.name}, {"value", change.value}, {"was", change.was}});
}

void Recorder::one(const StepEvent& step) {
  std::visit([this](const auto& what) { one(what); }, step);
}

void Recorder::one(const Fired& fired) {
  const auto& transition = machine_->transitions[fired.transition];
  Json candidates = Json::array();
  for (const auto& candidate : fired.candidates) {
    candidates.push_back({{"id", machine_->transitions[candidate.transition].id}, {"weight", candidate.weight}});
    if (fired.alternatives > 1) candidates.back()["alternative"] = candidate.alternative;
  }
  Json gates = Json::array();
  for (const auto& gate : fired.gates)
    gates.push_back(
        {{"state", machine_->states[gate.state].name}, {"condition", gate.condition}, {"passed", gate.passed}});
  Json fields = {{"id", transition.id},
                 {"step", fired.step},
                 {"from", machine_->states[fired.from].name},
                 {"to", machine_->states[fired.to].name},
                 {"input", optional_text(fired.input)},
                 {"operation", Json::parse(fired.operation->source)},
                 {"weight", transition.weight},
                 {"probability", fired.probability},
                 {"draw", fired.draw ? Json(*fired.draw) : Json(nullptr)},
                 {"forced", fired.forced},
                 {"candidates", std::move(candidates)},
                 {"refused", refusals(fired.refused, fired.alternatives)},
                 {"gates", std::move(gates)},
                 {"stack", fired.stack},
                 {"depth", fired.depth},
                 {"margin", std::isfinite(fired.margin) ? Json(fired.margin) : Json(nullptr)}};
  if (fired.alternatives > 1) fields["alternative"] = fired.alternative;
  cause_ = write("transition", fields);
}

void Recorder::one(const Explored& explored) {
  Json branches = Json::array();
  for (const auto& branch : explored.branches) {
    Json by = Json::array();
    for (const auto transition : branch.by) by.push_back(machine_->transitions[transition].id);
    branches.push_back({{"id", branch.id},
                        {"parent", branch.parent},
                        {"state", machine_->states[branch.configuration.state].name},
                        {"stack", branch.configuration.stack.id()},
                        {"depth", branch.configuration.stack.depth()},
                        {"weight", branch.weight},
                        {"settled", branch.settled},
                        {"by", std::move(by)}});
  }
  write("branches", {{"branches", std::move(branches)},
                     {"dropped", explored.dropped},
                     {"merged", explored.merged},
                     {"pruned", explored.pruned}});
}

void Recorder::one(const Corrected& corrected) {
  write("correction", {{"id", "observed"},
                       {"from", machine_->states[corrected.from].name},
                       {"to", machine_->states[corrected.to].name},
                       {"implied", corrected.implied ? Json(corrected.implied) : Json(nullptr)},
                       {"stack", corrected.stack},
                       {"depth", corrected.depth}});
}

void Recorder::one(const MadeSymbol& made) {
  Json slots = Json::object();
  for (std::size_t i = 0; i < made.symbol.size(); ++i)
    if (!is_empty(made.symbol[i].value)) slots[machine_->slots[i].name] = print(made.symbol[i].value);
  write("symbol",
        {{"id", made.id}, {"below", made.below ? Json(*made.below) : Json(nullptr)}, {"slots", std::move(slots)}});
}

void Recorder::one(const Rewrote& rewrote) {
  write("rewrite", {{"state", machine_->states[rewrote.state].name},
                    {"operation", Json::parse(rewrote.operation->source)},
                    {"stack", rewrote.stack},
                    {"depth", rewrote.depth}});
}

void Recorder::one(const Applied& applied) {
  const auto& [function, argument, result, rule] = applied.application;
  write(
      "application",
      {{"function", print(function)},
       {"argument", print(argument)},
       {"result", print(result)},
       {"types",
        {{"function", function.type().text()}, {"argument", argument.type().text()}, {"result", result.type().text()}}},
       {"rule", rule.empty() ? Json(nullptr) : Json(rule)},
       {"because", inputs(applied.because)}});
}

void Recorder::one(const Said& said) {
  last_utterance_ = said.text;
  moves_.push_back({"speech", said.text, write("utterance", {{"text", said.text}, {"because", inputs(said.because)}})});
}

void Recorder::one(const Gestured& gestured) {
  auto gesture = print(gestured.term);
  const int n = write("gesture", {{"gesture", gesture}, {"because", inputs(gestured.because)}});
  moves_.push_back({"gesture", std::move(gesture), n});
}

void Recorder::one(const Unplanned& unplanned) { write("problem", {{"line", nullptr}, {"message", unplanned.reason}}); }

void Recorder::one(const Acted& acted) {
  last_act_ = print(acted.term);
  const int number = static_cast<int>(acts_.size()) + 1;
  const Json fields{{"act", number}, {"program", last_act_}, {"status", "asked"}, {"because", inputs(acted.because)}};
  acts_[number] = {write("act", fields), last_act_};
  moves_.push_back({"action", last_act_, acts_[number].record});
}

void Recorder::write_act(int number, const std::string& status, Json more, SimTime t) {
  Json fields{{"act", number}, {"program", acts_.at(number).program}, {"status", status}};
  for (auto& [key, value] : more.items()) fields[key] = std::move(value);
  acts_.at(number).ended = log_.write("act", t, fields, acts_.at(number).record);
}

void Recorder::one(const ActStep& step) {
  if (step.step == 1) write_act(step.act, "started", Json::object(), now_);
  if (step.command) {
    steps_[step.command->id] = step;
    return;
  }
  Json result;
  add_reason(result, step.reason);
  write_act(step.act, "done", {{"step", step.step}, {"program", print(step.program)}, {"result", result}}, now_);
}

void Recorder::one(const ActEnd& end) {
  acts_.at(end.act.number).status = end.status;
  write_act(end.act.number, name_of(end.status), {{"result", result_of(end)}}, now_);
}

void Recorder::one(const Remembered& remembered) {
  write("memory", {{"register", machine_->memory[remembered.index].name}, {"value", print(remembered.value)}});
}

void Recorder::one(const Taught& taught) {
  write("learned", {{"of", text(taught.of)},
                    {"name", taught.name},
                    {"value", text_of(taught.of, taught.value)},
                    {"because", inputs(taught.because)}});
}

void Recorder::one(const Forgotten& forgotten) {
  write("forgotten", {{"of", text(*forgotten.of)},
                      {"name", forgotten.name},
                      {"value", text_of(*forgotten.of, forgotten.value)},
                      {"because", inputs(forgotten.because)}});
}

void Recorder::one(const RefusedInput& refused) {
  write("refusal", {{"state", machine_->states[refused.state].name},
                    {"input", refused.input},
                    {"reason", refused.reason},
                    {"refused", refusals(refused.refused, refused.alternatives)}});
}

void Recorder::one(const Trouble& trouble) { write("problem", {{"line", nullptr}, {"message", trouble.message}}); }

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
  Json bodies = Json::object();
  for (const auto& [name, pose] : sample.bodies) bodies[name] = json_of(pose);
  log_.write("pose", sample.t, {{"bodies", std::move(bodies)}});
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
  if (lasting_rest_)
    log_.write("rest", lasting_rest_->to,
               {{"from", lasting_rest_->from.seconds()}, {"to", lasting_rest_->to.seconds()}});
  lasting_rest_.reset();
}

void Recorder::report(const ActReport& report) {
  const auto found = steps_.find(report.id);
  if (found == steps_.end()) return;
  Json more{{"step", found->second.step}, {"program", print(found->second.program)}};
  if (report.status != ActReport::Status::started) more["result"] = result_of(report);
  write_act(found->second.act, name_of(report.status), std::move(more), report.t);
}

void Recorder::expectation(const TraceEvent& event, bool met, const Json& found) {
  now_ = event.t;
  Json expected = event.json;
  expected.erase("t");
  expected.erase("kind");
  cause_ = std::nullopt;
  write("expect", {{"line", event.line}, {"met", met}, {"expected", std::move(expected)}, {"found", found}});
}

void Recorder::problem(std::size_t line, const std::string& message, SimTime t) {
  log_.write("problem", t, {{"line", line}, {"message", message}});
}

Json Recorder::refusals(const std::vector<Refused>& refused, std::size_t alternatives) const {
  Json list = Json::array();
  for (const auto& one : refused) {
    list.push_back({{"id", machine_->transitions[one.transition].id}, {"reason", one.reason}});
    if (alternatives > 1) list.back()["alternative"] = one.alternative;
  }
  return list;
}

Json Recorder::inputs(const std::vector<int>& because) const {
  Json list = Json::array();
  for (const int serial : because)
    if (const auto record = input_record_.find(serial); record != input_record_.end()) list.push_back(record->second);
  return list;
}

}  // namespace continua
