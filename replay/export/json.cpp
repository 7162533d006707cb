#include "continua/replay/export/json.h"

#include <ostream>
#include <sstream>
#include <unordered_map>

namespace continua {
namespace {

// The slots of the stack's symbols, top first. Symbols are read once and kept: neighbouring stacks share most of them.
class Snapshots {
 public:
  explicit Snapshots(const RunIndex& run) : run_(run) {}

  Result<Json> of(std::int64_t top) {
    Json slots = Json::array();
    for (const auto id : run_.stack_ids(top)) {
      auto known = known_.find(id);
      if (known == known_.end()) {
        const auto symbol = run_.record(run_.symbol(id)->n);
        if (!symbol) return symbol.error();
        known = known_.emplace(id, symbol->value("slots", Json::object())).first;
      }
      slots.push_back(known->second);
    }
    return slots;
  }

 private:
  const RunIndex& run_;
  std::unordered_map<std::int64_t, Json> known_;
};

// Indented by `depth` levels of two spaces, its first line not.
std::string pretty(const Json& value, int depth) {
  const auto text = value.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '\n') out.append(static_cast<std::size_t>(2 * depth), ' ');
  }
  return out;
}

}  // namespace

Outcome export_json(const RunIndex& run, std::ostream& out) {
  const auto& header = run.header();
  if (!header) return header.error();
  out << "{\n  \"header\": " << pretty(*header, 1) << ",\n  \"records\": [";

  Snapshots snapshots(run);
  const auto last = run.complete() ? run.size() - 1 : run.size();
  for (std::size_t n = 1; n < last; ++n) {
    auto record = run.record(n);
    if (!record) return record.error();
    if (const auto stack = record->find("stack"); stack != record->end()) {
      auto snapshot = snapshots.of(stack->is_number_integer() ? stack->get<std::int64_t>() : -1);
      if (!snapshot) return snapshot.error();
      (*record)["snapshot"] = *std::move(snapshot);
    }
    out << (n == 1 ? "\n    " : ",\n    ") << pretty(*record, 2);
  }
  out << (last > 1 ? "\n  ],\n" : "],\n") << "  \"end\": ";
  if (run.complete()) {
    const auto end = run.record(run.size() - 1);
    if (!end) return end.error();
    out << pretty(*end, 1);
  } else {
    out << "null";
  }
  out << "\n}\n";
  if (!out) return Error{run.path(), "the export could not be written"};
  return std::nullopt;
}

Result<std::string> export_json(const RunIndex& run) {
  std::ostringstream out;
  if (auto problem = export_json(run, out)) return *problem;
  return out.str();
}

}  // namespace continua
