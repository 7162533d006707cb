// The inputs that a record of a run log came of.
#pragma once

#include <set>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

/// The numbers of the inputs that the record's `because` names, and of those behind the registers and symbols that it
/// names.
inline std::set<std::size_t> inputs_behind(const std::vector<Json>& records, const Json& record) {
  std::set<std::size_t> met, inputs;
  std::vector<const Json*> open = {&record};
  while (!open.empty()) {
    const Json& of = *open.back();
    open.pop_back();
    if (!of.contains("because")) continue;
    for (const auto& source : of["because"]) {
      const auto n = source.get<std::size_t>();
      if (!met.insert(n).second) continue;
      if (records.at(n)["kind"] == "input")
        inputs.insert(n);
      else
        open.push_back(&records.at(n));
    }
  }
  return inputs;
}

}  // namespace continua
