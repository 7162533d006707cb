// The records of runs as tables.
#include "continua/replay/export/tables.h"

#include <filesystem>
#include <sstream>

#include "continua/replay/log/schema.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream text(*read_file(file.string()));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

TEST_CASE("Every record of two runs is a row under its kind, with the run's name") {
  const auto folder = fs::path(binary_dir()) / "tables_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  TableWriter tables(folder.string(), {});
  std::map<std::string, std::size_t> expected;
  for (const auto* name : {"building_blocks", "talk/speech_only"}) {
    const auto run = RunIndex::open(std::string(source_dir() + "/traces/") + name + ".run.jsonl");
    REQUIRE(run);
    REQUIRE_FALSE(tables.add(*run, name));
    for (const auto& kind : run->kinds()) expected[kind] += run->of_kind(kind).size();
  }
  REQUIRE_FALSE(tables.commit());
  for (const auto& schema : log::schema()) {
    const std::string kind(schema.kind.name);
    const auto columns = table_columns(kind);
    const auto lines = lines_of(folder / (kind + ".jsonl"));
    CHECK(lines.size() == expected[kind]);
    for (const auto& line : lines) {
      const Json row = Json::parse(line);
      REQUIRE(row.size() == columns.size() + 1);
      for (const auto& column : columns)
        if (column.type != "JSON") CHECK_FALSE(row[column.name].is_structured());
    }
  }
  const auto header = Json::parse(lines_of(folder / "run.jsonl").at(0));
  CHECK(header["machine_name"] == "diana2018");
  CHECK(header["run"] == "building_blocks");
  CHECK_FALSE(header.contains("machine_document"));
  CHECK(lines_of(folder / "utterance.csv").at(0) == "run,n,t,cause,measured,text,because");
  CHECK(lines_of(folder / "utterance.csv").at(1).starts_with("building_blocks,"));
}

TEST_CASE("No two columns of a table differ in case alone") {
  for (const auto& schema : log::schema()) {
    std::set<std::string> names = {"run"};
    for (const auto& column : table_columns(schema.kind.name)) {
      auto name = column.name;
      for (auto& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      INFO(schema.kind.name << "." << column.name);
      CHECK(names.insert(name).second);
    }
  }
}

}  // namespace
}  // namespace continua
