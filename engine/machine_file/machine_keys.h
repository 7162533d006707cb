// The keys of a machine file, which FORMAT.md describes and machine.schema.json states for editors.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/core/document_reader.h"

namespace continua {

/// For each kind of object, as errors call it ("a transition"), the keys that it may have.
const std::map<std::string, std::vector<std::string>, std::less<>>& machine_keys();

/// Whether the item is an object. Another kind of value, or a key that the kind of object does not have, is a problem.
/// REQUIRES that machine_keys() has the kind.
bool expect_kind(const Item& item, const std::string& kind);

}  // namespace continua
