// The program of pointing from its VoxML document (paper, figure of [[point]]; Pustejovsky and Krishnaswamy 2016):
//
//   Args  x:agent  y:finger  z:location  w:physobj[]•location
//   Body  extend(x,y)   def(vec(x->y×z), as(w))
//
// The vector from the agent through the extended finger onto the place defines w: the things that it meets, and the
// place.
#pragma once

#include <optional>

#include "continua/core/result.h"
#include "continua/language/pointing.h"
#include "continua/voxml/catalogue.h"

namespace continua {

/// The predicate of that document.
inline constexpr const char* pointing_predicate = "point";

/// \x y s z. dot(met(vec(x, y, z), s), z) with the document's spread. Nothing if the catalogue has no such program, or
/// one whose head is no assignment. The error, at the document, names the part that is not as above.
Result<std::optional<DeicticProgram>> deictic_program(const Catalogue& catalogue);

}  // namespace continua
