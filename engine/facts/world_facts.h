// Facts of the world as functions of the term language, documented in FACTS.md. A machine may call these and the
// functions of term/FUNCTIONS.md, and no other C++. Objects are constants of type e, by name; a name that is not in the
// world gives null.
#pragma once

#include <optional>

#include "continua/term/evaluate.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {

class Catalogue;

/// The rules of the facts. They read the world, the generator and the lessons of their evaluation (term/facts.h).
class WorldFacts {
 public:
  /// `perspective`: whose left, right, front and behind the functions mean. `voxemes`: for affordances, which are
  /// unknown without them; they must outlive the rules and their copies.
  explicit WorldFacts(Perspective perspective, const Catalogue* voxemes = nullptr);

  const Rules& rules() const { return rules_; }
  /// Types of all rules.
  static const Signature& signature();

 private:
  Rules rules_;
};

/// Whether an object is at a place, as in the fact `located`; nothing if the object or the place is not in the world.
std::optional<bool> is_located(const Term& entity, const Term& place, const WorldSnapshot& world,
                               Perspective perspective);

}  // namespace continua
