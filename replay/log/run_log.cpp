#include "continua/replay/log/run_log.h"

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/record_json.h"

namespace continua {
namespace {

// Takes out of `json`, a value of T, the members that are no decisions, however deep.
template <class T>
void keep_decisions(Json& json) {
  using Inner = log::Innermost<T>;
  if constexpr (log::HasFields<Inner>) {
    if (json.is_array())
      for (auto& element : json) keep_decisions<Inner>(element);
    if (!json.is_object()) return;
    log::for_each_field<Inner>([&]<class Struct, class Value>(const log::Field<Struct, Value>& field) {
      const auto found = json.find(field.name);
      if (found == json.end()) return;
      if (field.says == log::Says::aside || field.follows)
        json.erase(found);
      else
        keep_decisions<Value>(*found);
    });
  }
}

// Between which other records an act goes on and ends is measured: its outcome counts by the act's number.
bool tells_outcome(std::string_view kind, const Json& fields) {
  return log::is<log::Act>(kind) && fields.contains("act") && fields["act"].is_number_integer() &&
         (!fields.contains("status") || fields["status"] != "asked");
}

}  // namespace

bool is_decision(std::string_view kind) {
  bool counts = false;
  log::for_each_kind([&]<class T>() {
    if (T::kind.name == kind) counts = T::kind.decision != log::Decision::no;
  });
  return counts;
}

std::optional<Json> DecisionOrder::next(std::string_view kind, double t_s, Json fields) {
  if (!is_decision(kind)) return std::nullopt;
  log::for_each_kind([&]<class T>() {
    if (T::kind.name == kind) keep_decisions<T>(fields);
  });
  const bool timed = !log::is<log::Act>(kind) && !fields.contains("measured");
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

int RunLog::write(const log::Record& record, SimTime t, std::optional<int> cause, bool measured) {
  auto fields = log::members_of(record);
  if (measured) fields["measured"] = true;
  return write_record(log::kind_of(record), log::margin_of(record), t, fields, cause);
}

int RunLog::write(std::string_view kind, SimTime t, const Json& fields, std::optional<int> cause) {
  auto line = fields;
  line["kind"] = kind;
  return write_record(kind, log::margin_of(log::readable_part(line)), t, fields, cause);
}

int RunLog::write_record(std::string_view kind, double margin, SimTime t, const Json& fields,
                         std::optional<int> cause) {
  if (next_ % records_per_block == records_per_block - 1) close_block(t);
  if (margin < fragile_margin) fragile_.push_back({{"n", next_}, {"margin", margin}});
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
  if (log::is<log::Pose>(kind)) physics_.add(line);
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
