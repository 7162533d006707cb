// Outputs of recognisers as events of a trace: one reader for each format (RECOGNISERS.md). All give events in JSON, as
// a trace has them, with times from the beginning of the recording.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// A format that can be read.
struct RecogniserFormat {
  const char* name;
  const char* what;
  Result<std::vector<Json>> (*read)(std::string_view text, const std::string& name);
};

/// In the order of the help.
const std::vector<RecogniserFormat>& recogniser_formats();

/// The format of this name; nullptr for another one.
const RecogniserFormat* recogniser_format(std::string_view name);

// An error names the file and the line: it is no output of such a recogniser.
Result<std::vector<Json>> read_whisper(std::string_view text, const std::string& name);
Result<std::vector<Json>> read_vosk(std::string_view text, const std::string& name);
Result<std::vector<Json>> read_pocketsphinx(std::string_view text, const std::string& name);
Result<std::vector<Json>> read_mediapipe(std::string_view text, const std::string& name);
Result<std::vector<Json>> read_emma(std::string_view text, const std::string& name);
Result<std::vector<Json>> read_ros4hri(std::string_view text, const std::string& name);

}  // namespace continua
