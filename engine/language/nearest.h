// "the block left of the cup": of several blocks there, speakers mean the one that is clearly nearest to the cup.
#pragma once

#include "continua/language/reference.h"

namespace continua {

/// A thing is clearly nearest if its distance is at most this share of the second. Distances are those of centres, seen
/// from above. Of the expressions "left of …", "near …" in exams, people meant the nearest at shares up to 0.72.
inline constexpr double clearly_nearest = 0.75;

/// The reference with the clearly nearest referent alone, if `condition` (\x. block(x) and located(x, left(cup))) puts
/// its things on a side of one landmark, near or beside it; else the reference as it is.
Reference nearest_to_landmark(Reference reference, const Term& condition, const Context& context,
                              const Meanings& meanings);

}  // namespace continua
