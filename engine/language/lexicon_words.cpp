// Words, templates of words, and rules that change categories.
#include <algorithm>

#include <fmt/format.h>

#include "continua/core/words.h"
#include "continua/language/lexicon_reader.h"
#include "continua/language/spellings.h"
#include "continua/term/read_type.h"

namespace continua {
namespace {

double read_cost(const Item& item) { return item.number("a cost", 0, 0, 100); }

// Whether words_of() would give it as it is written.
bool is_as_heard(std::string_view word) {
  // Most are of small Latin letters.
  if (std::all_of(word.begin(), word.end(), [](char c) { return 'a' <= c && c <= 'z'; })) return true;
  const auto heard = words_of(word);
  return heard.size() == 1 && heard.front().text == word;
}

}  // namespace

std::optional<Category> LexiconReader::read_category(const Item& item) {
  const auto text = item.text("a category");
  if (!item.is_text()) return std::nullopt;
  auto category = Category::parse(text, lexicon_.atoms);
  if (category) return *category;
  problem_with_quote(item, category.error());
  return std::nullopt;
}

std::optional<Term> LexiconReader::read_term(const Item& item, const Category& category,
                                             const std::optional<Type>& argument) {
  const auto expected = [&](std::size_t choice) {
    const auto type = type_of(category, lexicon_.atoms, choice);
    return argument ? Type::function(*argument, type) : type;
  };
  // A category may have several types; the term decides which. A term that has none of them is reported against the
  // first.
  if (item.is_text()) {
    const auto text = item.text("a term");
    const auto& types = lexicon_.atoms.find(category.target().text())->second.types;
    for (std::size_t choice = 1; choice < types.size(); ++choice)
      if (!parse_term(text, lexicon_.names, expected(0)) && parse_term(text, lexicon_.names, expected(choice)))
        return read_term(item, expected(choice));
  }
  return read_term(item, expected(0));
}

void LexiconReader::add_entry(const Item& at, const std::string& key, WordEntry entry) {
  for (const auto part : parts_of_spellings(key))
    if (!is_as_heard(part))
      return at.problem_at_key(fmt::format("found {}, expected words in lower case", in_quotes(part)));
  if (!lexicon_.words.add(key, std::move(entry)))
    at.problem_at_key(
        fmt::format("found {}, expected at least one word in each of at most {} ways, and brackets in pairs",
                    in_quotes(key), most_spellings));
}

void LexiconReader::read_words() {
  for (const auto& [key, senses] : members_of("words", "words")) {
    std::vector<WordSense> read;
    for (const auto& sense : senses.elements("the senses of a word")) {
      const auto parts = sense.elements("a category, a term and perhaps a cost");
      if (!sense.is_list()) continue;
      if (parts.size() < 2 || parts.size() > 3) {
        sense.problem(fmt::format("found {} elements, expected a category, a term and perhaps a cost", parts.size()));
        continue;
      }
      const auto category = read_category(parts[0]);
      if (!category) continue;
      if (const auto term = read_term(parts[1], *category, std::nullopt))
        read.push_back({*category, *term, read_cost(sense.element(2))});
    }
    add_entry(senses, key, {std::move(read), {}, {}});
  }
  for (const auto& [key, cost] : members_of("skip", "words that may be left out"))
    add_entry(cost, key, {{}, read_cost(cost), {}});
  for (const auto& [key, cost] : members_of("asides", "words that begin an aside"))
    add_entry(cost, key, {{}, {}, read_cost(cost)});
}

void LexiconReader::read_attributes() {
  static const auto condition = Type::function(Type::entity(), Type::truth());
  for (const auto& [name, item] : members_of("attributes", "attributes")) {
    if (!item.expect_object("an attribute", {"meaning", "words", "values", "about"})) continue;
    WordAttribute attribute;
    attribute.name = name;
    const auto meaning = read_term(item.required("meaning", "what it is to have one of several values"),
                                   Type::function(Type::list(Type::text_type()), condition));
    if (meaning) attribute.meaning = *meaning;
    for (const auto& each : item.required("words", "the words that its values make").elements("templates of words")) {
      if (!each.expect_object("a template of words", {"category", "term", "cost", "plural", "about"})) continue;
      const auto category = read_category(each.required("category", "the category of the word"));
      if (!category) continue;
      const auto term =
          read_term(each.required("term", "its meaning, given the value's condition"), *category, condition);
      if (term)
        attribute.words.push_back(
            {*category, *term, read_cost(each.member("cost")), each.member("plural").truth(false)});
    }
    for (const auto& value : item.member("values").elements("values")) {
      std::vector<std::string> group;
      for (const auto& text : spellings(value.text("a value and its synonyms, with | between them")))
        if (!words_of(text).empty()) group.push_back(text);
      if (group.empty())
        value.problem("there is no word in this value");
      else
        attribute.values.push_back(std::move(group));
    }
    lexicon_.attributes.push_back(std::move(attribute));
  }
}

std::vector<NameTemplate> LexiconReader::read_name_templates(const std::string& section) {
  std::vector<NameTemplate> templates;
  for (const auto& item : elements_of(section, "templates of names")) {
    if (!item.expect_object("a template of names", {"type", "category", "term", "cost", "plural", "about"})) continue;
    const auto type = read_type(item.required("type", "the type of what is named"));
    const auto category = read_category(item.required("category", "the category of the word"));
    if (!category) continue;
    const auto term = read_term(item.required("term", "its meaning, given what is named"), *category, type);
    if (term)
      templates.push_back({type, *category, *term, read_cost(item.member("cost")), item.member("plural").truth(false)});
  }
  return templates;
}

void LexiconReader::read_plurals() {
  for (const auto& [singular, plural] : members_of("plural", "endings of singular and plural"))
    lexicon_.plurals.emplace_back(singular, plural.text("the ending of the plural"));
}

void LexiconReader::read_forms() {
  for (const auto& [ending, others] : members_of("forms", "endings of forms of a verb"))
    for (const auto& other : spellings(others.text("the endings of its other forms")))
      lexicon_.forms.emplace_back(ending, other);
}

void LexiconReader::read_contracted() {
  for (const auto& [ending, word] : members_of("contracted", "endings that stand for a word"))
    lexicon_.contracted.emplace_back(ending, word.text("the word that the ending stands for"));
}

void LexiconReader::read_apostrophes() {
  for (const auto& [ending, written] : members_of("apostrophes", "endings that lack their apostrophe"))
    lexicon_.apostrophes.emplace_back(ending, written.text("the same ending with its apostrophe"));
}

void LexiconReader::read_rules() {
  for (const auto& item : elements_of("unary", "rules that change a category")) {
    if (!item.expect_object("a rule", {"name", "from", "to", "term", "cost", "about"})) continue;
    const auto name = item.required("name", "the rule's name").text("the rule's name");
    const auto from = read_category(item.required("from", "the category that changes"));
    const auto to = read_category(item.required("to", "what it becomes"));
    if (!from || !to) continue;
    const auto term = read_term(item.required("term", "what it means"), *to, type_of(*from, lexicon_.atoms));
    if (term) lexicon_.rules.push_back({name, *from, *to, *term, read_cost(item.member("cost"))});
  }
}

}  // namespace continua
