// Runs as tables: one for each kind of record over any number of runs, for spreadsheets and databases.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// A column of a table.
struct TableColumn {
  std::string name;               ///< members of objects are columns of their own: "machine_digest"
  std::string type;               ///< of SQL: VARCHAR, BIGINT, DOUBLE, BOOLEAN, JSON
  std::vector<std::string> path;  ///< the names of the members that lead to the value
};

/// The columns of a kind of records, after `run`; those of `run` itself leave out the documents. A member that holds a
/// list or an object without declared members is of type JSON.
std::vector<TableColumn> table_columns(std::string_view kind);

/// Writes tables into a folder: KIND.csv, KIND.jsonl with the same rows, and load.sql, which makes a view of each with
/// the types of its columns, and a view `record` of all with the columns that they share.
class TableWriter {
 public:
  /// `kinds`: those that are wanted; empty: all.
  TableWriter(const std::string& folder, const std::vector<std::string>& kinds);
  ~TableWriter();
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  /// Adds the records of a run. `name`: the key of its rows. Error: a record cannot be read.
  Outcome add(const RunIndex& run, const std::string& name);

  /// Adds the rows of a run that another writer wrote. `part` is that one's latest_part(). Errors: its tables cannot be
  /// read, or are others.
  Outcome add_part(const Json& part);

  /// The place of the latest run's rows: {"folder", "rows": {KIND: [first byte, bytes]}} in the tables of JSON Lines.
  Json latest_part() const;

  /// Puts all tables in their places. Error: one could not be written.
  Outcome commit();

  std::size_t rows() const;

 private:
  struct Table;
  std::string folder_;
  std::vector<Table> tables_;
};

}  // namespace continua
