// Checks that the steps of programs name existing programs and relations.
#pragma once

#include <vector>

#include "continua/voxml/catalogue.h"

namespace continua {

/// The problems of the programs' steps, each at its document: an event that names no program, a condition or place that
/// names no relation, or a wrong number of arguments. An agent may be left out. A condition has all arguments, at(y,z);
/// a place leaves out its thing, near(z). Built in are def(loc(y),as('l1')) and repeat(2,'swap(y,z)').
/// In programs whose head is `assignment` also extend(x,y) and def(vec(x -> y × z),as(w)), whose names must be
/// arguments: w of a compound type such as physobj[]•location, y the finger that was extended before.
std::vector<Error> check_programs(const Catalogue& catalogue);

}  // namespace continua
