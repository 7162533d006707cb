// The keys of a machine file, which FORMAT.md describes and machine.schema.json states for editors.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace continua {

/// For each kind of object, as errors call it ("a transition"), the keys that it may have.
const std::map<std::string, std::vector<std::string>, std::less<>>& machine_keys();

}  // namespace continua
