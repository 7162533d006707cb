#include "continua/language/vocabulary.h"

#include <algorithm>

#include "continua/core/words.h"
#include "continua/language/reduction.h"

namespace continua {
namespace {

// The words for a value: "light_blue" is said "light blue".
std::string spoken(const std::string& value) {
  std::string words;
  auto text = value;
  std::replace(text.begin(), text.end(), '_', ' ');
  for (const auto& word : words_of(text))
    if (!word.comma) words += (words.empty() ? "" : " ") + word.text;
  return words;
}

}  // namespace

Vocabulary::Vocabulary(std::shared_ptr<const Lexicon> lexicon, const WorldSnapshot& world)
    : lexicon_(std::move(lexicon)), names_(lexicon_->names) {
  for (const auto& [words, entry] : lexicon_->words) add_parts(words);
  for (const auto& attribute : lexicon_->attributes) {
    std::set<std::string, std::less<>> grouped;
    for (const auto& group : attribute.values) {
      add_value(attribute, group);
      grouped.insert(group.begin(), group.end());
    }
    for (const auto& object : world.objects) {
      const auto value = object.attributes.find(attribute.name);
      if (value != object.attributes.end() && grouped.insert(value->second).second)
        add_value(attribute, {value->second});
    }
  }
}

void Vocabulary::learn(const std::string& name, const Type& type) {
  names_.insert_or_assign(name, type);
  const auto constant = Term::constant(name, type);
  for (const auto& made : lexicon_->learned)
    if (made.type == type) add_word(name, {made.category, applied(made.term, constant), made.cost});
  for (auto& sense : as_name(name).senses) add_word(name, std::move(sense));
}

WordEntry Vocabulary::as_name(const std::string& words) const {
  WordEntry entry;
  for (const auto& made : lexicon_->unknown)
    entry.senses.push_back({made.category, applied(made.term, Term::text(words)), made.cost});
  return entry;
}

const WordEntry* Vocabulary::find(std::string_view words) const {
  if (const auto found = scene_words_.find(words); found != scene_words_.end()) return &found->second;
  const auto found = lexicon_->words.find(words);
  return found == lexicon_->words.end() ? nullptr : &found->second;
}

std::set<std::string> Vocabulary::words() const {
  std::set<std::string> all;
  for (const auto* table : {&scene_words_, &lexicon_->words})
    for (const auto& [words, entry] : *table) all.insert(words);
  return all;
}

const Term* Vocabulary::definition(std::string_view name) const {
  if (const auto found = definitions_.find(name); found != definitions_.end()) return &found->second;
  const auto found = lexicon_->definitions.find(name);
  return found == lexicon_->definitions.end() ? nullptr : &found->second;
}

void Vocabulary::add_value(const WordAttribute& attribute, const std::vector<std::string>& group) {
  static const auto condition = Type::function(Type::entity(), Type::truth());
  if (spoken(group.front()).empty()) return;
  // "orange" may be a type and a color: the second constant gets the attribute's name as a suffix.
  auto name = group.front();
  while (!names_.emplace(name, condition).second) name += "_" + attribute.name;
  std::vector<Term> values;
  for (const auto& value : group) values.push_back(Term::text(value));
  definitions_.emplace(name, applied(attribute.meaning, Term::list(std::move(values), Type::text_type())));
  const auto constant = Term::constant(name, condition);
  for (const auto& made : attribute.words)
    for (const auto& value : group) {
      const auto word = spoken(value);
      if (!word.empty())
        add_word(made.plural ? plural(word) : word, {made.category, applied(made.term, constant), made.cost});
    }
}

void Vocabulary::add_word(const std::string& word, WordSense sense) {
  auto found = scene_words_.find(word);
  if (found == scene_words_.end()) {
    const auto known = lexicon_->words.find(word);
    found = scene_words_.emplace(word, known == lexicon_->words.end() ? WordEntry() : known->second).first;
    add_parts(word);
  }
  found->second.senses.push_back(std::move(sense));
}

void Vocabulary::add_parts(std::string_view words) {
  std::size_t count = 0;
  for (std::size_t at = 0; at <= words.size(); ++count) {
    const auto end = std::min(words.find(' ', at), words.size());
    parts_.emplace(words.substr(at, end - at));
    at = end + 1;
  }
  most_words_ = std::max(most_words_, count);
}

std::string Vocabulary::plural(const std::string& word) const {
  for (const auto& [singular, ending] : lexicon_->plurals)
    if (word.ends_with(singular)) return word.substr(0, word.size() - singular.size()) + ending;
  return word;
}

}  // namespace continua
