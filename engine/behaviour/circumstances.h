// Values of VoxML expressions, and the truth of VoxML conditions, in the present world.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "continua/term/term.h"
#include "continua/voxml/expression.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// Values of names: x, l1, and [1] for a part.
using Bindings = std::map<std::string, Term, std::less<>>;

/// The earlier places of objects that acts have moved, by the names of the objects.
struct EarlierPlaces {
  Bindings was;         ///< before the last act that moved it: was(cup)
  Bindings originally;  ///< before the first: originally(cup)
};

/// The avatar as the agent of programs.
Term agent_term();

/// An object's place as a term: on(plate) or in(cup) if it stands there, else the point below its centre.
Term place_term(const ObjectState& object, const WorldSnapshot& world);

class Circumstances {
 public:
  /// `perspective` is whose sides place terms mean. `brought` are the things that the act has brought to their places
  /// so far. A thing is at a wide place, such as left(plate), only after the act has brought it there: standing
  /// somewhere to the left is not enough. The world and `brought` must outlive the circumstances.
  Circumstances(Perspective perspective, const WorldSnapshot& snapshot, const std::set<std::string>& brought)
      : perspective_(perspective), world_(snapshot), brought_(brought) {}

  const WorldSnapshot& world() const { return world_; }
  Perspective perspective() const { return perspective_; }

  /// put(x, on(y)) with the values of x and y; loc(y) is the place of y. An unbound name is the thing of the world with
  /// that name, else a constant.
  Term value(const Expression& expression, const Bindings& bindings) const;
  /// The truth of hold(x,y), of relations (world/relations.h) such as at(y,z) and on(y,z), of contain(z,y) and
  /// support(z,y), and of their combinations with ! ^ |. Nothing if the world cannot tell.
  std::optional<bool> hold(const Expression& condition, const Bindings& bindings) const;

 private:
  std::optional<bool> one_holds(const Expression& condition, const Bindings& bindings) const;

  Perspective perspective_;
  const WorldSnapshot& world_;
  const std::set<std::string>& brought_;
};

}  // namespace continua
