// The tables of RECORDS.md are printed from the declarations of records. To print them anew:
//   CONTINUA_RENEW_PAGES=1 build/tests/test_replay "RECORDS.md*"
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "continua/replay/log/log_file.h"
#include "continua/replay/log/records.h"
#include "continua/replay/log/schema.h"
#include "log/line_of.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const fs::path page_path = fs::path(source_dir()) / "replay/log/RECORDS.md";
// The page is printed from here on; prose stands above.
const std::string first_heading = "\n## Members of every record\n";

constexpr std::size_t longest_example = 600;

using Examples = std::map<std::string, std::string, std::less<>>;

std::string type_of(const log::MemberSchema& member) {
  std::string type = member.type == "any" ? "JSON" : member.type;
  if (member.form == "term" && type.starts_with("text")) type.replace(0, 4, "term");
  if (!member.form.empty() && member.form != "term") type += fmt::format(", {}", member.form);
  return member.left_out ? type + "; optional" : type;
}

void add_rows(std::string& text, const std::vector<log::MemberSchema>& members, const std::string& above, bool counts) {
  for (const auto& member : members) {
    const auto name = above + std::string(member.name);
    const bool decides = counts && member.says != log::Says::aside && !member.follows;
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", name, type_of(member), log::name_of(member.says),
                        decides ? "yes" : "", member.sentence);
    const bool several = member.type.find("list of") != std::string::npos;
    add_rows(text, member.members, name + (several ? "[]." : "."), decides);
  }
}

std::string table_of(const std::vector<log::MemberSchema>& members, bool counts) {
  std::string text = "| member | type | says | decides | meaning |\n| --- | --- | --- | --- | --- |\n";
  add_rows(text, members, "", counts);
  return text;
}

std::string decision_sentence(log::Decision decision) {
  switch (decision) {
    case log::Decision::no:
      return "No decision.";
    case log::Decision::yes:
      return "A decision.";
    case log::Decision::outcome:
      return "A decision when asked for, and in the last status of each; its `t` is none.";
  }
  return {};
}

std::string tables(const Examples& examples) {
  std::string text = first_heading + "\n" + table_of(log::stamp_schema(), false);
  for (const auto& [kind, members] : log::schema()) {
    text += fmt::format("\n## `{}`\n\n{} {}\n", kind.name, kind.when, decision_sentence(kind.decision));
    if (const auto example = examples.find(kind.name); example != examples.end())
      text += fmt::format("Example: `` {} ``\n", example->second);
    text += "\n" + table_of(members, kind.decision != log::Decision::no);
  }
  return text;
}

// Long values cut, and marked by "…".
Json shortened(const Json& value, int depth = 0) {
  if (value.is_string() && value.get_ref<const std::string&>().size() > 48)
    return value.get_ref<const std::string&>().substr(0, 16) + "…";
  if (!value.is_structured() || value.empty()) return value;
  if (depth > 2) return "…";
  if (value.is_array() && value.size() > 2) return Json::array({shortened(value[0], depth + 1), "…"});
  Json short_value = value.is_object() ? Json::object() : Json::array();
  for (const auto& [name, element] : value.items()) {
    if (value.is_array()) {
      short_value.push_back(shortened(element, depth + 1));
    } else if (depth > 0 && short_value.size() == 4) {
      short_value["…"] = "…";
      break;
    } else {
      short_value[name] = shortened(element, depth + 1);
    }
  }
  return short_value;
}

std::string kind_in(const Json& line) { return line.at("kind").get<std::string>(); }

// Of each kind the line of the approved runs with the most members that is not too long.
Examples approved_examples() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir()) / "traces"))
    if (entry.path().string().ends_with(".run.jsonl")) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::map<std::string, Json> best;
  for (const auto& path : paths) {
    std::istringstream file(read_run_log(path.string()).value());
    for (std::string text; std::getline(file, text);) {
      const auto line = Json::parse(text);
      auto& found = best[kind_in(line)];
      if (found.is_null() || (text.size() <= longest_example && line.size() > found.size())) found = line;
    }
  }
  Examples examples;
  for (const auto& [kind, line] : best)
    examples[kind] = compact(line).size() <= longest_example ? compact(line) : compact(shortened(line));
  return examples;
}

// The examples in the page, which stay as they are.
Examples examples_in(const std::string& page) {
  Examples examples;
  const std::string begin = "\nExample: `` ", end = " ``\n";
  for (auto at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    at += begin.size();
    const auto text = page.substr(at, page.find(end, at) - at);
    examples[kind_in(Json::parse(text))] = text;
  }
  return examples;
}

std::string read_page() { return read_file(page_path.string()).value(); }

}  // namespace

TEST_CASE("RECORDS.md has the tables that records declare") {
  const auto page = read_page();
  const auto from = page.find(first_heading);
  REQUIRE(from != std::string::npos);
  auto examples = examples_in(page);
  if (std::getenv("CONTINUA_RENEW_PAGES")) {
    examples.merge(approved_examples());
    std::ofstream(page_path) << page.substr(0, from) << tables(examples);
  }
  CHECK(read_page().substr(from) == tables(examples));
}

TEST_CASE("RECORDS.md has an example of every kind, with members that the kind declares") {
  const auto examples = examples_in(read_page());
  for (const auto& [kind, members] : log::schema()) {
    INFO(kind.name);
    const auto example = examples.find(kind.name);
    REQUIRE(example != examples.end());
    const auto line = Json::parse(example->second);
    if (example->second.find("…") == std::string::npos)
      CHECK(line_of(log::stamp_of(line), *log::read_record(line)) == example->second);
    for (const auto& [name, value] : line.items()) {
      const auto named = [&name = name](const log::MemberSchema& member) { return member.name == name; };
      const auto& stamp = log::stamp_schema();
      CHECK((name == "kind" || std::any_of(stamp.begin(), stamp.end(), named) ||
             std::any_of(members.begin(), members.end(), named)));
    }
  }
}
