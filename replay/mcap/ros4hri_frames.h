// Where people look and point, from the transforms of ROS4HRI (REP 155): the frames of a gaze, and of elbow and wrist
// of each arm.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/world/geometry.h"

namespace continua {

class Ros4hriFrames {
 public:
  /// `world`: the frame that is ours, W.
  explicit Ros4hriFrames(std::string world) : world_(std::move(world)) {}

  /// Takes a message tf2_msgs/TFMessage. The events: a gaze along z of each frame gaze_ID, a pointing from each frame
  /// l_wrist_ID and r_wrist_ID away from the elbow, where a transform on the way to the world was in the message.
  std::vector<Json> take(const Json& message, double t_s);

  /// Frames of gazes and wrists that were never connected with the world.
  std::vector<std::string> unconnected() const;

 private:
  struct Link {
    std::string parent;
    Pose X_PC;  // the frame in its parent
  };
  struct Placed {
    Pose X_WF;
    bool moved = false;  // a transform on the way was in the last message
  };
  std::optional<Placed> placed(const std::string& frame, const std::set<std::string>& moved) const;
  void take_transform(const Json& transform, std::set<std::string>& moved);
  std::optional<Json> event_of(const std::string& frame, const std::set<std::string>& moved, double t_s) const;

  std::string world_;
  std::map<std::string, Link> links_;  // of each frame
  std::set<std::string> people_, connected_;
};

}  // namespace continua
