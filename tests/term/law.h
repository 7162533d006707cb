// A property held against random samples.
#pragma once

#include <rapidcheck.h>

#include <cstdlib>
#include <string>

#include "support/catch.h"

namespace continua {

/// The same samples in every run; RC_PARAMS="seed=2 max_success=20000" asks for others.
void law(const std::string& what, const auto& property) {
  setenv("RC_PARAMS", "seed=1 max_success=300", 0);
  INFO(what);
  CHECK(rc::check(what, property));
}

}  // namespace continua
