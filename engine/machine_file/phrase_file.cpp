#include "continua/machine_file/phrase_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/core/document_reader.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> phrase_files_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void check_case(const Item& item) {
  if (!item.expect_object("a case", {"when", "say", "about"})) return;
  item.member("when").text("a condition");
  const auto say = item.required("say", "what is said");
  if (!say.exists() || (say.is_text() && say.json() != "")) return;
  const auto ways = say.is_list() ? say.elements("ways to say it") : std::vector<Item>();
  const auto is_said = [](const Item& way) { return way.is_text() && way.json() != ""; };
  if (ways.empty() || !std::all_of(ways.begin(), ways.end(), is_said))
    say.mismatch("what is said, a string, or several ways to say it, a list of strings");
}

void check_phrase(const Item& phrase) {
  const auto cases = phrase.elements("the cases of a phrase");
  if (phrase.is_list() && cases.empty()) phrase.problem("found an empty list, expected the cases of a phrase");
  for (const auto& each : cases) check_case(each);
  for (std::size_t i = 0; i + 1 < cases.size(); ++i)
    if (cases[i].is_object() && !cases[i].member("when").exists())
      cases[i + 1].problem("never said: the case before it has no condition");
}

void check_phrases(const Item& root) {
  if (!root.expect_object("phrases", {"phrases", "about", "define", "wordings", "say"})) return;
  root.expect_version("phrases", 1);
  const auto say = root.required("say", "names and what is said, an object");
  for (const auto& [name, phrase] : say.members("names and what is said")) check_phrase(phrase);
}

}  // namespace

Result<LocatedJson> read_phrases(const std::string& name, const std::string& folder) {
  const auto path = (fs::path(folder) / (name + ".json")).lexically_normal().string();
  std::error_code unknown;
  if (!folder.empty() && fs::exists(path, unknown)) return LocatedJson::read(path);
  return Error{"", fmt::format("there are no phrases {}{}; expected {}", in_quotes(name),
                               did_you_mean(name, phrase_files_in(folder)),
                               folder.empty() ? "to be told their folder" : "a name in " + folder)};
}

std::vector<Error> phrase_problems(const LocatedJson& document) {
  DocumentReader reader;
  check_phrases(reader.root(document));
  return reader.problems();
}

}  // namespace continua
