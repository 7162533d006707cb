#include "continua/language/scope.h"

#include <fmt/format.h>
#include <utility>

#include "continua/language/reduction.h"

namespace continua {
namespace {

class Scope {
 public:
  explicit Scope(const Vocabulary& vocabulary) : vocabulary_(vocabulary) {}

  // Not in normal form.
  Term meant(const Term& term) {
    const auto [head, arguments] = term.spine();
    if (head.kind() == Term::Kind::constant) return application(term, head, arguments);
    switch (term.kind()) {
      case Term::Kind::lambda:
        return Term::lambda(term.name(), term.variable_type(), meant(term.body()));
      case Term::Kind::apply:
        return Term::apply(meant(term.function()), meant(term.argument()));
      case Term::Kind::list: {
        std::vector<Term> elements;
        for (const auto& each : term.elements()) elements.push_back(meant(each));
        return Term::list(std::move(elements), term.type().element());
      }
      default:
        return term;
    }
  }

  // The noun phrases that have changed, before and after.
  const std::vector<std::pair<Term, Term>>& changed() const { return changed_; }

 private:
  Term application(const Term& term, const Term& head, const std::vector<Term>& arguments) {
    if (const auto* other = meaning_of(head.name())) {
      Term made = *other;
      for (const auto& each : arguments) made = Term::apply(made, each);
      changed_.emplace_back(term, noun_phrase(normal(made)));
      return made;
    }
    if (determiner_of(term, vocabulary_.lexicon().operators)) return term;
    around_.push_back(head.name());
    Term same = head;
    for (const auto& each : arguments) same = Term::apply(same, meant(each));
    around_.pop_back();
    return same;
  }

  const Term* meaning_of(const std::string& name) const {
    for (const auto& outer : around_)
      if (const auto* found = vocabulary_.definition(scoped_name(outer, name))) return found;
    return nullptr;
  }

  // all(n) of each(all(n)).
  static Term noun_phrase(const Term& made) {
    return made.kind() == Term::Kind::apply && made.argument().kind() == Term::Kind::apply ? made.argument() : made;
  }

  const Vocabulary& vocabulary_;
  std::vector<std::string> around_;  // the names of which the part is an argument, the outermost first
  std::vector<std::pair<Term, Term>> changed_;
};

}  // namespace

std::string scoped_name(std::string_view outer, std::string_view inner) { return fmt::format("{} {}", outer, inner); }

Reading in_scope(const Reading& reading, const Vocabulary& vocabulary) {
  Scope scope(vocabulary);
  const Term meant = scope.meant(reading.term);
  if (scope.changed().empty()) return reading;
  Reading changed = reading;
  changed.term = normal(meant);
  for (auto& phrase : changed.phrases)
    for (const auto& [before, after] : scope.changed())
      if (phrase.term == before) phrase.term = after;
  return changed;
}

}  // namespace continua
