// Affordances of objects, as far as their voxemes tell (SEMANTICS.md §4). An object without a voxeme has no known
// affordance and no known obstacle.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/body/reason.h"
#include "continua/term/term.h"
#include "continua/voxml/catalogue.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// The voxeme of the scene's object: that of its name, else of its type; nullptr if it has none.
const Voxeme* voxeme_of(const ObjectState& object, const Catalogue& catalogue);

/// Whether the object's voxeme affords `what` in a habitat that holds. `what` is an event that takes the object, or a
/// part of it ('grasp', 'slide'), or a relation to it in which an event puts something ('in', 'on'). Conditions besides
/// the habitat are up to the agent, and are passed over. Nothing without a voxeme.
std::optional<bool> affords(const ObjectState& object, const Catalogue& catalogue, std::string_view what);

/// The obstacle to a program, put(cup, on(plate)); `none` if nothing speaks against it. FACTS.md lists the codes. The
/// demands of a program on its objects follow from its steps, down to those of the body's own.
ReasonCode obstacle(const Term& program, const WorldSnapshot& world, const Catalogue& catalogue);

}  // namespace continua
