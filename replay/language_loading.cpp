#include "replay/language_loading.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "composition/methods.h"
#include "core/located_json.h"
#include "machine_file/machine_loader.h"
#include "term/raising_file.h"
#include "voxml/catalogue.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> folders_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem))
    if (entry.is_directory(problem)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

Signature names_of_terms() {
  auto names = term_signature();
  names.insert(Methods::signature().begin(), Methods::signature().end());
  return names;
}

Result<std::shared_ptr<const Lexicon>> load_named_lexicon(const DataPaths& data, const std::string& name,
                                                          const std::string& where) {
  const auto known = data.knowledge / "lexicon";
  const auto folder = is_folder(known / name) ? known / name : fs::path(name);
  if (!is_folder(folder))
    return Error{where, fmt::format("there is no lexicon {}{}; expected a folder, or a name in {}", in_quotes(name),
                                    did_you_mean(name, folders_in(known)), known.lexically_normal().string())};
  auto lexicon = load_lexicon(folder.lexically_normal().string(), names_of_terms());
  if (!lexicon) return lexicon.error();
  return std::make_shared<const Lexicon>(*std::move(lexicon));
}

Result<Machine> load_machine(const std::string& path, const DataPaths& data) {
  return load_machine(path, Methods::signature(), phrases_folder(data));
}

Result<Language> load_language(const DataPaths& data, const Machine& machine) {
  Language language;
  if (!machine.lexicon.empty()) {
    auto lexicon = load_named_lexicon(data, machine.lexicon, fmt::format("\"lexicon\" of {}", machine.name));
    if (!lexicon) return lexicon.error();
    language.lexicon = *std::move(lexicon);
  }
  auto voxemes = read_catalogue((data.knowledge / "voxemes").lexically_normal().string());
  if (!voxemes.problems.empty()) return voxemes.problems.front();
  language.voxemes = std::make_shared<const Catalogue>(std::move(voxemes.catalogue));
  const auto raising = data.knowledge / "raising.json";
  std::error_code unknown;
  if (!fs::exists(raising, unknown)) return language;
  auto rules = load_raising(raising.lexically_normal().string(), names_of_terms());
  if (!rules) return rules.error();
  language.raising = *std::move(rules);
  return language;
}

}  // namespace continua
