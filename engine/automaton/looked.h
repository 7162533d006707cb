// The objects that the human looked at lately, as a machine's terms know them.
#pragma once

#include <vector>

#include "continua/term/term.h"

namespace continua {

struct Looked {
  Term objects = Term::list({}, Type::entity());  ///< e*: the most salient first
  std::vector<int> because;                       ///< serials of the inputs that tell so, ascending
};

}  // namespace continua
