// A lexicon section by section, from the documents of its folder.
#include "continua/language/lexicon_reader.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/term/evaluate.h"

namespace continua {
namespace {

const std::vector<std::string> sections = {
    "about",      "categories", "names", "define",   "determiners", "proforms",    "words",   "skip",
    "attributes", "plural",     "unary", "examples", "sample",      "learned",     "unknown", "numbers",
    "nouns",      "asides",     "forms", "taken",    "contracted",  "apostrophes", "scope",   "based_on"};

}  // namespace

LexiconReader::LexiconReader(const std::vector<LocatedJson>& documents, const Signature& facts) : facts_(facts) {
  lexicon_.names = term_signature();
  lexicon_.names.insert(facts.begin(), facts.end());
  for (const auto& document : documents) roots_.push_back(reader_.root(document));
}

Lexicon LexiconReader::read() {
  RunningDigest digest;
  for (const auto& root : roots_) {
    root.expect_object("a part of a lexicon", sections);
    digest.add(compact(root.json()));
    digest.add("\n");
  }
  lexicon_.digest = digest.text();
  read_atoms();
  read_names();
  read_determiners();
  read_proforms();
  read_definitions();
  read_scope();
  read_words();
  read_attributes();
  read_plurals();
  read_forms();
  read_contracted();
  read_apostrophes();
  read_rules();
  lexicon_.learned = read_name_templates("learned");
  lexicon_.unknown = read_name_templates("unknown");
  lexicon_.taken = read_name_templates("taken");
  lexicon_.nouns = read_name_templates("nouns");
  lexicon_.numbers = read_name_templates("numbers");
  read_sample();
  return std::move(lexicon_);
}

std::vector<NamedItem> LexiconReader::members_of(const std::string& section, const char* what) const {
  std::vector<NamedItem> all;
  for (const auto& root : roots_)
    for (auto& member : root.member(section).members(what)) all.push_back(std::move(member));
  return all;
}

std::vector<Item> LexiconReader::elements_of(const std::string& section, const char* what) const {
  std::vector<Item> all;
  for (const auto& root : roots_)
    for (auto& element : root.member(section).elements(what)) all.push_back(std::move(element));
  return all;
}

void problem_with_quote(const Item& item, const Error& error) {
  item.problem_in_text(byte_of_column(error), fmt::format("{}, in {}", error.sentence, in_quotes(item.text("a term"))));
}

namespace fs = std::filesystem;

Result<std::vector<LocatedJson>> documents_in(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
    if (each->path().extension() == ".json") paths.push_back(each->path());
  if (error)
    return Error{folder.string(), fmt::format("cannot be read: {}; expected a folder of JSON files", error.message())};
  if (paths.empty())
    return Error{folder.string(), "there is no *.json in this folder; expected the files of a lexicon"};
  std::sort(paths.begin(), paths.end());
  std::vector<LocatedJson> documents;
  for (const auto& path : paths) {
    auto document = LocatedJson::read(path.string());
    if (!document) return document.error();
    documents.push_back(*std::move(document));
  }
  return documents;
}

namespace {

// The folder of a lexicon that another one is based on: a name in `known`, or a path from the other's folder.
fs::path base_folder(const std::string& name, const fs::path& folder, const std::string& known) {
  const auto named = fs::path(known) / name;
  std::error_code unknown;
  return (!known.empty() && fs::is_directory(named, unknown) ? named : folder / name).lexically_normal();
}

// The documents of lexicons that are based on one another.
class Documents {
 public:
  explicit Documents(const std::string& known) : known_(known) {}

  const std::vector<LocatedJson>& all() const { return all_; }
  /// In the order of the documents.
  const std::vector<std::string>& folders() const { return folders_; }

  /// Those of the folder in the order of their names, after those of its base; or the first problem.
  Outcome read(const fs::path& folder) {
    begun_.push_back(folder);
    auto own = documents_in(folder);
    if (!own) return own.error();
    for (const auto& document : *own)
      if (auto problem = read_base(document, folder)) return problem;
    std::move(own->begin(), own->end(), std::back_inserter(all_));
    folders_.push_back(folder.string());
    return std::nullopt;
  }

 private:
  // Reads the base that a document names, if it names one. A folder counts once, whoever names it.
  Outcome read_base(const LocatedJson& document, const fs::path& folder) {
    DocumentReader reader;
    const auto told = reader.root(document).member("based_on");
    if (!told.exists()) return std::nullopt;
    const auto name = told.text("the name of a lexicon, or the path of its folder");
    if (reader.sound()) {
      const auto base = base_folder(name, folder, known_);
      std::error_code unknown;
      if (!fs::is_directory(base, unknown))
        told.problem(fmt::format("there is no folder {}; expected the name of a lexicon, or the path of its folder",
                                 in_quotes(base.string())));
      else if (std::find(begun_.begin(), begun_.end(), base) == begun_.end())
        return read(base);
    }
    return reader.sound() ? Outcome() : reader.problems().front();
  }

  const std::string& known_;
  std::vector<fs::path> begun_;
  std::vector<LocatedJson> all_;
  std::vector<std::string> folders_;
};

}  // namespace

Result<Lexicon> load_lexicon(const std::string& folder, const Signature& facts, const std::string& known) {
  Documents documents(known);
  if (auto problem = documents.read(folder)) return *std::move(problem);
  LexiconReader reader(documents.all(), facts);
  auto lexicon = reader.read();
  if (auto problems = reader.problems(); !problems.empty()) return problems.front();
  lexicon.folders = documents.folders();
  return lexicon;
}

std::vector<Error> check_lexicon(const std::string& folder, const Signature& facts, const std::string& known) {
  Documents documents(known);
  if (auto problem = documents.read(folder)) return {*std::move(problem)};
  LexiconReader reader(documents.all(), facts);
  const auto lexicon = reader.read();
  if (auto problems = reader.problems(); !problems.empty()) return problems;
  DocumentReader of_examples;
  read_examples(documents.all(), lexicon, of_examples);
  return of_examples.problems();
}

Result<std::vector<LexiconExample>> load_examples(const Lexicon& lexicon) {
  std::vector<LocatedJson> all;
  for (const auto& folder : lexicon.folders) {
    auto documents = documents_in(folder);
    if (!documents) return documents.error();
    std::move(documents->begin(), documents->end(), std::back_inserter(all));
  }
  DocumentReader reader;
  auto examples = read_examples(all, lexicon, reader);
  if (!reader.sound()) return reader.problems().front();
  return examples;
}

}  // namespace continua
