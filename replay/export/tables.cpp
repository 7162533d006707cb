#include "continua/replay/export/tables.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include "continua/core/replaced_file.h"
#include "continua/replay/export/csv_cell.h"
#include "continua/replay/export/each_record.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

// Large values of the first line: whole files, which their digests tell apart.
constexpr std::array<std::string_view, 9> documents = {"machine_document", "phrases_document", "knowledge",
                                                       "graph_states",     "graph_edges",      "scene_mjcf",
                                                       "scene_geoms",      "scene_bodies",     "learned"};

std::string type_of(const log::MemberSchema& member) {
  const auto& type = member.type;
  if (type.starts_with("integer")) return "BIGINT";
  if (type.starts_with("number")) return "DOUBLE";
  if (type.starts_with("boolean")) return "BOOLEAN";
  return type.starts_with("text") ? "VARCHAR" : "JSON";
}

void add_columns(const std::vector<log::MemberSchema>& members, const TableColumn& within,
                 std::vector<TableColumn>& columns) {
  for (const auto& member : members) {
    TableColumn column{within.name + std::string(member.name), type_of(member), within.path};
    column.path.emplace_back(member.name);
    if (!member.members.empty() && (member.type == "object" || member.type == "object or null")) {
      column.name += '_';
      add_columns(member.members, column, columns);
    } else if (std::find(documents.begin(), documents.end(), column.name) == documents.end()) {
      columns.push_back(std::move(column));
    }
  }
}

const Json& value_at(const Json& record, const std::vector<std::string>& path) {
  const Json* value = &record;
  for (const auto& name : path) value = &member_of(*value, name.c_str());
  return *value;
}

}  // namespace

std::vector<TableColumn> table_columns(std::string_view kind) {
  std::vector<TableColumn> columns;
  add_columns(log::stamp_schema(), {}, columns);
  if (const auto* schema = log::schema_of(kind)) add_columns(schema->members, {}, columns);
  return columns;
}

struct TableWriter::Table {
  std::string kind;
  std::vector<TableColumn> columns;
  std::unique_ptr<ReplacedFile> csv, lines;
  std::size_t rows = 0, bytes = 0, bytes_before = 0;  // before: the latest run

  Table(const std::string& of, const std::string& folder) : kind(of), columns(table_columns(of)) {
    csv = std::make_unique<ReplacedFile>(folder + "/" + kind + ".csv");
    lines = std::make_unique<ReplacedFile>(folder + "/" + kind + ".jsonl");
    csv->stream() << "run";
    for (const auto& column : columns) write_cell(column.name, csv->stream() << ',');
    csv->stream() << '\n';
  }

  void add(const std::string& run, const Json& record) {
    Json row = {{"run", run}};
    for (const auto& column : columns) row[column.name] = value_at(record, column.path);
    add(row);
  }

  void add(const Json& row) {
    write_value(row["run"], csv->stream());
    for (const auto& column : columns) write_value(member_of(row, column.name.c_str()), csv->stream() << ',');
    csv->stream() << '\n';
    const auto line = compact(row);
    lines->stream() << line << '\n';
    bytes += line.size() + 1;
    ++rows;
  }

  // DuckDB's; the paths are those of the folder.
  std::string view() const {
    std::string types = "run: 'VARCHAR'";
    for (const auto& column : columns) types += fmt::format(", \"{}\": '{}'", column.name, column.type);
    return fmt::format(
        "create or replace view \"{0}\" as from read_json('{0}.jsonl', format = 'newline_delimited', "
        "columns = {{{1}}});\n",
        kind, types);
  }
};

TableWriter::TableWriter(const std::string& folder, const std::vector<std::string>& kinds) : folder_(folder) {
  for (const auto& schema : log::schema()) {
    const std::string name(schema.kind.name);
    if (kinds.empty() || std::find(kinds.begin(), kinds.end(), name) != kinds.end()) tables_.emplace_back(name, folder);
  }
}

TableWriter::~TableWriter() = default;

Outcome TableWriter::add(const RunIndex& run, const std::string& name) {
  for (auto& table : tables_) table.bytes_before = table.bytes;
  const auto add = [&](const Json& record) {
    const auto kind = text_of(record, "kind");
    const auto table =
        std::find_if(tables_.begin(), tables_.end(), [&](const Table& each) { return each.kind == kind; });
    if (table != tables_.end()) table->add(name, record);
  };
  const auto& header = run.header();
  if (!header) return header.error();
  add(*header);
  return each_record(run, add);
}

Json TableWriter::latest_part() const {
  Json rows = Json::object();
  for (const auto& table : tables_)
    if (table.bytes > table.bytes_before) rows[table.kind] = {table.bytes_before, table.bytes - table.bytes_before};
  return {{"folder", folder_}, {"rows", std::move(rows)}};
}

Outcome TableWriter::add_part(const Json& part) {
  for (auto& table : tables_) {
    const auto& place = member_of(member_of(part, "rows"), table.kind.c_str());
    if (place.is_null()) continue;
    const auto path = fmt::format("{}/{}.jsonl", text_of(part, "folder"), table.kind);
    std::ifstream file(path, std::ios::binary);
    std::string text(place.at(1).get<std::size_t>(), '\0');
    file.seekg(place.at(0).get<std::streamoff>());
    if (!file.read(text.data(), static_cast<std::streamsize>(text.size())) || !text.ends_with('\n'))
      return Error{path, "has not the rows that its report tells"};
    for (std::size_t begin = 0; begin < text.size();) {
      const auto end = text.find('\n', begin);
      const auto row = parse_json_line(std::string_view(text).substr(begin, end - begin), path, table.rows + 1);
      if (!row) return row.error();
      if (!row->is_object() || !row->contains("run")) return Error{path, "has not the rows that its report tells"};
      table.add(*row);
      begin = end + 1;
    }
  }
  return std::nullopt;
}

Outcome TableWriter::commit() {
  std::string load = "-- Views of the tables beside this file, for DuckDB: duckdb -init load.sql\n";
  std::string all;
  for (auto& table : tables_) {
    if (auto problem = table.csv->commit()) return problem;
    if (auto problem = table.lines->commit()) return problem;
    load += table.view();
    all += fmt::format("{}  select run, n, t, cause, '{}' as kind from \"{}\"\n", all.empty() ? "" : "  union all\n",
                       table.kind, table.kind);
  }
  load += "create or replace view record as\n" + all + ";\n";
  return replace_file(folder_ + "/load.sql", load);
}

std::size_t TableWriter::rows() const {
  std::size_t rows = 0;
  for (const auto& table : tables_) rows += table.rows;
  return rows;
}

}  // namespace continua
