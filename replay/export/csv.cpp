#include "continua/replay/export/csv.h"

#include <ostream>
#include <string>
#include <unordered_set>
#include <vector>

#include "continua/replay/export/csv_cell.h"
#include "continua/replay/export/each_record.h"

namespace continua {
Outcome export_csv(const RunIndex& run, std::ostream& out) {
  std::vector<std::string> columns = {"n", "t", "kind", "cause"};
  std::unordered_set<std::string> known(columns.begin(), columns.end());
  const auto note_members = [&](const Json& record) {
    for (const auto& [name, value] : record.items())
      if (known.insert(name).second) columns.push_back(name);
  };
  if (auto problem = each_record(run, note_members)) return problem;
  for (const auto& name : columns) {
    if (&name != &columns.front()) out << ',';
    write_cell(name, out);
  }
  out << '\n';
  const auto write_row = [&](const Json& record) {
    for (const auto& name : columns) {
      if (&name != &columns.front()) out << ',';
      if (const auto found = record.find(name); found != record.end()) write_value(*found, out);
    }
    out << '\n';
  };
  if (auto problem = each_record(run, write_row)) return problem;
  if (!out) return Error{run.path(), "the export could not be written"};
  return std::nullopt;
}

}  // namespace continua
