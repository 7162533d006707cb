#include "continua/replay/explain/explain_term.h"

#include "continua/term/written_term.h"

namespace continua {

TermParts term_parts(std::string_view text) {
  TermParts parts;
  parts.whole = text;
  const auto term = read_written_term(text);
  if (!term) return parts;
  parts.whole = term->written;
  if (term->kind == WrittenTerm::Kind::lambda) {
    parts.binders = term->binders;
    parts.body = term->parts.front().written;
  }
  if (term->kind == WrittenTerm::Kind::call) parts.head = term->name;
  if (term->kind == WrittenTerm::Kind::call || term->kind == WrittenTerm::Kind::list)
    for (const auto& part : term->parts) parts.elements.push_back(part.written);
  return parts;
}

}  // namespace continua
