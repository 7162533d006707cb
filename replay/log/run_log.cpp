#include "continua/replay/log/run_log.h"

#include <algorithm>

#include "continua/replay/log/schema.h"

namespace continua {
namespace {

using log::Act;
using log::MemberSchema;
using log::name_of;

// Numbers of records count poses too, and when an act ends is measured, as are margins and weights: none is a decision.
void erase_asides(Json& value, const std::vector<MemberSchema>& members) {
  if (value.is_array())
    for (auto& element : value) erase_asides(element, members);
  if (!value.is_object()) return;
  for (const auto& member : members) {
    const auto found = value.find(member.name);
    if (found == value.end()) continue;
    if (member.says == log::Says::aside || member.follows)
      value.erase(found);
    else if (!member.members.empty())
      erase_asides(*found, member.members);
  }
}

// The records between which an act goes on and ends are measured: its outcome counts by the act's number.
std::optional<std::int64_t> ended_act(const Json& fields) {
  const auto act = fields.find(name_of(&Act::act)), status = fields.find(name_of(&Act::status));
  const bool asked = status != fields.end() && *status == log::asked;
  if (act == fields.end() || !act->is_number_integer() || asked) return std::nullopt;
  return act->get<std::int64_t>();
}

}  // namespace

bool is_decision(std::string_view kind) {
  const auto* known = log::schema_of(kind);
  return known && known->is_decision();
}

std::optional<Json> DecisionOrder::next(const Json& record) {
  if (!record.is_object() || !record.contains("kind") || !record["kind"].is_string()) return std::nullopt;
  const auto& name = record["kind"].get_ref<const std::string&>();
  const auto* kind = log::schema_of(name);
  if (!kind || !kind->is_decision()) return std::nullopt;
  Json fields = record;
  fields.erase("kind");
  for (const auto part : {name_of(&log::Stamp::n), name_of(&log::Stamp::t_s), name_of(&log::Stamp::cause)})
    fields.erase(part);
  erase_asides(fields, kind->members);
  const bool outcome = kind->kind.decision == log::Decision::outcome;
  const bool timed = !outcome && !fields.contains(name_of(&log::Stamp::measured));
  Json decision{{"kind", name}, {"fields", std::move(fields)}};
  if (timed) decision["t"] = log::stamp_of(record).t_s;
  const auto act = outcome ? ended_act(decision["fields"]) : std::nullopt;
  if (!act) return decision;
  if (!decision["fields"].contains(name_of(&Act::step))) outcomes_[*act] = std::move(decision);
  return std::nullopt;
}

std::vector<Json> DecisionOrder::outcomes() const {
  std::vector<Json> all;
  for (const auto& [act, outcome] : outcomes_) all.push_back(outcome);
  return all;
}

RunLog::RunLog(std::ostream& out) : out_(out) {
  constexpr std::size_t usual_size = 1 << 20;  // the first block has the run's documents
  if (out_.rdbuf()) block_.reserve(usual_size);
}

int RunLog::write(const log::Record& record, SimTime t, std::optional<int> cause, bool measured) {
  if (next_ % records_per_block == records_per_block - 1) close_block(t);
  if (const double margin = log::margin_of(record); margin < fragile_margin) fragile_.push_back({next_, margin});
  return write_line(record, t, cause, measured);
}

void RunLog::add_block_to_all() { all_.add(block_.view().substr(block_begin_)); }

void RunLog::close_block(SimTime t) {
  add_block_to_all();
  const auto closed = digest(block_.view());
  block_.clear();
  block_.put(closed);
  block_begin_ = block_.size();
  write_line(log::Block{{next_ - records_per_block + 1, next_ - 1}, closed}, t);
}

int RunLog::write_line(const log::Record& record, SimTime t, std::optional<int> cause, bool measured) {
  count(log::kind_of(record));
  if (!out_.rdbuf()) return next_++;
  const auto begin = block_.size();
  decision_.clear();
  writer_.add({next_, t.seconds(), cause, measured}, record, block_, decision_);
  block_.put('\n');
  const auto line = block_.view().substr(begin);
  if (std::holds_alternative<log::Pose>(record)) physics_.add(line);
  if (decision_.size() > 0) decide(record);
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  return next_++;
}

void RunLog::count(std::string_view kind) {
  const auto known = counts_.find(kind);
  if (known == counts_.end())
    counts_.emplace(kind, 1);
  else
    ++known->second;
}

// As DecisionOrder does: of an act that was asked for only the outcome counts, by the act's number.
void RunLog::decide(const log::Record& record) {
  const auto* act = std::get_if<Act>(&record);
  if (!act || act->status == log::asked)
    decisions_.add(decision_.view());
  else if (!act->step)
    outcomes_[act->act] = decision_.view();
}

void RunLog::finish(SimTime t) {
  for (const auto& [act, outcome] : outcomes_) decisions_.add(outcome);
  if (next_ % records_per_block == records_per_block - 1) close_block(t);
  add_block_to_all();
  write_line(log::End{.counts = {counts_.begin(), counts_.end()},
                      .fragile = fragile_,
                      .decisions = decisions_.text(),
                      .physics = physics_.text(),
                      .digest = all_.text()},
             t);
}

}  // namespace continua
