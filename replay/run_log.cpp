#include "replay/run_log.h"

#include <algorithm>
#include <array>

namespace continua {
namespace {

// What must be equal on every machine; RUNLOG.md says so too.
constexpr std::array<std::string_view, 15> decision_kinds = {
    "input",   "reading", "belief", "memory",      "transition", "symbol", "rewrite", "gesture",
    "refusal", "expect",  "act",    "application", "utterance",  "end",    "branches"};

// That an act is asked for is a decision. When it ends, and between which other records, is measured; so what it came
// to counts at the end.
bool tells_outcome(std::string_view kind, const Json& fields) {
  return kind == "act" && fields.value("status", Json()) != "asked";
}

// Numbers of records count poses too; margins and weights are measured: none is a decision.
std::optional<Json> decision_of(std::string_view kind, double t_s, Json fields) {
  if (std::find(decision_kinds.begin(), decision_kinds.end(), kind) == decision_kinds.end()) return std::nullopt;
  if (tells_outcome(kind, fields)) return std::nullopt;
  if (kind == "end") fields = {{"acts", fields.value("acts", Json::array())}};
  for (const char* field : {"because", "margin", "result", "weights", "resolved"}) fields.erase(field);
  const bool timed = kind != "act" && kind != "end" && !fields.contains("measured");
  Json decision{{"kind", kind}, {"fields", std::move(fields)}};
  if (timed) decision["t"] = t_s;
  return decision;
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
  if (tells_outcome(kind, fields) && !fields.contains("step"))
    outcomes_[fields["act"].get<int>()] = fields["status"].get<std::string>();
  // The last line states the digest, and so what of itself goes into it.
  const auto decision = kind == "end" ? std::nullopt : decision_of(kind, t.seconds(), fields);
  if (decision) decisions_.add(compact(*decision));
  ++counts_[std::string(kind)];
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  out_.flush();
  return next_++;
}

void RunLog::finish(SimTime t) {
  Json acts = Json::array();
  for (const auto& [number, status] : outcomes_) acts.push_back(status);
  decisions_.add(compact(*decision_of("end", t.seconds(), {{"acts", acts}})));
  const Json fields{{"counts", counts_},
                    {"acts", std::move(acts)},
                    {"decisions", decisions_.text()},
                    {"physics", physics_.text()},
                    {"digest", all_.text()}};
  write("end", t, fields);
}

}  // namespace continua
