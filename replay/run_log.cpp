#include "replay/run_log.h"

#include <algorithm>
#include <array>

namespace continua {
namespace {

// What must be equal on every machine; RUNLOG.md says so too.
constexpr std::array<std::string_view, 15> decision_kinds = {
    "input", "percept",   "reading", "belief", "memory",      "transition", "symbol", "rewrite",
    "gesture", "refusal", "expect", "application", "utterance",  "act",    "branches"};

// Numbers of records count poses too, and when an act ends is measured, as are margins and weights: none is a decision.
std::optional<Json> decision_of(std::string_view kind, double t_s, Json fields) {
  if (std::find(decision_kinds.begin(), decision_kinds.end(), kind) == decision_kinds.end()) return std::nullopt;
  for (const char* field : {"because", "margin", "result", "weights", "resolved"}) fields.erase(field);
  Json decision{{"kind", kind}, {"fields", std::move(fields)}};
  if (kind != "act" && !decision["fields"].contains("measured")) decision["t"] = t_s;
  return decision;
}

// Between which other records an act goes on and ends is measured: what it came to counts by the act's number, and its
// steps do not.
bool tells_outcome(std::string_view kind, const Json& fields) {
  return kind == "act" && fields.contains("act") && fields["act"].is_number() && fields.value("status", "") != "asked";
}

}  // namespace

std::optional<Json> decision_of(const Json& record) {
  if (!record.contains("kind") || !record["kind"].is_string()) return std::nullopt;
  Json fields = record;
  for (const char* field : {"kind", "n", "t", "cause"}) fields.erase(field);
  const bool timed = record.contains("t") && record["t"].is_number();
  return decision_of(record["kind"].get<std::string>(), timed ? record["t"].get<double>() : 0, std::move(fields));
}

int RunLog::write(std::string_view kind, SimTime t, const Json& fields, std::optional<int> cause) {
  Json record{{"kind", kind}, {"n", next_}, {"t", t.seconds()}};
  if (cause) record["cause"] = *cause;
  for (const auto& [key, value] : fields.items()) record[key] = value;
  const auto line = compact(record) + "\n";
  all_.add(line);
  if (kind == "pose") physics_.add(line);
  if (tells_outcome(kind, fields)) {
    if (!fields.contains("step"))
      outcomes_[fields["act"].get<std::int64_t>()] = compact(*decision_of(kind, t.seconds(), fields));
  } else if (const auto decision = decision_of(kind, t.seconds(), fields)) {
    decisions_.add(compact(*decision));
  }
  ++counts_[std::string(kind)];
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  out_.flush();
  return next_++;
}

void RunLog::finish(SimTime t) {
  for (const auto& [act, line] : outcomes_) decisions_.add(line);
  const Json fields{
      {"counts", counts_}, {"decisions", decisions_.text()}, {"physics", physics_.text()}, {"digest", all_.text()}};
  write("end", t, fields);
}

}  // namespace continua
