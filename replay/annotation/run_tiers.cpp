#include "continua/replay/annotation/run_tiers.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "continua/replay/annotation/event_tiers.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/reading_time.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

// Something that stays as it is until it changes, as a tier: an annotation for each value that lasts.
class Lasting {
 public:
  Lasting(TierMaker& tiers, std::string tier) : tiers_(tiers), tier_(std::move(tier)) {}

  // Values that come in one millisecond are told together.
  void change(std::size_t n, SimTime t, const std::string& value, bool all_told) {
    if (value == last_ && !value_.empty()) return;
    const bool at_once = !value_.empty() && milliseconds(t) == milliseconds(from_);
    if (!at_once) {
      finish(t);
      n_ = n, from_ = t;
    }
    value_ = at_once && all_told ? value_ + " → " + value : value;
    last_ = value;
  }

  void finish(SimTime t) {
    if (!value_.empty()) tiers_.add(tier_, n_, {from_, std::max(t, from_ + frame_time), {}}, value_);
    value_.clear();
  }

 private:
  TierMaker& tiers_;
  std::string tier_, value_, last_;
  std::size_t n_ = 0;
  SimTime from_{};
};

class RunTiers {
 public:
  explicit RunTiers(const RunIndex& run) : run_(run) {}

  Outcome read() {
    for (std::size_t n = 1; n < run_.size(); ++n) {
      const auto& kind = run_.kind(n);
      if (!told(kind)) continue;
      const auto record = run_.record(n);
      if (!record) return record.error();
      add(n, kind, run_.entry(n).t, *record);
    }
    return std::nullopt;
  }

  std::vector<Tier> finish(const std::vector<NoteOnRun>& notes) {
    const auto end = run_.entry(run_.size() - 1).t;
    for (const auto& [number, act] : under_way_) tiers_.add("avatar act", act.n, {act.from, end, {}}, act.program);
    states_.finish(end);
    stack_.finish(end);
    for (const auto& note : notes) {
      const auto from = run_.entry(note.n).t;
      const auto until = note.to > note.n ? std::optional(run_.entry(note.to).t) : std::nullopt;
      tiers_.add("note", note.n, {from, until, reading_time(note.text)}, note.text);
    }
    return tiers_.finish();
  }

 private:
  struct Act {
    std::size_t n = 0;
    SimTime from{};
    std::string program;
  };

  static bool told(const std::string& kind) {
    return log::is_any<log::Input, log::Observed, log::Mark, log::Expect, log::Utterance, log::AvatarGesture, log::Act,
                       log::Transition, log::Rewrite, log::Correction>(kind);
  }

  void add(std::size_t n, const std::string& kind, SimTime t, const Json& record) {
    if (log::is_any<log::Input, log::Observed, log::Mark, log::Expect>(kind))
      add_event(n, t, record);
    else if (log::is<log::Utterance>(kind))
      tiers_.add("avatar speech", n, {t, std::nullopt, reading_time(text_of(record, "text"))}, text_of(record, "text"));
    else if (log::is<log::AvatarGesture>(kind))
      tiers_.add("avatar gesture", n, {t, std::nullopt, gesture_time}, text_of(record, "gesture"));
    else if (log::is<log::Act>(kind))
      add_act(n, t, record);
    else
      add_step(n, t, record);
  }

  void add_event(std::size_t n, SimTime t, const Json& record) {
    const auto event = event_of_record(record, t);
    if (!event.is_null()) events_.add(n, member_of(record, "line").get<std::size_t>(), event);
  }

  void add_act(std::size_t n, SimTime t, const Json& record) {
    if (record.contains("step")) return;
    const auto status = text_of(record, "status"), program = text_of(record, "program");
    const auto number = text_of(record, "act");
    if (status == log::asked) return;
    if (status == "started") {
      under_way_.emplace(number, Act{n, t, program});
      return;
    }
    const auto found = under_way_.find(number);
    const auto act = found == under_way_.end() ? Act{n, t, program} : found->second;
    const auto reason = text_of(member_of(record, "result"), "reason");
    const auto how = status == "done" ? "" : ": " + status + (reason.empty() ? "" : ", " + reason);
    tiers_.add("avatar act", act.n, {act.from, std::max(t, act.from + frame_time), {}}, program + how);
    if (found != under_way_.end()) under_way_.erase(found);
  }

  void add_step(std::size_t n, SimTime t, const Json& record) {
    if (first_ && record.contains("from")) states_.change(0, {}, text_of(record, "from"), true);
    first_ = false;
    if (record.contains("to")) states_.change(n, t, text_of(record, "to"), true);
    if (record.contains("depth")) stack_.change(n, t, text_of(record, "depth"), false);
  }

  const RunIndex& run_;
  TierMaker tiers_;
  EventTiers events_{tiers_};
  Lasting states_{tiers_, "state"}, stack_{tiers_, "stack"};
  std::map<std::string, Act> under_way_;
  bool first_ = true;
};

}  // namespace

Json event_of_record(const Json& record, SimTime t) {
  const auto kind = text_of(record, "kind");
  const auto& members = log::is<log::Input>(kind)    ? member_of(record, "event")
                        : log::is<log::Expect>(kind) ? member_of(record, "expected")
                                                     : record;
  if (!member_of(record, "line").is_number_unsigned() || !members.is_object()) return nullptr;
  Json event{{"t", t.seconds()}, {"kind", log::is<log::Expect>(kind) ? kind : text_of(members, "kind")}};
  for (const auto& [name, value] : members.items())
    if (name != "n" && name != "line" && !event.contains(name)) event[name] = value;
  return event;
}

std::string trace_header_of_run(const Json& run) {
  TraceHeader header;
  header.scene = text_of(member_of(run, "scene"), "name");
  header.machine = text_of(member_of(run, "machine"), "name");
  if (const auto& seed = member_of(run, "seed"); seed.is_number_unsigned()) header.seed = seed.get<std::uint64_t>();
  if (text_of(run, "perspective") == "avatar") header.perspective = Perspective::avatar;
  if (const auto& parameters = member_of(run, "parameters"); parameters.is_object()) header.parameters = parameters;
  return write_header(header);
}

Result<Annotations> annotations_of_run(const RunIndex& run, const std::vector<NoteOnRun>& notes) {
  const auto& header = run.header();
  if (!header) return header.error();
  RunTiers tiers(run);
  if (auto problem = tiers.read()) return *problem;
  const auto end = milliseconds(run.entry(run.size() - 1).t);
  return Annotations{run.path(), "", trace_header_of_run(*header), {}, tiers.finish(notes), end};
}

}  // namespace continua
