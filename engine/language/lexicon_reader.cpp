// The shapes of JSON in a lexicon, and the problems found on the way.
#include "language/lexicon_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/digest.h"
#include "term/evaluate.h"

namespace continua {
namespace {

constexpr std::size_t most_problems = 1000;

const std::vector<std::string> sections = {"about",    "categories", "names",  "define",     "determiners",
                                           "proforms", "words",      "skip",   "attributes", "plural",
                                           "unary",    "examples",   "sample", "learned",    "unknown"};

std::string found(const Json& json) {
  if (json.is_string()) return in_quotes(json.get<std::string>());
  return json.is_array() ? "a list" : json.is_object() ? "an object" : compact(json);
}

}  // namespace

LexiconReader::LexiconReader(const std::vector<LocatedJson>& documents, const Signature& facts)
    : documents_(documents), facts_(facts) {
  lexicon_.names = term_signature();
  lexicon_.names.insert(facts.begin(), facts.end());
}

Lexicon LexiconReader::read() {
  RunningDigest digest;
  for (const auto& document : documents_) {
    for (const auto& [place, key] : document.duplicates())
      note(document, place, fmt::format("the key {} a second time in this object", in_quotes(key)));
    expect_object({&document, &document.root(), ""}, "a part of a lexicon", sections);
    digest.add(compact(document.root()));
    digest.add("\n");
  }
  lexicon_.digest = digest.text();
  read_atoms();
  read_names();
  read_operators();
  read_definitions();
  read_words();
  read_attributes();
  read_plurals();
  read_rules();
  read_names_given("learned", lexicon_.learned);
  read_names_given("unknown", lexicon_.unknown);
  read_sample();
  if (problems_.empty()) read_examples();
  return std::move(lexicon_);
}

void LexiconReader::each_section(const std::string& key, const std::function<void(const Item&)>& visit) {
  for (const auto& document : documents_)
    if (const auto section = member({&document, &document.root(), ""}, key); section.json) visit(section);
}

void LexiconReader::each_member(const Item& object, const char* what, const Visit& visit) {
  if (!object.json || !expect_object(object, what, {})) return;
  for (const auto& [key, value] : object.json->items()) visit(key, member(object, key));
}

void LexiconReader::each_element(const Item& array, const char* what, const std::function<void(const Item&)>& visit) {
  if (!array.json || !expect_array(array, what)) return;
  for (std::size_t i = 0; i < array.json->size(); ++i) visit(element(array, i));
}

LexiconReader::Item LexiconReader::member(const Item& object, const std::string& key) const {
  if (!object.json || !object.json->is_object()) return {object.document, nullptr, object.pointer};
  const auto known = object.json->find(key);
  if (known == object.json->end()) return {object.document, nullptr, object.pointer};
  std::string escaped;
  for (const char c : key) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return {object.document, &*known, object.pointer + "/" + escaped};
}

LexiconReader::Item LexiconReader::required(const Item& object, const std::string& key, const char* what) {
  auto item = member(object, key);
  if (!item.json) problem(object, fmt::format("there is no \"{}\"; expected {}", key, what));
  return item;
}

LexiconReader::Item LexiconReader::element(const Item& array, std::size_t index) const {
  if (index >= array.json->size()) return {array.document, nullptr, array.pointer};
  return {array.document, &(*array.json)[index], array.pointer + "/" + std::to_string(index)};
}

bool LexiconReader::expect_object(const Item& item, const char* what, const std::vector<std::string>& keys) {
  if (!item.json->is_object()) return mismatch(item, fmt::format("{}, an object", what));
  if (keys.empty()) return true;
  for (const auto& [key, value] : item.json->items())
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      problem_at_key(member(item, key),
                     fmt::format("unknown key {} of {}{}", in_quotes(key), what, did_you_mean(key, keys)));
  return true;
}

bool LexiconReader::expect_array(const Item& item, const char* what) {
  return item.json->is_array() || mismatch(item, fmt::format("{}, a list", what));
}

std::string LexiconReader::text_of(const Item& item, const char* what) {
  if (!item.json) return {};
  if (item.json->is_string()) return item.json->get<std::string>();
  mismatch(item, fmt::format("{}, a string", what));
  return {};
}

std::vector<std::string> LexiconReader::texts_of(const Item& item, const char* what) {
  std::vector<std::string> texts;
  each_element(item, what, [&](const Item& each) { texts.push_back(text_of(each, "a string")); });
  return texts;
}

bool LexiconReader::truth_of(const Item& item, bool otherwise) {
  if (!item.json) return otherwise;
  if (!item.json->is_boolean()) return mismatch(item, "true or false"), otherwise;
  return item.json->get<bool>();
}

double LexiconReader::read_cost(const Item& item) {
  if (!item.json) return 0;
  const double cost = item.json->is_number() ? item.json->get<double>() : std::nan("");
  if (cost >= 0 && cost <= 100) return cost;
  mismatch(item, "a cost, a number from 0 to 100");
  return 0;
}

bool LexiconReader::mismatch(const Item& item, const std::string& expected) {
  problem(item, fmt::format("found {}, expected {}", found(*item.json), expected));
  return false;
}

void LexiconReader::problem(const Item& at, std::string sentence) {
  note(*at.document, at.document->place(at.pointer), std::move(sentence));
}

void LexiconReader::problem_at_key(const Item& at, std::string sentence) {
  note(*at.document, at.document->key_place(at.pointer), std::move(sentence));
}

void LexiconReader::problem_in_text(const Item& at, const Error& error) {
  constexpr std::string_view prefix = "column ";
  require(error.where.starts_with(prefix), "an error in a text names its column");
  const auto byte = std::stoul(error.where.substr(prefix.size())) - 1;
  note(*at.document, at.document->place_in_text(at.pointer, byte),
       fmt::format("{}, in {}", error.sentence, in_quotes(at.json->get<std::string>())));
}

void LexiconReader::note(const LocatedJson& document, TextPlace place, std::string sentence) {
  if (problems_.size() < most_problems) problems_.push_back({&document, place, std::move(sentence)});
}

std::vector<Error> LexiconReader::problems() {
  std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
    return a.document != b.document ? a.document < b.document : a.place < b.place;
  });
  std::vector<Error> errors;
  for (const auto& [document, place, sentence] : problems_) errors.push_back(document->error(place, sentence));
  return errors;
}

std::vector<std::string> alternatives(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const auto end = std::min(text.find('|', at), text.size());
    const auto part = text.substr(at, end - at);
    const auto from = part.find_first_not_of(' '), to = part.find_last_not_of(' ');
    parts.push_back(from == std::string::npos ? std::string() : part.substr(from, to + 1 - from));
    at = end + 1;
  }
  return parts;
}

namespace {

// The documents of the folder by name, or the first that cannot be read.
Result<std::vector<LocatedJson>> documents_of(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator each(folder, error), end; !error && each != end; each.increment(error))
    if (each->path().extension() == ".json") paths.push_back(each->path().string());
  if (error) return Error{folder, fmt::format("cannot be read: {}; expected a folder of JSON files", error.message())};
  if (paths.empty()) return Error{folder, "there is no *.json in this folder; expected the files of a lexicon"};
  std::sort(paths.begin(), paths.end());
  std::vector<LocatedJson> documents;
  for (const auto& path : paths) {
    auto document = LocatedJson::read(path);
    if (!document) return document.error();
    documents.push_back(*std::move(document));
  }
  return documents;
}

}  // namespace

Result<Lexicon> load_lexicon(const std::string& folder, const Signature& facts) {
  const auto documents = documents_of(folder);
  if (!documents) return documents.error();
  LexiconReader reader(*documents, facts);
  auto lexicon = reader.read();
  if (auto problems = reader.problems(); !problems.empty()) return problems.front();
  return lexicon;
}

std::vector<Error> check_lexicon(const std::string& folder, const Signature& facts) {
  const auto documents = documents_of(folder);
  if (!documents) return {documents.error()};
  LexiconReader reader(*documents, facts);
  reader.read();
  return reader.problems();
}

}  // namespace continua
