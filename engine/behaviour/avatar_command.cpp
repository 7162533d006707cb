#include "behaviour/avatar_command.h"

namespace continua {

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
    case Capability::ungrasp:
      return "ungrasp";
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
    case ActReport::Status::stopped:
      return "stopped";
  }
  return "";
}

}  // namespace continua
