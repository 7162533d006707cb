// From the term of a program (`put(x, on(y))`, `reach(x)`) to a command for the body.
#pragma once

#include <optional>
#include <string_view>

#include "continua/body/avatar_command.h"
#include "continua/body/reason.h"
#include "continua/term/term.h"
#include "continua/world/perspective.h"

namespace continua {

/// The command for a closed program or gesture; `perspective` is whose sides its place terms mean. A term that is no
/// program of the body's is a signal of that name when `gesture`, otherwise there is a reason.
OrReason<AvatarCommand> plan(const Term& program, bool gesture, Perspective perspective);

/// Whether the term is the name of a thing.
inline bool is_thing(const Term& term) { return term.kind() == Term::Kind::constant && term.type() == Type::entity(); }

/// The most arguments that the body's own program of that name takes; nothing if there is no such program.
std::optional<std::size_t> most_arguments(std::string_view program);

}  // namespace continua
