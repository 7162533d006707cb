#include "continua/language/vocabulary.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "continua/core/located_json.h"
#include "continua/core/words.h"
#include "continua/language/misspelling.h"
#include "continua/language/reduction.h"

namespace continua {
namespace {

// A word that resembles another has at most one mistake in so many letters: "nife" and "knife", not "snack" and
// "black". Short words resemble each other by chance.
constexpr std::size_t letters_in_one_mistake = 3, fewest_letters = 4;

// A word that names nothing in the scene is known again in fewer letters if two of them are exchanged ("teh"), but
// needs more of them if one is missing or too many ("behnd"): "pace" is no "place".
constexpr std::size_t fewest_letters_exchanged = 3, fewest_letters_otherwise = 6;

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
  note_said_of_scene(world);
}

// The words for the values that objects have, with their synonyms and plurals.
void Vocabulary::note_said_of_scene(const WorldSnapshot& world) {
  const auto note = [&](const WordAttribute& attribute, const std::string& value) {
    const auto word = spoken(value);
    if (word.empty() || word.find(' ') != std::string::npos) return;
    for (const auto& made : attribute.words) said_of_scene_.insert(made.plural ? plural(word) : word);
  };
  for (const auto& attribute : lexicon_->attributes)
    for (const auto& object : world.objects) {
      const auto value = object.attributes.find(attribute.name);
      if (value == object.attributes.end()) continue;
      note(attribute, value->second);
      for (const auto& group : attribute.values)
        if (std::find(group.begin(), group.end(), value->second) != group.end())
          for (const auto& synonym : group) note(attribute, synonym);
    }
}

// The human was asked before a word gets another meaning.
void Vocabulary::lose_senses(const std::string& word) {
  scene_words_.insert_or_assign(word, SceneWord{{}, true});
  add_parts(word);
}

void Vocabulary::learn(const std::string& word, const std::string& name, const Type& type) {
  names_.insert_or_assign(name, type);
  const auto constant = Term::constant(name, type);
  lose_senses(word);
  for (const auto& form : forms_of(word))
    for (const auto& made : lexicon_->learned)
      if (made.type == type) add_word(form, {made.category, applied(made.term, constant), made.cost});
  for (auto& sense : as_name(word, true).senses) add_word(word, std::move(sense));
}

// The verb in the form that was taught, and in those with other endings: capping, cap, capped. Other words keep their
// own meaning.
std::set<std::string> Vocabulary::forms_of(const std::string& verb) const {
  std::set<std::string> forms = {verb};
  const auto add_others = [&](const std::string& form) {
    for (const auto& [ending, other] : lexicon_->forms)
      for (const auto& [from, to] : {std::pair(ending, other), std::pair(other, ending)})
        if (form.size() > from.size() && form.ends_with(from))
          if (auto made = form.substr(0, form.size() - from.size()) + to; entries(made).empty())
            forms.insert(std::move(made));
  };
  add_others(verb);
  for (const auto& form : std::set(forms)) add_others(form);
  return forms;
}

void Vocabulary::learn_noun(const std::string& name, const Term& condition) {
  // "plate" may be taught for a thing that is none: the constant must not be that of the lexicon.
  auto constant_name = name;
  while (!names_.emplace(constant_name, condition.type()).second) constant_name += "_taught";
  definitions_.emplace(constant_name, condition);
  const auto constant = Term::constant(constant_name, condition.type());
  lose_senses(name);
  // "Frogs" are several, each a frog; "James" may be one all the same.
  const auto one = singular(name);
  add_noun(name, false, constant, one ? 0.2 : 0);
  if (one) add_noun(name, true, constant, 0);
  if (one && entries(*one).empty()) add_noun(*one, false, constant, 0);
  if (const auto many = plural(name); !one && entries(many).empty()) add_noun(many, true, constant, 0);
  for (auto& sense : as_name(name, true).senses) add_word(name, std::move(sense));
}

void Vocabulary::add_noun(const std::string& word, bool plural, const Term& constant, double cost) {
  for (const auto& made : lexicon_->nouns)
    if (made.type == constant.type() && made.plural == plural)
      add_word(word, {made.category, applied(made.term, constant), made.cost + cost});
}

bool Vocabulary::means(std::string_view word) const { return !senses(entries(word)).empty(); }

WordEntry Vocabulary::as_name(const std::string& words, bool known) const {
  WordEntry entry;
  for (const auto& made : known ? lexicon_->taken : lexicon_->unknown)
    entry.senses.push_back({made.category, applied(made.term, Term::text(words)), made.cost});
  return entry;
}

WordEntry Vocabulary::as_number(const std::string& word) const {
  WordEntry entry;
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return entry;
  for (const auto& made : lexicon_->numbers)
    entry.senses.push_back({made.category, applied(made.term, Term::number(value)), made.cost});
  return entry;
}

std::optional<Vocabulary::Resemblance> Vocabulary::resembling(const std::string& word) const {
  const auto thing = resembling_thing(word);
  if (thing && thing->sure) return thing;
  const auto other = resembling_word(word);
  return other ? other : thing;
}

std::optional<Vocabulary::Resemblance> Vocabulary::resembling_thing(const std::string& word) const {
  std::optional<Resemblance> nearest;
  std::size_t best = word.size();
  for (const auto& each : said_of_scene_) {
    const auto distance = edit_distance(word, each);
    const auto letters = std::max(word.size(), each.size());
    if (distance > best || letters < fewest_letters || letters_in_one_mistake * distance > letters) continue;
    nearest = distance < best ? std::optional(Resemblance{each, is_of_the_fingers(slip(word, each))}) : std::nullopt;
    best = distance;
  }
  return nearest;
}

std::optional<Vocabulary::Resemblance> Vocabulary::resembling_word(const std::string& word) const {
  std::optional<Resemblance> only;
  bool several = false;
  const auto compare = [&](const std::string& each) {
    const auto found = slip(word, each);
    const auto fewest = found == Slip::exchanged ? fewest_letters_exchanged : fewest_letters_otherwise;
    if (!is_of_the_fingers(found) || each.size() < fewest) return;
    several = several || only;
    only = Resemblance{each, true};
  };
  for (const auto& [part, number] : lexicon_->words.parts()) compare(part);
  for (const auto& part : parts_) compare(part);
  return several ? std::nullopt : only;
}

std::vector<const WordEntry*> Vocabulary::Walk::step(std::string_view word) {
  is_known_ = is_known_ && known_.step(word);
  if (++count_ > vocabulary_.most_scene_words_) return is_known_ ? known_.entries() : std::vector<const WordEntry*>();
  if (!text_.empty()) text_ += ' ';
  text_ += word;
  const auto& of_scene = vocabulary_.scene_words_;
  const auto found = of_scene.find(text_);
  const bool alone = found != of_scene.end() && found->second.alone;
  auto entries = is_known_ && !alone ? known_.entries() : std::vector<const WordEntry*>();
  if (found != of_scene.end()) entries.push_back(&found->second.entry);
  return entries;
}

std::vector<const WordEntry*> Vocabulary::entries(std::string_view words) const {
  Walk walk(*this);
  std::vector<const WordEntry*> found;
  for (const auto word : parts_of_entry(words)) found = walk.step(word);
  return found;
}

std::vector<const WordSense*> Vocabulary::senses(const std::vector<const WordEntry*>& entries) {
  std::vector<const WordSense*> all;
  for (const auto* entry : entries)
    for (const auto& sense : entry->senses) all.push_back(&sense);
  return all;
}

std::set<std::string> Vocabulary::words() const {
  auto all = lexicon_->words.texts();
  for (const auto& [words, entry] : scene_words_) all.insert(words);
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
  const auto [found, is_new] = scene_words_.try_emplace(word);
  if (is_new) add_parts(word);
  found->second.entry.senses.push_back(std::move(sense));
}

void Vocabulary::add_parts(std::string_view words) {
  const auto parts = parts_of_entry(words);
  for (const auto part : parts)
    if (!lexicon_->words.parts().contains(part)) parts_.emplace(part);
  most_scene_words_ = std::max(most_scene_words_, parts.size());
}

std::optional<std::string> Vocabulary::singular(const std::string& word) const {
  for (const auto& [singular, ending] : lexicon_->plurals) {
    if (word.size() <= ending.size() || !word.ends_with(ending)) continue;
    auto one = word.substr(0, word.size() - ending.size()) + singular;
    if (plural(one) == word) return one;
  }
  return std::nullopt;
}

std::string Vocabulary::plural(const std::string& word) const {
  for (const auto& [singular, ending] : lexicon_->plurals)
    if (word.ends_with(singular)) return word.substr(0, word.size() - singular.size()) + ending;
  return word;
}

}  // namespace continua
