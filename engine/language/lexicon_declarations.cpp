// Categories, names and operators: the parts that the senses of words are built from.
#include <fmt/format.h>

#include "continua/language/lexicon_reader.h"
#include "continua/language/reduction.h"
#include "continua/language/scope.h"
#include "continua/language/spellings.h"
#include "continua/term/evaluate.h"
#include "continua/term/read_type.h"

namespace continua {
namespace {

constexpr NamedValue<Proform::Source> proform_sources[] = {
    {Proform::Source::focus, "focus"},     {Proform::Source::pointed, "pointed"}, {Proform::Source::topic, "topic"},
    {Proform::Source::other, "other"},     {Proform::Source::avatar, "avatar"},   {Proform::Source::human, "human"},
    {Proform::Source::handled, "handled"},
};

}  // namespace

void LexiconReader::declare(const Item& at, const std::string& name, const Type& type) {
  const bool is_word = name == "null" || name == "true" || name == "false";
  if (name.empty())
    at.problem_at_key("found '', expected a name");
  else if (is_word || !lexicon_.names.emplace(name, type).second)
    at.problem_at_key(fmt::format("the name '{}' is taken by {}; expected another", name,
                                  is_word || term_signature().contains(name) ? "the term language"
                                  : facts_.contains(name)                    ? "a fact of the world"
                                                                             : "an earlier declaration"));
}

void LexiconReader::read_atoms() {
  for (const auto& [name, item] : members_of("categories", "categories")) {
    if (!item.expect_object("a category", {"type", "also", "move", "open", "phrase", "features", "about"})) continue;
    Atom atom;
    atom.types.push_back(read_type(item.required("type", "the type of its terms")));
    for (const auto& type : item.member("also").elements("further types")) atom.types.push_back(read_type(type));
    atom.move = item.member("move").text("a move");
    atom.open = item.member("open").truth(false);
    atom.phrase = item.member("phrase").truth(false);
    atom.features = item.member("features").texts("its features");
    if (name.empty() || name.find_first_of("/\\()[]* ") != std::string::npos)
      item.problem_at_key(fmt::format("found {}, expected a name without any of /\\()[]* and spaces", in_quotes(name)));
    else if (!lexicon_.atoms.emplace(name, std::move(atom)).second)
      item.problem_at_key(fmt::format("the category '{}' is declared in an earlier file", name));
  }
}

void LexiconReader::read_names() {
  for (const auto& [names, item] : members_of("names", "names with their types")) {
    const auto type = read_type(item);
    for (const auto& name : spellings(names)) declare(item, name, type);
  }
  for (const auto& [name, item] : members_of("define", "definitions"))
    if (item.expect_object("a definition", {"type", "term", "compared", "about"}))
      declare(item, name, read_type(item.required("type", "the type of the name")));
}

void LexiconReader::read_determiners() {
  const auto condition = Type::function(Type::entity(), Type::truth());
  for (const auto& [name, item] : members_of("determiners", "determiners")) {
    if (!item.expect_object("a determiner", {"definite", "many", "deictic", "other", "count", "about"})) continue;
    Determiner determiner;
    determiner.definite = item.member("definite").truth(false);
    determiner.many = item.member("many").truth(false);
    determiner.deictic = item.member("deictic").truth(false);
    determiner.other = item.member("other").truth(false);
    if (const auto count = item.member("count"); count.exists())
      determiner.count = count.whole_number("how many are meant", 0, 0, 1000);
    const bool several = determiner.many || determiner.count > 1;
    declare(item, name, Type::function(condition, several ? Type::list(Type::entity()) : Type::entity()));
    lexicon_.operators.determiners.emplace(name, determiner);
  }
}

void LexiconReader::read_proforms() {
  for (const auto& [name, item] : members_of("proforms", "pro-forms")) {
    if (!item.expect_object("a pro-form", {"type", "source", "about"})) continue;
    declare(item, name, read_type(item.required("type", "the type of what it stands for")));
    const auto source = item.required("source", "where it gets its meaning from");
    if (const auto known = source.one_of(proform_sources, "a source"))
      lexicon_.operators.proforms.emplace(name, Proform{*known});
  }
}

void LexiconReader::read_definitions() {
  for (const auto& root : roots_) {
    const auto section = root.member("define");
    if (!section.is_object()) continue;  // read_names has noted the problem
    for (const auto& [name, item] : section.members("definitions")) {
      const auto declared = lexicon_.names.find(name);
      if (!item.is_object() || declared == lexicon_.names.end()) continue;
      if (const auto term = read_term(item.required("term", "what it means"), declared->second))
        lexicon_.definitions.emplace(name, *term);
      const auto compared = item.member("compared");
      if (!compared.truth(false)) continue;
      if (declared->second != Type::list(Type::entity()))
        compared.problem(
            fmt::format("'{}' is of type {}; expected e*, objects to compare", name, declared->second.text()));
      else if (!lexicon_.operators.compared.empty())
        compared.problem(fmt::format("what is compared is '{}' already", lexicon_.operators.compared));
      else
        lexicon_.operators.compared = name;
    }
  }
}

void LexiconReader::read_scope() {
  for (const auto& [outer, inner] : members_of("scope", "names around other names"))
    for (const auto& around : spellings(outer))
      for (const auto& [name, item] : inner.members("what names mean there")) {
        const auto declared = lexicon_.names.find(name);
        if (declared == lexicon_.names.end() || !lexicon_.names.contains(around))
          item.problem_at_key(
              fmt::format("found {} within {}, expected declared names", in_quotes(name), in_quotes(around)));
        else if (const auto term = read_term(item, declared->second))
          lexicon_.definitions.emplace(scoped_name(around, name), *term);
      }
}

std::optional<Term> LexiconReader::read_term(const Item& item, const Type& expected) {
  const auto text = item.text("a term");
  if (!item.is_text()) return std::nullopt;
  const auto term = parse_term(text, lexicon_.names, expected);
  if (!term) return problem_with_quote(item, term.error()), std::nullopt;
  const auto reduced = normal(*term);
  if (reduced.is_null() && !term->is_null()) return item.problem("this term has no normal form"), std::nullopt;
  return reduced;
}

}  // namespace continua
