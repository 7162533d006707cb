#include "continua/replay/log/run_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace continua {
namespace {

// What must be equal on every machine; RUNLOG.md says so too.
constexpr std::array<std::string_view, 18> decision_kinds = {
    "input",   "percept", "reading",     "belief",    "memory", "transition", "symbol",  "rewrite",   "gesture",
    "refusal", "expect",  "application", "utterance", "act",    "branches",   "learned", "forgotten", "correction"};

// Between which other records an act goes on and ends is measured: what it came to counts by the act's number.
bool tells_outcome(std::string_view kind, const Json& fields) {
  return kind == "act" && fields.contains("act") && fields["act"].is_number_integer() &&
         (!fields.contains("status") || fields["status"] != "asked");
}

}  // namespace

bool is_decision(std::string_view kind) {
  return std::find(decision_kinds.begin(), decision_kinds.end(), kind) != decision_kinds.end();
}

// Numbers of records count poses too, and when an act ends is measured, as are margins and weights: none is a decision.
std::optional<Json> DecisionOrder::next(std::string_view kind, double t_s, Json fields) {
  if (!is_decision(kind)) return std::nullopt;
  for (const char* field : {"because", "margin", "result", "weights", "resolved", "entries", "rules"})
    fields.erase(field);
  // Why a condition did not hold may be measured: values of the world at that moment.
  if (fields.contains("refused") && fields["refused"].is_array())
    for (auto& refused : fields["refused"])
      if (refused.is_object()) refused.erase("reason");
  const bool timed = kind != "act" && !fields.contains("measured");
  Json decision{{"kind", kind}, {"fields", std::move(fields)}};
  if (timed) decision["t"] = t_s;
  const auto& what = decision["fields"];
  if (!tells_outcome(kind, what)) return decision;
  if (!what.contains("step")) outcomes_[what["act"].get<std::int64_t>()] = decision;
  return std::nullopt;
}

std::optional<Json> DecisionOrder::next(const Json& record) {
  if (!record.is_object() || !record.contains("kind") || !record["kind"].is_string()) return std::nullopt;
  Json fields = record;
  for (const char* field : {"kind", "n", "t", "cause"}) fields.erase(field);
  const bool timed = record.contains("t") && record["t"].is_number();
  return next(record["kind"].get<std::string>(), timed ? record["t"].get<double>() : 0, std::move(fields));
}

std::vector<Json> DecisionOrder::outcomes() const {
  std::vector<Json> all;
  for (const auto& [act, outcome] : outcomes_) all.push_back(outcome);
  return all;
}

double margin_of(std::string_view kind, const Json& fields) {
  double least = std::numeric_limits<double>::infinity();
  const auto note = [&](const Json& object) {
    if (!object.is_object()) return;
    const auto margin = object.find("margin");
    if (margin != object.end() && margin->is_number()) least = std::min(least, std::abs(margin->get<double>()));
  };
  if (kind != "transition" && kind != "reading") return least;
  note(fields);
  if (const auto resolved = fields.find("resolved"); resolved != fields.end())
    for (const auto& resolution : *resolved) note(resolution);
  return least;
}

int RunLog::write(std::string_view kind, SimTime t, const Json& fields, std::optional<int> cause) {
  if (next_ % records_per_block == records_per_block - 1) close_block(t);
  if (const double margin = margin_of(kind, fields); margin < fragile_margin)
    fragile_.push_back({{"n", next_}, {"margin", margin}});
  return write_line(kind, t, fields, cause);
}

void RunLog::close_block(SimTime t) {
  const auto digest = block_.text();
  block_ = RunningDigest();
  block_.add(digest);
  write_line("block", t, {{"records", {next_ - records_per_block + 1, next_ - 1}}, {"digest", digest}}, std::nullopt);
}

int RunLog::write_line(std::string_view kind, SimTime t, const Json& fields, std::optional<int> cause) {
  Json record{{"kind", kind}, {"n", next_}, {"t", t.seconds()}};
  if (cause) record["cause"] = *cause;
  for (const auto& [key, value] : fields.items()) record[key] = value;
  const auto line = compact(record) + "\n";
  all_.add(line);
  block_.add(line);
  if (kind == "pose") physics_.add(line);
  if (const auto decision = decision_order_.next(kind, t.seconds(), fields)) decisions_.add(compact(*decision));
  ++counts_[std::string(kind)];
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  out_.flush();
  return next_++;
}

void RunLog::finish(SimTime t) {
  for (const auto& outcome : decision_order_.outcomes()) decisions_.add(compact(outcome));
  if (next_ % records_per_block == records_per_block - 1) close_block(t);
  const Json fields{{"counts", counts_},
                    {"fragile", fragile_},
                    {"decisions", decisions_.text()},
                    {"physics", physics_.text()},
                    {"digest", all_.text()}};
  write_line("end", t, fields, std::nullopt);
}

}  // namespace continua
