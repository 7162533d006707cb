// What can be done with objects, as far as their voxemes tell (semantics §4). Where an object has no voxeme nothing is
// known of it and nothing is forbidden.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/body/reason.h"
#include "continua/term/term.h"
#include "continua/voxml/catalogue.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// Of the scene's object: that of its name, else of its type; nullptr if it has none.
const Voxeme* voxeme_of(const ObjectState& object, const Catalogue& catalogue);

/// Does the object's voxeme afford, in a habitat that holds, what is called `what`: an event that takes the object, or
/// a part of it ('grasp', 'slide'), or a relation to it in which an event puts something ('in', 'on')? Conditions
/// beside the habitat are what an agent can bring about, and are passed over. Nothing where there is no voxeme.
std::optional<bool> affords(const ObjectState& object, const Catalogue& catalogue, std::string_view what);

/// The obstacle to a program, put(cup, on(plate)); `none` if nothing speaks against it. FACTS.md lists the codes.
/// What a program asks of its objects follows from its steps, down to those of the body's own.
ReasonCode obstacle(const Term& program, const WorldSnapshot& world, const Catalogue& catalogue);

}  // namespace continua
