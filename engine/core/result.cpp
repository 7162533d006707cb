#include "continua/core/result.h"

#include <cstdio>
#include <cstdlib>

namespace continua {

void require(bool holds, const char* sentence) {
  if (holds) return;
  std::fprintf(stderr, "continua: broken invariant: %s\n", sentence);
  std::abort();
}

}  // namespace continua
