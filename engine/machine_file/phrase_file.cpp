#include "machine_file/phrase_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

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

class Checker {
 public:
  explicit Checker(const LocatedJson& document) : document_(document) {}

  std::vector<Error> check() {
    const Json& root = document_.root();
    for (const auto& [place, key] : document_.duplicates())
      note(place, fmt::format("the key {} a second time in this object", in_quotes(key)));
    if (expect_object(root, "", "phrases", {"phrases", "about", "say"})) {
      if (!root.contains("phrases") || root["phrases"] != 1)
        note("/phrases", "expected \"phrases\": 1, the version of the format");
      if (!root.contains("say"))
        note("", "there is no \"say\"; expected names and what is said, an object");
      else if (expect_object(root["say"], "/say", "names and what is said", {}))
        for (const auto& [name, cases] : root["say"].items()) check_phrase(cases, "/say/" + escaped(name));
    }
    std::stable_sort(problems_.begin(), problems_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Error> errors;
    for (const auto& [place, sentence] : problems_) errors.push_back(document_.error(place, sentence));
    return errors;
  }

 private:
  void check_phrase(const Json& cases, const std::string& pointer) {
    if (!cases.is_array() || cases.empty()) return note(pointer, "expected the cases of a phrase, a list");
    for (std::size_t i = 0; i < cases.size(); ++i) check_case(cases[i], pointer + "/" + std::to_string(i));
    for (std::size_t i = 0; i + 1 < cases.size(); ++i)
      if (cases[i].is_object() && !cases[i].contains("when"))
        note(pointer + "/" + std::to_string(i + 1), "never said: the case before it has no condition");
  }

  void check_case(const Json& json, const std::string& pointer) {
    if (!expect_object(json, pointer, "a case", {"when", "say", "about"})) return;
    for (const char* key : {"when", "about"})
      if (json.contains(key) && !json[key].is_string()) note(pointer + "/" + key, "expected a string");
    if (!json.contains("say")) return note(pointer, "there is no \"say\"; expected what is said");
    const Json& say = json["say"];
    const auto is_text = [](const Json& text) {
      return text.is_string() && !text.get_ref<const std::string&>().empty();
    };
    if (!is_text(say) && (!say.is_array() || say.empty() || !std::all_of(say.begin(), say.end(), is_text)))
      note(pointer + "/say", "expected what is said, a string, or several ways to say it, a list of strings");
  }

  // `keys` that it may have; none: any.
  bool expect_object(const Json& json, const std::string& pointer, const char* what,
                     const std::vector<std::string>& keys) {
    if (!json.is_object()) return note(pointer, fmt::format("expected {}, an object", what)), false;
    for (const auto& [key, value] : json.items())
      if (!keys.empty() && std::find(keys.begin(), keys.end(), key) == keys.end())
        note(document_.key_place(pointer + "/" + escaped(key)),
             fmt::format("unknown key {} of {}{}", in_quotes(key), what, did_you_mean(key, keys)));
    return true;
  }

  // As part of a JSON pointer (RFC 6901).
  static std::string escaped(const std::string& key) {
    std::string result;
    for (const char c : key) result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return result;
  }

  void note(TextPlace place, std::string sentence) { problems_.emplace_back(place, std::move(sentence)); }
  void note(const std::string& pointer, std::string sentence) { note(document_.place(pointer), std::move(sentence)); }

  const LocatedJson& document_;
  std::vector<std::pair<TextPlace, std::string>> problems_;
};

}  // namespace

Result<LocatedJson> read_phrases(const std::string& name, const std::string& folder) {
  const auto path = (fs::path(folder) / (name + ".json")).lexically_normal().string();
  std::error_code unknown;
  if (!folder.empty() && fs::exists(path, unknown)) return LocatedJson::read(path);
  return Error{"", fmt::format("there are no phrases {}{}; expected {}", in_quotes(name),
                               did_you_mean(name, phrase_files_in(folder)),
                               folder.empty() ? "to be told their folder" : "a name in " + folder)};
}

std::vector<Error> phrase_problems(const LocatedJson& document) { return Checker(document).check(); }

}  // namespace continua
