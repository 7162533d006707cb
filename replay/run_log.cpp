#include "replay/run_log.h"

#include <algorithm>
#include <array>

namespace continua {
namespace {

// What must be equal on every machine; RUNLOG.md says so too.
constexpr std::array<std::string_view, 16> decision_kinds = {
    "input",   "reading", "belief",      "memory",    "transition", "symbol",   "rewrite", "gesture",
    "refusal", "expect",  "application", "utterance", "act",        "branches", "learned", "forgotten"};

// Numbers of records count poses too, and when an act ends is measured, as are margins and weights: none is a decision.
std::string decision_line(std::string_view kind, SimTime t, Json fields) {
  for (const char* field : {"because", "margin", "result", "weights", "resolved"}) fields.erase(field);
  Json line{{"kind", kind}, {"fields", std::move(fields)}};
  if (kind != "act") line["t"] = t.seconds();
  return compact(line);
}

}  // namespace

int RunLog::write(std::string_view kind, SimTime t, const Json& fields, std::optional<int> cause) {
  Json record{{"kind", kind}, {"n", next_}, {"t", t.seconds()}};
  if (cause) record["cause"] = *cause;
  for (const auto& [key, value] : fields.items()) record[key] = value;
  const auto line = compact(record) + "\n";
  all_.add(line);
  if (kind == "pose") physics_.add(line);
  if (std::find(decision_kinds.begin(), decision_kinds.end(), kind) != decision_kinds.end())
    decisions_.add(decision_line(kind, t, fields));
  ++counts_[std::string(kind)];
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  out_.flush();
  return next_++;
}

void RunLog::finish(SimTime t) {
  const Json fields{
      {"counts", counts_}, {"decisions", decisions_.text()}, {"physics", physics_.text()}, {"digest", all_.text()}};
  write("end", t, fields);
}

}  // namespace continua
