// Affordances of objects, by their voxemes (SEMANTICS.md §4). An object without a voxeme forbids nothing.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/body/reason.h"
#include "continua/term/term.h"
#include "continua/voxml/catalogue.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// The voxeme of an object of the scene, by its name, else by its type; nullptr if it has none.
const Voxeme* voxeme_of(const ObjectState& object, const Catalogue& catalogue);

/// Whether the object's voxeme affords `what` in a habitat that holds: an event that takes the object or a part of it
/// ('grasp', 'slide'), or a relation to it in which an event puts something ('in', 'on'). Conditions besides the
/// habitat are ignored, because an agent can bring them about. Nothing if there is no voxeme.
std::optional<bool> affords(const ObjectState& object, const Catalogue& catalogue, std::string_view what);

/// The components by which the voxeme affords grasping, in its order; the whole is left out.
std::vector<std::string> grasp_parts(const Voxeme& voxeme);

/// The obstacle to a program such as put(cup, on(plate)); `none` if there is none. FACTS.md lists the codes. The
/// program's steps, down to those of the body itself, decide what it requires of its objects.
ReasonCode obstacle(const Term& program, const WorldSnapshot& world, const Catalogue& catalogue);

}  // namespace continua
