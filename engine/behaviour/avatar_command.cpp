#include "behaviour/avatar_command.h"

namespace continua {

bool moves_to_goal(Capability what) {
  return what == Capability::put || what == Capability::slide || what == Capability::push || what == Capability::move;
}

std::string text(Capability what) {
  switch (what) {
    case Capability::reach:
      return "reach";
    case Capability::point:
      return "point";
    case Capability::look:
      return "look";
    case Capability::grasp:
      return "grasp";
    case Capability::lift:
      return "lift";
    case Capability::put:
      return "put";
    case Capability::slide:
      return "slide";
    case Capability::move:
      return "move";
    case Capability::push:
      return "push";
    case Capability::turn:
      return "turn";
    case Capability::ungrasp:
      return "ungrasp";
    case Capability::retract:
      return "retract";
    case Capability::stop:
      return "stop";
    case Capability::signal:
      return "signal";
  }
  return "";
}

std::string text(ActReport::Status status) {
  switch (status) {
    case ActReport::Status::started:
      return "started";
    case ActReport::Status::done:
      return "done";
    case ActReport::Status::missed:
      return "missed";
    case ActReport::Status::dropped:
      return "dropped";
    case ActReport::Status::blocked:
      return "blocked";
    case ActReport::Status::unreachable:
      return "unreachable";
    case ActReport::Status::unstable:
      return "unstable";
    case ActReport::Status::stopped:
      return "stopped";
  }
  return "";
}

}  // namespace continua
