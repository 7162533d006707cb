// Kinds of records by their types, for readers that go by a log's index and not by whole records:
//   if (log::is<log::Act>(run.kind(n)))
#pragma once

#include <string_view>

#include "continua/replay/log/records.h"

namespace continua::log {

/// Whether `kind` is the name of T.
template <IsRecord T>
constexpr bool is(std::string_view kind) {
  return kind == T::kind.name;
}

/// Whether `kind` is the name of one of these.
template <IsRecord... Kinds>
constexpr bool is_any(std::string_view kind) {
  return (is<Kinds>(kind) || ...);
}

}  // namespace continua::log
