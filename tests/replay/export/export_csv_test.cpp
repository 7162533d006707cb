#include <sstream>

#include "continua/replay/export/csv.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

std::string table_of(const std::string& log) {
  const auto run = RunIndex::of_text(log, "small.run.jsonl").value();
  std::ostringstream out;
  REQUIRE_FALSE(export_csv(run, out));
  return out.str();
}

const std::string header = R"({"kind":"run","n":0,"t":0,"version":1})"
                           "\n";

// A reader of RFC 4180, to read the output again.
std::vector<std::vector<std::string>> cells_of(const std::string& table) {
  std::vector<std::vector<std::string>> rows = {{""}};
  bool quoted = false;
  for (std::size_t at = 0; at < table.size(); ++at) {
    const char c = table[at];
    if (quoted && c == '"' && at + 1 < table.size() && table[at + 1] == '"')
      rows.back().back() += table[++at];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      rows.back().emplace_back();
    else if (!quoted && c == '\n')
      rows.push_back({""});
    else
      rows.back().back() += c;
  }
  rows.pop_back();
  return rows;
}

}  // namespace

TEST_CASE("a table has a row for each record and a column for each member") {
  CHECK(table_of(header + R"({"kind":"input","n":1,"t":1.5,"event":{"kind":"speech","text":"Put, it."}})"
                          "\n"
                          R"({"kind":"utterance","n":2,"t":1.5,"cause":1,"text":"Say \"where\"?\nHere.","because":[1]})"
                          "\n"
                          R"({"kind":"expect","n":3,"t":2,"met":true,"found":null})"
                          "\n") ==
        "n,t,kind,cause,event,text,because,met,found\n"
        "1,1.5,input,,\"{\"\"kind\"\":\"\"speech\"\",\"\"text\"\":\"\"Put, it.\"\"}\",,,,\n"
        "2,1.5,utterance,1,,\"Say \"\"where\"\"?\nHere.\",[1],,\n"
        "3,2,expect,,,,,true,\n");
}

TEST_CASE("nothing of the records is lost in the table") {
  const auto log = small_log().text();
  const auto run = RunIndex::of_text(log, "small.run.jsonl").value();
  const auto rows = cells_of(table_of(log));
  REQUIRE(rows.size() == run.size());
  for (std::size_t n = 1; n < run.size(); ++n) {
    const auto record = run.record(n).value();
    REQUIRE(rows[n].size() == rows[0].size());
    for (std::size_t column = 0; column < rows[0].size(); ++column) {
      INFO(n << " " << rows[0][column]);
      const auto value = record.value(rows[0][column], Json());
      CHECK(rows[n][column] == (value.is_null() ? "" : value.is_string() ? value.get<std::string>() : compact(value)));
    }
    for (const auto& [name, value] : record.items())
      CHECK(std::find(rows[0].begin(), rows[0].end(), name) != rows[0].end());
  }
}

TEST_CASE("a run of nothing but a header is a table without rows") { CHECK(table_of(header) == "n,t,kind,cause\n"); }
