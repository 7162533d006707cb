// Categories, names and operators: what the words of a lexicon are made of.
#include <fmt/format.h>

#include "language/lexicon_reader.h"
#include "language/reduction.h"
#include "term/evaluate.h"

namespace continua {

Type LexiconReader::read_type(const Item& item) {
  if (!item.json || !item.json->is_string()) return text_of(item, "a type"), Type::term();
  auto type = Type::parse(item.json->get<std::string>());
  if (type) return *type;
  problem_in_text(item, type.error());
  return Type::term();
}

void LexiconReader::declare(const Item& at, const std::string& name, const Type& type) {
  const bool is_word = name == "null" || name == "true" || name == "false";
  if (name.empty())
    problem_at_key(at, "found '', expected a name");
  else if (is_word || !lexicon_.names.emplace(name, type).second)
    problem_at_key(at, fmt::format("the name '{}' is taken by {}; expected another", name,
                                   is_word || term_signature().contains(name) ? "the term language"
                                   : facts_.contains(name)                    ? "a fact of the world"
                                                                              : "an earlier declaration"));
}

void LexiconReader::read_atoms() {
  each_section("categories", [&](const Item& section) {
    each_member(section, "categories", [&](const std::string& name, const Item& item) {
      if (!expect_object(item, "a category", {"type", "also", "move", "open", "phrase", "features", "about"})) return;
      Atom atom;
      atom.types.push_back(read_type(required(item, "type", "the type of its terms")));
      each_element(member(item, "also"), "further types",
                   [&](const Item& each) { atom.types.push_back(read_type(each)); });
      atom.move = text_of(member(item, "move"), "a move");
      atom.open = truth_of(member(item, "open"), false);
      atom.phrase = truth_of(member(item, "phrase"), false);
      atom.features = texts_of(member(item, "features"), "its features");
      if (name.empty() || name.find_first_of("/\\()[]* ") != std::string::npos)
        problem_at_key(item,
                       fmt::format("found {}, expected a name without any of /\\()[]* and spaces", in_quotes(name)));
      else if (!lexicon_.atoms.emplace(name, std::move(atom)).second)
        problem_at_key(item, fmt::format("the category '{}' is declared in an earlier file", name));
    });
  });
}

void LexiconReader::read_names() {
  each_section("names", [&](const Item& section) {
    each_member(section, "names with their types", [&](const std::string& names, const Item& item) {
      const auto type = read_type(item);
      for (const auto& name : alternatives(names)) declare(item, name, type);
    });
  });
  each_section("define", [&](const Item& section) {
    each_member(section, "definitions", [&](const std::string& name, const Item& item) {
      if (expect_object(item, "a definition", {"type", "term", "compared", "about"}))
        declare(item, name, read_type(required(item, "type", "the type of the name")));
    });
  });
}

void LexiconReader::read_operators() {
  const auto condition = Type::function(Type::entity(), Type::truth());
  each_section("determiners", [&](const Item& section) {
    each_member(section, "determiners", [&](const std::string& name, const Item& item) {
      if (!expect_object(item, "a determiner", {"definite", "many", "deictic", "other", "count", "about"})) return;
      Determiner determiner;
      determiner.definite = truth_of(member(item, "definite"), false);
      determiner.many = truth_of(member(item, "many"), false);
      determiner.deictic = truth_of(member(item, "deictic"), false);
      determiner.other = truth_of(member(item, "other"), false);
      if (const auto count = member(item, "count"); count.json) {
        if (count.json->is_number_unsigned() && count.json->get<std::size_t>() <= 1000)
          determiner.count = count.json->get<int>();
        else
          mismatch(count, "how many are meant, a whole number from 0 to 1000");
      }
      const bool several = determiner.many || determiner.count > 1;
      declare(item, name, Type::function(condition, several ? Type::list(Type::entity()) : Type::entity()));
      lexicon_.operators.determiners.emplace(name, determiner);
    });
  });
  static const std::map<std::string, Proform::Source, std::less<>> sources = {
      {"focus", Proform::Source::focus}, {"pointed", Proform::Source::pointed}, {"topic", Proform::Source::topic},
      {"other", Proform::Source::other}, {"avatar", Proform::Source::avatar},   {"human", Proform::Source::human}};
  std::vector<std::string> known;
  for (const auto& [name, source] : sources) known.push_back(name);
  each_section("proforms", [&](const Item& section) {
    each_member(section, "pro-forms", [&](const std::string& name, const Item& item) {
      if (!expect_object(item, "a pro-form", {"type", "source", "about"})) return;
      declare(item, name, read_type(required(item, "type", "the type of what it stands for")));
      const auto source = required(item, "source", "where it gets its meaning from");
      const auto text = text_of(source, "a source");
      if (const auto found = sources.find(text); found != sources.end())
        lexicon_.operators.proforms.emplace(name, Proform{found->second});
      else if (source.json && source.json->is_string())
        mismatch(source, "focus, pointed, topic, other, avatar or human" + did_you_mean(text, known));
    });
  });
}

void LexiconReader::read_definitions() {
  each_section("define", [&](const Item& section) {
    if (!section.json->is_object()) return;
    for (const auto& [name, value] : section.json->items()) {
      const auto item = member(section, name);
      const auto declared = lexicon_.names.find(name);
      if (!value.is_object() || declared == lexicon_.names.end()) continue;
      if (const auto term = read_term(required(item, "term", "what it means"), declared->second))
        lexicon_.definitions.emplace(name, *term);
      const auto compared = member(item, "compared");
      if (!truth_of(compared, false)) continue;
      if (declared->second != Type::list(Type::entity()))
        problem(compared,
                fmt::format("'{}' is of type {}; expected e*, objects to compare", name, declared->second.text()));
      else if (!lexicon_.operators.compared.empty())
        problem(compared, fmt::format("what is compared is '{}' already", lexicon_.operators.compared));
      else
        lexicon_.operators.compared = name;
    }
  });
}

std::optional<Term> LexiconReader::read_term(const Item& item, const Type& expected) {
  if (!item.json) return std::nullopt;
  const auto text = text_of(item, "a term");
  if (!item.json->is_string()) return std::nullopt;
  const auto term = parse_term(text, lexicon_.names, expected);
  if (!term) return problem_in_text(item, term.error()), std::nullopt;
  const auto reduced = normal(*term);
  if (reduced.is_null() && !term->is_null()) return problem(item, "this term has no normal form"), std::nullopt;
  return reduced;
}

}  // namespace continua
