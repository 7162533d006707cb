// "the block near the cup": of several blocks there, speakers mean the one that is clearly nearest to the cup. The same
// is not true of sides: EMRE's speakers say "the block left of the cup" of the farther one as well.
#pragma once

#include "continua/language/reference.h"

namespace continua {

/// A thing is clearly nearest if its distance is at most this share of the second. Distances are those of centres, seen
/// from above. In exams people meant the nearest at shares up to 0.72.
inline constexpr double clearly_nearest = 0.75;

/// The reference with the clearly nearest referent alone, if `condition` (\x. block(x) and located(x, near(cup))) puts
/// its things near or beside one landmark; else the reference as it is.
Reference nearest_to_landmark(Reference reference, const Term& condition, const Context& context,
                              const Meanings& meanings);

}  // namespace continua
