// Whether the steps of programs name things that exist.
#pragma once

#include <vector>

#include "continua/voxml/catalogue.h"

namespace continua {

/// The problems of the programs' steps, each at its document: an event that names no program, a condition or place that
/// names no relation, or one of them with another number of arguments. An agent may be left out, and so may the thing
/// of a place: at(y,z), near(z). Besides the names of the catalogue there are def(loc(y),as('l1')) and
/// repeat(2,'swap(y,z)').
std::vector<Error> check_programs(const Catalogue& catalogue);

}  // namespace continua
