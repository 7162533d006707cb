#include "continua/body/avatar_command.h"

namespace continua {

std::optional<std::string> missing_thing(const AvatarCommand& command, const WorldSnapshot& world) {
  if (!command.object.empty() && !world.find(command.object)) return command.object;
  for (const auto& name : command.goal.landmarks)
    if (!Landmark::named(name, world)) return name;
  if (command.next)
    for (const auto& name : command.next->landmarks)
      if (!Landmark::named(name, world)) return name;
  return std::nullopt;
}

}  // namespace continua
