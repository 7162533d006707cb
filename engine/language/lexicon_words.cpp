// Words, templates of words, and rules that change categories.
#include <fmt/format.h>

#include "language/lexicon_reader.h"
#include "language/words.h"

namespace continua {

std::optional<Category> LexiconReader::read_category(const Item& item) {
  if (!item.json) return std::nullopt;
  const auto text = text_of(item, "a category");
  if (!item.json->is_string()) return std::nullopt;
  auto category = Category::parse(text, lexicon_.atoms);
  if (category) return *category;
  problem_in_text(item, category.error());
  return std::nullopt;
}

std::optional<Term> LexiconReader::read_term(const Item& item, const Category& category,
                                             const std::optional<Type>& argument) {
  const auto expected = [&](std::size_t choice) {
    const auto type = type_of(category, lexicon_.atoms, choice);
    return argument ? Type::function(*argument, type) : type;
  };
  // Of the types that the category may have, the one that the term has; where it has none, the first is what is told.
  if (item.json && item.json->is_string()) {
    const auto& types = lexicon_.atoms.find(target(category).name().text())->second.types;
    for (std::size_t choice = 1; choice < types.size(); ++choice)
      if (!parse_term(item.json->get<std::string>(), lexicon_.names, expected(0)) &&
          parse_term(item.json->get<std::string>(), lexicon_.names, expected(choice)))
        return read_term(item, expected(choice));
  }
  return read_term(item, expected(0));
}

WordEntry& LexiconReader::entry(const Item& at, const std::string& word) {
  const auto parts = words_of(word);
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : " ") + part.text;
  if (text.empty() || text != word)
    problem_at_key(
        at, fmt::format("found {}, expected words in lower case with single spaces between them", in_quotes(word)));
  return lexicon_.words[word];
}

void LexiconReader::read_words() {
  each_section("words", [&](const Item& section) {
    each_member(section, "words", [&](const std::string& key, const Item& senses) {
      std::vector<WordSense> read;
      each_element(senses, "the senses of a word", [&](const Item& sense) {
        if (!expect_array(sense, "a category, a term and perhaps a cost")) return;
        if (sense.json->size() < 2 || sense.json->size() > 3)
          return problem(sense, fmt::format("found {} elements, expected a category, a term and perhaps a cost",
                                            sense.json->size()));
        const auto category = read_category(element(sense, 0));
        if (!category) return;
        if (const auto term = read_term(element(sense, 1), *category, std::nullopt))
          read.push_back({*category, *term, read_cost(element(sense, 2))});
      });
      for (const auto& word : alternatives(key)) {
        auto& all = entry(senses, word).senses;
        all.insert(all.end(), read.begin(), read.end());
      }
    });
  });
  each_section("skip", [&](const Item& section) {
    each_member(section, "words that may be left out", [&](const std::string& key, const Item& cost) {
      for (const auto& word : alternatives(key)) entry(cost, word).skip = read_cost(cost);
    });
  });
}

void LexiconReader::read_attributes() {
  each_section("attributes", [&](const Item& section) {
    each_member(section, "attributes", [&](const std::string& name, const Item& item) { read_attribute(name, item); });
  });
}

void LexiconReader::read_attribute(const std::string& name, const Item& item) {
  static const auto condition = Type::function(Type::entity(), Type::truth());
  if (!expect_object(item, "an attribute", {"meaning", "words", "values", "about"})) return;
  WordAttribute attribute;
  attribute.name = name;
  const auto meaning = read_term(required(item, "meaning", "what it is to have one of several values"),
                                 Type::function(Type::list(Type::text_type()), condition));
  if (meaning) attribute.meaning = *meaning;
  each_element(required(item, "words", "the words that its values make"), "templates of words", [&](const Item& each) {
    if (!expect_object(each, "a template of words", {"category", "term", "cost", "plural", "about"})) return;
    const auto category = read_category(required(each, "category", "the category of the word"));
    if (!category) return;
    const auto term =
        read_term(required(each, "term", "its meaning, given the value's condition"), *category, condition);
    if (!term) return;
    attribute.words.push_back(
        {*category, *term, read_cost(member(each, "cost")), truth_of(member(each, "plural"), false)});
  });
  each_element(member(item, "values"), "values", [&](const Item& value) {
    std::vector<std::string> group;
    for (const auto& text : alternatives(text_of(value, "a value and its synonyms, with | between them")))
      if (!words_of(text).empty()) group.push_back(text);
    if (group.empty()) return problem(value, "there is no word in this value");
    attribute.values.push_back(std::move(group));
  });
  lexicon_.attributes.push_back(std::move(attribute));
}

void LexiconReader::read_names_given(const std::string& section, std::vector<NameTemplate>& templates) {
  each_section(section, [&](const Item& items) {
    each_element(items, "templates of names", [&](const Item& each) {
      if (!expect_object(each, "a template of names", {"type", "category", "term", "cost", "about"})) return;
      const auto type = read_type(required(each, "type", "the type of what is named"));
      const auto category = read_category(required(each, "category", "the category of the word"));
      if (!category) return;
      const auto term = read_term(required(each, "term", "its meaning, given what is named"), *category, type);
      if (term) templates.push_back({type, *category, *term, read_cost(member(each, "cost"))});
    });
  });
}

void LexiconReader::read_plurals() {
  each_section("plural", [&](const Item& section) {
    each_member(section, "endings of singular and plural", [&](const std::string& singular, const Item& plural) {
      lexicon_.plurals.emplace_back(singular, text_of(plural, "the ending of the plural"));
    });
  });
}

void LexiconReader::read_rules() {
  each_section("unary", [&](const Item& section) {
    each_element(section, "rules that change a category", [&](const Item& item) {
      if (!expect_object(item, "a rule", {"name", "from", "to", "term", "cost", "about"})) return;
      const auto name = text_of(required(item, "name", "the rule's name"), "the rule's name");
      const auto from = read_category(required(item, "from", "the category that changes"));
      const auto to = read_category(required(item, "to", "what it becomes"));
      if (!from || !to) return;
      const auto term = read_term(required(item, "term", "what it means"), *to, type_of(*from, lexicon_.atoms));
      if (term) lexicon_.rules.push_back({name, *from, *to, *term, read_cost(member(item, "cost"))});
    });
  });
}

}  // namespace continua
