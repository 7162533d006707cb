// Common parts of the comparisons with the naive twin.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "support/catch.h"

namespace continua {

inline const std::size_t longest_word = 6;
/// So many configurations at once the twin compares one by one; where there are more, exploring is not compared.
inline const std::size_t most_compared = 40;

/// How many machines are drawn; CONTINUA_TWIN_MACHINES asks for more than a test run has time for.
inline std::uint64_t samples(std::uint64_t usual) {
  const char* wanted = std::getenv("CONTINUA_TWIN_MACHINES");
  return wanted ? std::strtoull(wanted, nullptr, 10) : usual;
}

struct Agreement {
  std::size_t machines = 0, words = 0;
  /// Says so, where more was asked for than a test run needs.
  void tell() const {
    if (std::getenv("CONTINUA_TWIN_MACHINES")) WARN(machines << " machines and " << words << " words agree");
  }
};

}  // namespace continua
