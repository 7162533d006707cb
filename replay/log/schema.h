// The kinds of records and their members as values: everything that fields() declares, for readers that go by names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/log/fields.h"

namespace continua::log {

/// A member of a record, or of an object within a record.
struct MemberSchema {
  std::string_view name;
  std::string type;       ///< "text", "number", "whole number", "list of text", "object", "text or null" …
  bool left_out = false;  ///< a record may lack it
  Says says = Says::what;
  std::string_view sentence, form;
  bool in_brief = false;                     ///< brief() reads it
  bool follows = false;                      ///< other members determine it, so it is no decision of its own
  std::vector<std::string_view> leaves_out;  ///< of an object with members that the log does not declare
  std::vector<MemberSchema> members;         ///< of the objects in its value
};

struct KindSchema {
  Kind kind;
  std::vector<MemberSchema> members;  ///< in the order in which they are written, after those of the stamp

  bool is_decision() const { return kind.decision != Decision::no; }
};

/// All kinds, in the order of RECORDS.md.
const std::vector<KindSchema>& schema();

/// The kind of this name; nullptr if this program does not know it.
const KindSchema* schema_of(std::string_view kind);

/// Members that records of every kind have, without `kind`.
const std::vector<MemberSchema>& stamp_schema();

/// The schema for the page: {"stamp": [member], "kinds": [{"name", "when", "decision": "no", "yes" or "outcome",
/// "members": [member]}]} with members as {"name", "type", "optional", "says", "meaning"} and, where there are any,
/// "form" and "members".
Json schema_json();

/// Whether two runs are compared by such members.
constexpr bool tells_content(Says says) { return says == Says::what || says == Says::how; }

/// "what", "how", "where" or "aside".
std::string_view name_of(Says says);

}  // namespace continua::log
