#include "continua/term/term_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "continua/term/elaborate.h"
#include "continua/term/lexer.h"
#include "continua/term/syntax.h"

namespace continua {
namespace {

void collect_base_types(const Type& type, std::vector<std::string>& names) {
  switch (type.kind()) {
    case Type::Kind::base:
      if (std::find(names.begin(), names.end(), type.name()) == names.end()) names.push_back(type.name());
      break;
    case Type::Kind::variable:
      break;
    case Type::Kind::list:
      collect_base_types(type.element(), names);
      break;
    case Type::Kind::dot:
      collect_base_types(type.first(), names);
      collect_base_types(type.second(), names);
      break;
    case Type::Kind::function:
      collect_base_types(type.from(), names);
      collect_base_types(type.to(), names);
  }
}

void collect_names(const Syntax& syntax, std::set<std::string>& names) {
  if (syntax.kind == Syntax::Kind::name) names.insert(syntax.name);
  for (const auto& part : syntax.parts) collect_names(part, names);
}

Result<Term> read(std::string_view text, const Signature& names, const Type* expected) {
  std::vector<std::string> base_types;
  if (text.find(':') != std::string_view::npos)
    for (const auto& [name, type] : names) collect_base_types(type, base_types);
  auto syntax = parse_syntax(text, base_types);
  if (!syntax) return syntax.error();
  return elaborate(std::move(*syntax), names, expected);
}

}  // namespace

const Signature& core_signature() {
  static const Signature signature = [] {
    constexpr std::array<std::pair<const char*, const char*>, 17> rows = {{
        {"and", "t -> t -> t"},
        {"or", "t -> t -> t"},
        {"not", "t -> t"},
        {"=", "'a -> 'a -> t"},
        {"!=", "'a -> 'a -> t"},
        {"<", "num -> num -> t"},
        {"<=", "num -> num -> t"},
        {">", "num -> num -> t"},
        {">=", "num -> num -> t"},
        {"+", "num -> num -> num"},
        {"-", "num -> num -> num"},
        {"*", "num -> num -> num"},
        {"/", "num -> num -> num"},
        {"negate", "num -> num"},
        {"if", "t -> 'a -> 'a -> 'a"},
        {"xyz", "num -> num -> num -> loc"},
        {"box", "loc -> loc -> loc"},
    }};
    Signature names;
    for (const auto& [name, type] : rows) names.emplace(name, Type::parse(type).value());
    return names;
  }();
  return signature;
}

Result<Term> parse_term(std::string_view text, const Signature& names, const Type& expected) {
  return read(text, names, &expected);
}

Result<Term> parse_term(std::string_view text, const Signature& names) { return read(text, names, nullptr); }

std::set<std::string> names_in(std::string_view text) {
  std::set<std::string> names;
  if (const auto syntax = parse_syntax(text, {})) collect_names(*syntax, names);
  return names;
}

}  // namespace continua
