#include "continua/machine_file/machine_terms.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/machine_file/machine_keys.h"
#include "continua/term/evaluate.h"

namespace continua {
namespace {

// A chain of definitions, each naming the next, is read recursively; the limit protects the call stack.
constexpr std::size_t deepest_definition = 100;
// A lambda with more variables matches no term that people write.
constexpr std::size_t most_variables = 16;

// Names of the moment that every term may read; FORMAT.md documents them.
const Signature& moment_signature() {
  static const Signature names = [] {
    Signature all = {
        {"input", Type::text_type()},
        {"confidence", Type::number()},
        {"now", Type::number()},
        {"in_state", Type::text_type()},
        {"looked_at", Type::list(Type::entity())},
        {"is_input", Type::function(Type::text_type(), Type::truth())},
        {"certainty", Type::function(Type::text_type(), Type::number())},
        {"wording", Type::function(Type::term(), Type::text_type())},
    };
    for (const auto& carried : carried_terms())
      if (!carried.understood) all.emplace(carried.name, *Type::parse(carried.type));
    return all;
  }();
  return names;
}

// "\x y. put(x, y)" gives "\x y. "; a term that is not a lambda gives "".
std::string binders_of(const std::string& lambda) {
  const auto begin = lambda.find_first_not_of(' ');
  const bool is_lambda = begin != std::string::npos && (lambda[begin] == '\\' || lambda.compare(begin, 2, "λ") == 0);
  const auto dot = lambda.find('.');
  return is_lambda && dot != std::string::npos ? lambda.substr(0, dot + 1) + " " : std::string();
}

// Reads the definitions that are terms, each after those that it mentions.
class DefinitionReader {
 public:
  DefinitionReader(const Item& definitions, TermReader& reader, const Signature& scope)
      : definitions_(definitions), terms_(reader), scope_(scope) {}

  void read(const std::string& name) {
    if (!begun_.insert(name).second) return;
    const auto item = definitions_.member(name);
    const auto text = item.text("a term or a table of terms");
    const bool needs_itself = read_mentioned(name, text);
    if (needs_itself) item.problem(fmt::format("the definition of {} leads back to itself", in_quotes(name)));
    const bool readable = item.is_text() && !needs_itself;
    const auto term = readable ? terms_.term(item, Type::term()) : std::nullopt;
    terms_.declare(item, name, term ? term->type() : Type::term());
    if (term) terms.emplace(name, *term);
  }

  std::map<std::string, Term, std::less<>> terms;

 private:
  // Reads the definitions that `text` mentions. Returns whether one of them is still under reading: a circle, unless
  // the name is only a variable here.
  bool read_mentioned(const std::string& name, const std::string& text) {
    bool circle = false;
    path_.push_back(name);
    for (const auto& other : names_in(text)) {
      if (!definitions_.member(other).is_text() || path_.size() > deepest_definition) continue;
      if (std::find(path_.begin(), path_.end(), other) != path_.end())
        circle = true;
      else
        read(other);
    }
    path_.pop_back();
    return circle && !parse_term(text, scope_);
  }

  const Item& definitions_;
  TermReader& terms_;
  const Signature& scope_;
  std::set<std::string, std::less<>> begun_;
  std::vector<std::string> path_;  // the names under reading, each mentioned by the one before
};

}  // namespace

TermReader::TermReader(const Signature& facts, const RaisingRules* raising)
    : facts_(facts), scope_(term_signature()), raising_(raising) {
  scope_.insert(facts_.begin(), facts_.end());
  scope_.insert(moment_signature().begin(), moment_signature().end());
}

TermReader TermReader::of_programs(const Signature& programs) {
  TermReader reader;
  reader.scope_ = term_signature();
  reader.scope_.insert(programs.begin(), programs.end());
  return reader;
}

void TermReader::add_understood() {
  for (const auto& carried : carried_terms())
    if (carried.understood) scope_.emplace(carried.name, *Type::parse(carried.type));
}

void TermReader::declare(const Item& at, const std::string& name, const Type& type) {
  const bool is_word = name == "null" || name == "true" || name == "false";
  if (name.empty())
    at.problem_at_key("found '', expected a name");
  else if (is_word || !scope_.emplace(name, type).second)
    at.problem_at_key(fmt::format("the name {} is taken by {}; expected another", in_quotes(name),
                                  is_word || term_signature().contains(name) ? "the term language"
                                  : facts_.contains(name)                    ? "a fact of the world"
                                  : moment_signature().contains(name)        ? "what every term may read"
                                                                             : "an earlier declaration"));
}

std::optional<Term> TermReader::term(const Item& item, const Type& expected) const {
  return part(item, 0, item.text("a term"), expected, "");
}

std::optional<Term> TermReader::content(const Item& item, const Type& type) const {
  const auto text = item.text("a term");
  if (raising_ && item.is_text() && !parse_term(text, scope_, type))
    for (const auto& rule : *raising_)
      if (consistent(rule.to, type))
        if (auto lower = parse_term(text, scope_, rule.from)) return *std::move(lower);
  return term(item, type);
}

std::optional<Term> TermReader::part(const Item& item, std::size_t from, const std::string& text, const Type& expected,
                                     const std::string& binders) const {
  if (!item.is_text() || item.reader_is_full()) return std::nullopt;
  auto term = parse_term(binders + text, scope_, expected);
  if (term) return *std::move(term);
  const auto byte = byte_of_column(term.error());
  item.problem_in_text(from + (byte < binders.size() ? 0 : byte - binders.size()),
                       fmt::format("{}, in {}", term.error().sentence, in_quotes(text)));
  return std::nullopt;
}

TermReader::Definitions TermReader::definitions(const Item& item) {
  Definitions definitions;
  const auto members = item.members("definitions");
  for (const auto& [name, entry] : members)
    if (entry.is_object()) declare(entry, name, Type::function(Type::text_type(), Type::term()));
  DefinitionReader reader(item, *this, scope_);
  for (const auto& [name, entry] : members)
    if (!entry.is_object()) reader.read(name);
  definitions.terms = std::move(reader.terms);
  for (const auto& [name, table] : members) {
    if (!table.is_object()) continue;
    auto& entries = definitions.tables[name];
    for (const auto& [key, entry] : table.members("a table of terms"))
      if (const auto value = term(entry, Type::term())) entries.emplace(key, *value);
  }
  return definitions;
}

std::vector<Wording> TermReader::wordings(const Item& item) const {
  std::vector<Wording> wordings;
  for (const auto& each : item.elements("the wordings"))
    if (auto read = wording(each)) wordings.push_back(std::move(*read));
  return wordings;
}

std::optional<Wording> TermReader::wording(const Item& item) const {
  if (!expect_kind(item, "a wording")) return std::nullopt;
  const auto of = item.required("of", "a lambda, the shape of the term");
  const auto say = item.required("say", "its words");
  const auto pattern = term(of, Type::term());
  if (!pattern) return std::nullopt;
  const auto binders = binders_of(of.text("a term"));
  Wording wording{{}, *pattern, std::nullopt, {}};
  while (wording.pattern.kind() == Term::Kind::lambda && wording.variables.size() < most_variables) {
    wording.variables.push_back(wording.pattern.variable_type());
    wording.pattern = Term(wording.pattern.body());
  }
  if (const auto when = item.member("when"); when.exists()) {
    auto type = Type::truth();
    for (auto variable = wording.variables.rbegin(); variable != wording.variables.rend(); ++variable)
      type = Type::function(*variable, type);
    wording.when = part(when, 0, when.text("a condition"), type, binders);
  }
  if (const auto words = text_template(say, binders)) wording.say = *words;
  return wording;
}

std::optional<Template> TermReader::text_template(const Item& item, const std::string& binders) const {
  const auto text = item.text("what is said");
  const auto unpaired = [&](std::size_t byte) {
    item.problem_in_text(byte, fmt::format("a '{}' without its '{}'", text[byte], text[byte] == '{' ? '}' : '{'));
    return std::nullopt;
  };
  Template result;
  for (std::size_t at = 0;;) {
    const auto brace = text.find_first_of("{}", at);
    result.literals.push_back(text.substr(at, brace == std::string::npos ? brace : brace - at));
    if (brace == std::string::npos) return result;
    const auto close = text.find_first_of("{}", brace + 1);
    if (text[brace] == '}' || close == std::string::npos || text[close] == '{') return unpaired(brace);
    const auto hole = part(item, brace + 1, text.substr(brace + 1, close - brace - 1), Type::term(), binders);
    if (!hole) return std::nullopt;
    result.holes.push_back(*hole);
    at = close + 1;
  }
}

}  // namespace continua
