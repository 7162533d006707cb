#include "continua/term/written_term.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "continua/term/syntax.h"

namespace continua {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Writer {
 public:
  explicit Writer(std::string_view text) : text_(text) {}

  WrittenTerm term(const Syntax& syntax) const {
    using Kind = WrittenTerm::Kind;
    WrittenTerm term;
    term.written = text_.substr(syntax.from, syntax.end - syntax.from);
    switch (syntax.kind) {
      case Syntax::Kind::literal:
        literal(syntax.literal, term);
        return term;
      case Syntax::Kind::name:
        term.kind = Kind::name;
        term.name = syntax.name;
        return term;
      case Syntax::Kind::list:
        term.kind = Kind::list;
        break;
      case Syntax::Kind::lambda:
        return lambda(syntax, std::move(term));
      case Syntax::Kind::apply:
        if (is_call(syntax)) {
          term.kind = Kind::call;
          term.name = syntax.parts.front().name;
          for (std::size_t i = 1; i < syntax.parts.size(); ++i) term.parts.push_back(this->term(syntax.parts[i]));
          return term;
        }
    }
    for (const auto& part : syntax.parts)
      if (part.end > 0) term.parts.push_back(this->term(part));  // an operator is not an operand
    return term;
  }

 private:
  static void literal(const Term& literal, WrittenTerm& term) {
    using Kind = WrittenTerm::Kind;
    if (literal.kind() == Term::Kind::number) {
      term.kind = Kind::number;
      term.number = literal.number_value();
    } else if (literal.kind() == Term::Kind::text) {
      term.kind = Kind::text;
    } else if (literal.kind() == Term::Kind::place) {
      term.kind = Kind::place;
      term.place = literal.place_value();
    }
  }

  // Whether it is a name right before its parentheses, without parentheses around the whole.
  bool is_call(const Syntax& syntax) const {
    const auto& function = syntax.parts.front();
    const auto open = function.begin + function.name.size();
    return function.kind == Syntax::Kind::name && function.begin == syntax.from && open < syntax.end &&
           text_.substr(function.begin, function.name.size()) == function.name && text_[open] == '(';
  }

  // \x y. body is one lambda for each variable. The lambdas after the first are not terms of the text and have no end.
  WrittenTerm lambda(const Syntax& syntax, WrittenTerm term) const {
    term.kind = WrittenTerm::Kind::lambda;
    const Syntax* inner = &syntax;
    term.binders.push_back(inner->name);
    for (inner = &inner->parts.front(); inner->kind == Syntax::Kind::lambda && inner->end == 0;
         inner = &inner->parts.front())
      term.binders.push_back(inner->name);
    term.parts.push_back(this->term(*inner));
    return term;
  }

  std::string_view text_;
};

}  // namespace

Result<WrittenTerm> read_written_term(std::string_view text) {
  const auto syntax = parse_syntax(text, {});
  if (!syntax) return syntax.error();
  return Writer(text).term(*syntax);
}

const Place* last_place(const WrittenTerm& term) {
  if (term.kind == WrittenTerm::Kind::place) return &term.place;
  for (auto part = term.parts.rbegin(); part != term.parts.rend(); ++part)
    if (const auto* place = last_place(*part)) return place;
  return nullptr;
}

bool mentions(std::string_view text, std::string_view name) {
  if (name.empty()) return false;
  for (auto at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || !is_word(text[at - 1]) || !is_word(name.front())) &&
        (end == text.size() || !is_word(text[end]) || !is_word(name.back())))
      return true;
  }
  return false;
}

}  // namespace continua
