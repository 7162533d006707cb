// Outputs of recognisers that a client of a live session sends as they are: the session's own readers make events of
// them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/recogniser/recogniser_output.h"

namespace continua {

class LiveRecognisers {
 public:
  /// `knowledge`: the folder, for recognisers of hands.
  explicit LiveRecognisers(std::string knowledge) : knowledge_(std::move(knowledge)) {}

  /// The events, with those that are known by an output in the place of each event {"kind": "recognised", "from":
  /// format, "parts": [values as the recogniser writes them], "camera": as of read_camera, "end": true}. Without
  /// `camera` it is that of the event before. At the `end`, and where the camera is another one, whatever goes on stops
  /// and the recogniser begins anew. Errors: the first part that cannot be read, and why; the recogniser then begins
  /// anew.
  Result<std::vector<Json>> known_by(const std::vector<Json>& events);

  /// Nothing more is heard: what was heard so far is forgotten.
  void end() { heard_.clear(); }

 private:
  struct Heard {
    std::string camera;
    RecogniserStream stream;
  };

  Outcome hear(const Json& event, std::vector<Json>& known);
  Result<Heard*> heard_from(const std::string& from, const std::string& camera, std::vector<Json>& known);

  const std::string knowledge_;
  std::map<std::string, Heard> heard_;  // by their formats
};

}  // namespace continua
