#include "continua/knowledge_files/language_loading.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/facts/world_facts.h"
#include "continua/knowledge_files/based_machine.h"
#include "continua/knowledge_files/deictic_program.h"
#include "continua/language/vocabulary.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/term/raising_file.h"
#include "continua/term/term_text.h"
#include "continua/voxml/catalogue.h"

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

fs::path lexicon_folder(const DataPaths& data, const std::string& name) {
  const auto known = data.knowledge / "lexicon" / name;
  return (is_folder(known) ? known : fs::path(name)).lexically_normal();
}

// A machine names a lexicon of its own by the path from its file.
void find_lexicon(Machine& machine, const std::string& path, const DataPaths& data) {
  if (machine.lexicon.empty() || is_folder(data.knowledge / "lexicon" / machine.lexicon)) return;
  const auto beside = fs::path(path).parent_path() / machine.lexicon;
  if (is_folder(beside)) machine.lexicon = beside.lexically_normal().string();
}

// Adds the digests of the files below `folder` (or of the file `folder`); keys are `name` and the path below it.
void add_digests(const fs::path& folder, const std::string& name, const std::string& ending, Json& digests) {
  std::error_code problem;
  std::vector<std::pair<std::string, fs::path>> files;
  if (fs::is_regular_file(folder, problem)) files.emplace_back(name, folder);
  for (auto file = fs::recursive_directory_iterator(folder, problem); file != fs::end(file); file.increment(problem))
    if (file->path().extension() == ending)
      files.emplace_back(name + "/" + file->path().lexically_relative(folder).generic_string(), file->path());
  std::sort(files.begin(), files.end());
  for (const auto& [key, path] : files)
    if (const auto text = read_file(path.string())) digests[key] = digest(*text);
}

}  // namespace

Json knowledge_digests(const DataPaths& data, const Machine& machine, const Language& language) {
  Json digests = Json::object();
  const auto name_of = [](const fs::path& path) { return path.filename().string(); };
  if (language.lexicon)
    for (const auto& folder : language.lexicon->folders)
      add_digests(folder, "lexicon/" + name_of(folder), ".json", digests);
  if (!machine.gestures.empty())
    if (const auto path = resolve_gestures(machine.gestures, data, ""))
      add_digests(*path, "gestures/" + name_of(*path), ".json", digests);
  add_digests(data.knowledge / "raising.json", "raising.json", ".json", digests);
  add_digests(data.knowledge / "voxemes", "voxemes", ".xml", digests);
  return digests;
}

Signature names_of_terms() {
  auto names = term_signature();
  names.insert(WorldFacts::signature().begin(), WorldFacts::signature().end());
  return names;
}

Result<std::shared_ptr<const Lexicon>> load_named_lexicon(const DataPaths& data, const std::string& name,
                                                          const std::string& where) {
  const auto folder = lexicon_folder(data, name);
  if (!is_folder(folder))
    return Error{where, fmt::format("there is no lexicon {}{}; expected a folder, or a name in {}", in_quotes(name),
                                    did_you_mean(name, folders_in(data.knowledge / "lexicon")),
                                    (data.knowledge / "lexicon").lexically_normal().string())};
  auto lexicon = load_lexicon(folder.string(), names_of_terms(), (data.knowledge / "lexicon").string());
  if (!lexicon) return lexicon.error();
  return std::make_shared<const Lexicon>(*std::move(lexicon));
}

Result<std::shared_ptr<const GestureCatalogue>> load_gestures(const DataPaths& data, const std::string& name,
                                                              const std::shared_ptr<const Lexicon>& lexicon,
                                                              const std::string& where) {
  const auto path = resolve_gestures(name, data, where);
  if (!path) return path.error();
  const auto text = read_file(*path);
  if (!text) return text.error();
  auto gestures = read_gestures(*text, *path);
  if (!gestures) return gestures.error();
  if (auto problems = check_meanings(*gestures, lexicon); !problems.empty()) return problems.front();
  return std::make_shared<const GestureCatalogue>(*std::move(gestures));
}

std::vector<Error> check_meanings(const GestureCatalogue& gestures, const std::shared_ptr<const Lexicon>& lexicon) {
  const auto names = lexicon ? Vocabulary(lexicon, WorldSnapshot()).names() : names_of_terms();
  std::vector<Error> problems;
  for (const auto& [gesture, entry] : gestures.entries)
    for (const auto& [direction, meaning] : entry.meanings) {
      const auto term = parse_term(meaning, names);
      if (!term)
        problems.push_back(
            {entry.where, fmt::format("what '{}' means, {}: {}", gesture, in_quotes(meaning), term.error().text())});
    }
  return problems;
}

Result<RaisingRules> load_raising(const DataPaths& data) {
  const auto path = data.knowledge / "raising.json";
  std::error_code unknown;
  if (!fs::exists(path, unknown)) return RaisingRules();
  return load_raising(path.lexically_normal().string(), names_of_terms());
}

Result<Machine> load_machine(const std::string& path, const DataPaths& data, const std::string& language,
                             const std::string& where) {
  const auto known = data.knowledge / "lexicon";
  if (!language.empty() && !is_folder(known / language))
    return Error{where,
                 fmt::format("there is no language {}{}; expected the name of a folder in {}", in_quotes(language),
                             did_you_mean(language, folders_in(known)), known.lexically_normal().string())};
  const auto raising = load_raising(data);
  if (!raising) return raising.error();
  const auto text = read_file(path);
  if (!text) return text.error();
  const auto based = based_machine(*text, path, data);
  if (!based) return based.error();
  const auto facts = WorldFacts::signature();
  const auto phrases = phrases_folder(data);
  auto machine = *based ? parse_machine((*based)->text, path, facts, phrases, language, *raising)
                        : load_machine(path, facts, phrases, language, *raising);
  if (!machine) return *based ? (*based)->told(machine.error(), path) : machine.error();
  find_lexicon(*machine, path, data);
  return machine;
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
  auto point = deictic_program(voxemes.catalogue);
  if (!point) return point.error();
  language.deixis = *std::move(point);
  language.voxemes = std::make_shared<const Catalogue>(std::move(voxemes.catalogue));
  if (!machine.gestures.empty()) {
    auto gestures =
        load_gestures(data, machine.gestures, language.lexicon, fmt::format("\"gestures\" of {}", machine.name));
    if (!gestures) return gestures.error();
    language.gestures = *std::move(gestures);
  }
  auto rules = load_raising(data);
  if (!rules) return rules.error();
  language.raising = *std::move(rules);
  return language;
}

}  // namespace continua
