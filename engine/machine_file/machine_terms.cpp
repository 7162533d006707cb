// The terms of a machine file: definitions, conditions, templates, wordings.
#include <algorithm>

#include <fmt/format.h>

#include "machine_file/machine_reader.h"

namespace continua {
namespace {

// "\x y. put(x, y)" gives "\x y. "; a term that is no lambda gives "".
std::string binders_of(const std::string& lambda) {
  const auto begin = lambda.find_first_not_of(' ');
  const bool is_lambda = begin != std::string::npos && (lambda[begin] == '\\' || lambda.compare(begin, 2, "λ") == 0);
  const auto dot = lambda.find('.');
  return is_lambda && dot != std::string::npos ? lambda.substr(0, dot + 1) + " " : std::string();
}

constexpr std::size_t deepest_definition = 100;

}  // namespace

std::optional<Term> MachineReader::parse(const Item& item, const Type& expected) {
  return item.json ? parse_part(item, 0, text_of(item, "a term"), expected, "") : std::nullopt;
}

// `text` begins at the byte `from` of the item's own, and is read as what follows `binders`.
std::optional<Term> MachineReader::parse_part(const Item& item, std::size_t from, const std::string& text,
                                              const Type& expected, const std::string& binders) {
  if (full() || !item.json->is_string()) return std::nullopt;
  auto term = parse_term(binders + text, scope_, expected);
  if (term) return *term;
  const auto& [where, sentence] = term.error();
  problem_in_text(item, {where, fmt::format("{}, in {}", sentence, in_quotes(text))}, from, binders.size());
  return std::nullopt;
}

void MachineReader::read_definitions(const Item& definitions) {
  if (!expect_object(definitions, "definitions")) return;
  for (const auto& [name, value] : definitions.json->items())
    if (value.is_object()) declare(member(definitions, name), name, Type::function(Type::text_type(), Type::term()));
  std::vector<std::string> path;
  for (const auto& [name, value] : definitions.json->items())
    if (!value.is_object()) read_definition(definitions, name, path);
  for (const auto& [name, value] : definitions.json->items())
    if (value.is_object()) read_table(member(definitions, name), name);
}

// Definitions may use one another in any order: those that this one mentions are read before it. `path` holds the names
// that are being read.
void MachineReader::read_definition(const Item& definitions, const std::string& name, std::vector<std::string>& path) {
  if (!read_definitions_.insert(name).second) return;
  const auto item = member(definitions, name);
  const auto text = text_of(item, "a term or a table of terms");
  bool circle = false;
  path.push_back(name);
  for (const auto& other : names_in(text)) {
    const auto mentioned = member(definitions, other);
    if (!mentioned.json || !mentioned.json->is_string() || path.size() > deepest_definition) continue;
    if (std::find(path.begin(), path.end(), other) != path.end())
      circle = true;
    else
      read_definition(definitions, other, path);
  }
  path.pop_back();
  // In a circle a name is not known yet, unless it is a variable here that only looks like a definition.
  const bool needs_itself = circle && !parse_term(text, scope_);
  if (needs_itself) problem(item, fmt::format("the definition of {} leads back to itself", in_quotes(name)));
  const bool readable = item.json->is_string() && !needs_itself;
  const auto term = readable ? parse(item, Type::term()) : std::nullopt;
  declare(item, name, term ? term->type() : Type::term());
  if (term) machine_.definitions.emplace(name, *term);
}

void MachineReader::read_table(const Item& table, const std::string& name) {
  auto& entries = machine_.tables[name];
  for (const auto& [key, entry] : table.json->items())
    if (const auto term = parse(member(table, key), Type::term())) entries.emplace(key, *term);
}

void MachineReader::read_wordings(const Item& wordings) {
  if (!expect_array(wordings, "the wordings")) return;
  for (std::size_t i = 0; i < wordings.json->size(); ++i) read_wording(element(wordings, i));
}

void MachineReader::read_wording(const Item& item) {
  if (!expect_object(item, "a wording")) return;
  const auto of = required(item, "of", "a lambda, the shape of the term");
  const auto say = required(item, "say", "its words");
  const auto pattern = parse(of, Type::term());
  if (!pattern) return;
  const auto binders = binders_of(of.json->get<std::string>());
  Wording wording{{}, *pattern, std::nullopt, {}};
  while (wording.pattern.kind() == Term::Kind::lambda && wording.variables.size() < 16) {
    wording.variables.push_back(wording.pattern.variable_type());
    wording.pattern = Term(wording.pattern.body());
  }
  if (const auto when = member(item, "when"); when.json) {
    auto type = Type::truth();
    for (auto variable = wording.variables.rbegin(); variable != wording.variables.rend(); ++variable)
      type = Type::function(*variable, type);
    wording.when = parse_part(when, 0, text_of(when, "a condition"), type, binders);
  }
  if (const auto words = read_template(say, binders)) wording.say = *words;
  machine_.wordings.push_back(std::move(wording));
}

std::optional<Template> MachineReader::read_template(const Item& item, const std::string& binders) {
  const auto text = text_of(item, "what is said");
  const auto unpaired = [&](std::size_t byte) {
    note(document_->place_in_text(item.pointer, byte),
         fmt::format("a '{}' without its '{}'", text[byte], text[byte] == '{' ? '}' : '{'));
    return std::nullopt;
  };
  Template result;
  for (std::size_t at = 0;;) {
    const auto brace = text.find_first_of("{}", at);
    result.literals.push_back(text.substr(at, brace == std::string::npos ? brace : brace - at));
    if (brace == std::string::npos) return result;
    const auto close = text.find_first_of("{}", brace + 1);
    if (text[brace] == '}' || close == std::string::npos || text[close] == '{') return unpaired(brace);
    const auto hole = parse_part(item, brace + 1, text.substr(brace + 1, close - brace - 1), Type::term(), binders);
    if (!hole) return std::nullopt;
    result.holes.push_back(*hole);
    at = close + 1;
  }
}

}  // namespace continua
