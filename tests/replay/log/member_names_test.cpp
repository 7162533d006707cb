// Readers such as DuckDB do not tell names of members apart that differ only in case: of two such members one is lost.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "continua/core/located_json.h"
#include "continua/replay/log/log_file.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

std::string without_case(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
  return name;
}

// "place.N place.n" of such members in a value.
void find_alike(const Json& value, const std::string& place, std::string& found) {
  if (value.is_array())
    for (const auto& one : value) find_alike(one, place + "[]", found);
  if (!value.is_object()) return;
  std::map<std::string, std::string> names;
  for (const auto& [name, member] : value.items()) {
    const auto [at, is_new] = names.emplace(without_case(name), name);
    if (!is_new) found += place + "." + at->second + " " + place + "." + name + "\n";
    find_alike(member, place + "." + name, found);
  }
}

}  // namespace

TEST_CASE("no shipped log has members of one object that differ only in case") {
  std::string found;
  for (const auto& file : fs::recursive_directory_iterator(source_dir() + "/traces")) {
    if (!file.path().string().ends_with(".run.jsonl")) continue;
    const auto log = read_run_log(file.path().string()).value();
    for (std::size_t from = 0; from < log.size(); from = log.find('\n', from) + 1)
      find_alike(Json::parse(log.substr(from, log.find('\n', from) - from)), file.path().filename().string(), found);
  }
  CHECK(found == "");
}

TEST_CASE("no shipped machine gives a log such members") {
  std::string found;
  for (const auto& file : fs::recursive_directory_iterator(source_dir() + "/engine/knowledge/machines")) {
    if (file.path().extension() != ".json") continue;
    std::ifstream in(file.path());
    find_alike(Json::parse(in), file.path().filename().string(), found);
  }
  CHECK(found == "");
}
