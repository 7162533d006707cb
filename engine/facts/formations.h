// Collective programs: what several things together are brought into, a row or a circle. The voxeme of such a program
// has a goal instead of steps (voxemes/README.md): the state, as a list of at(thing, place) in the order in which it is
// brought about. The state is reached step by step, by a put for each element.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/evaluate.h"
#include "continua/term/term_text.h"
#include "continua/voxml/catalogue.h"

namespace continua {

/// The goals of a catalogue's collective programs: a value.
class Formations {
 public:
  /// Goals may use the names of the term language, the `facts`, the relations and `at`. A goal that cannot be read is
  /// a problem, and left out.
  Formations(const Catalogue& catalogue, const Signature& facts);

  /// The puts that reach the goal of that program with these arguments: the things, and the place that it needs. Null
  /// if there is no such program, or if its goal does not tell a place for each of its things.
  Term steps(const std::string& program, std::span<const Term> arguments, Evaluation& evaluation) const;

  /// The goals that cannot be read, each at its document.
  const std::vector<Error>& problems() const { return problems_; }

 private:
  std::map<std::string, Term, std::less<>> goals_;
  std::vector<Error> problems_;
};

/// Adds the facts `formed`, `formed_at`, `ring_around` and `ring_within` (FACTS.md). Without voxemes the first two give
/// null. REQUIRES that `voxemes` outlive the rules, and that all facts that goals use are in `signature`.
void add_formation_facts(const Catalogue* voxemes, Rules& rules, Signature& signature);

}  // namespace continua
