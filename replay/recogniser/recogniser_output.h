// Outputs of recognisers as events of a trace: one reader for each format (RECOGNISERS.md). All give events in JSON, as
// a trace has them, with times from the beginning of the recording.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/recogniser/camera.h"
#include "continua/replay/recogniser/output_parts.h"

namespace continua {

/// The gain of a piece of output. An event without `t` has no time of its own.
struct Recognised {
  std::vector<Json> events;
  std::vector<Error> problems;  ///< with file and line: a part is no output of such a recogniser
};

/// A recogniser's output.
struct OutputSource {
  std::string name;      ///< of the file, for problems
  bool untimed = false;  ///< nobody asks for its times: an utterance is not kept until its words' times are known
  std::shared_ptr<const Camera> camera = {};  ///< null: where hands point is not known
  std::string knowledge = {};                 ///< the folder with hand_forms.json, for recognisers of hands
};

/// Reads the parts of one recogniser's output in their order.
class RecogniserReader {
 public:
  explicit RecogniserReader(OutputSource source) : source_(std::move(source)) {}
  virtual ~RecogniserReader() = default;
  /// Adds the events that are known once this part is.
  virtual void read(const OutputPart& part, Recognised& gain) = 0;
  /// Adds those that waited for more output, since there is none.
  virtual void finish(Recognised&) {}

 protected:
  const std::string& name() const { return source_.name; }
  bool is_untimed() const { return source_.untimed; }
  const Camera* camera() const { return source_.camera.get(); }
  const std::string& knowledge() const { return source_.knowledge; }

 private:
  OutputSource source_;
};

/// A recording that lasts for so many seconds is none: its times are those of a calendar.
inline constexpr double least_calendar_s = 1e8;

/// A format that can be read.
struct RecogniserFormat {
  const char* name;
  const char* what;
  const char* timed;  ///< how its events get times
  PartKind parts;
  bool of_calendar;  ///< its times are those of a calendar, not of a recording
  std::unique_ptr<RecogniserReader> (*reader)(OutputSource source);
};

/// In the order of the help.
const std::vector<RecogniserFormat>& recogniser_formats();

/// The format of this name; nullptr for another one.
const RecogniserFormat* recogniser_format(std::string_view name);

/// A recogniser's output as it comes.
class RecogniserStream {
 public:
  RecogniserStream(const RecogniserFormat& format, OutputSource source)
      : reader_(format.reader(std::move(source))), parts_(format.parts) {}

  void add(std::string_view text) { parts_.add(text); }
  /// Nothing more comes.
  void end() { ended_ = finishing_ = true; }
  /// The gain of the next part; none: more output is needed, or all of it has been read.
  std::optional<Recognised> next();
  /// The line on which the part of next() began.
  std::size_t line() const { return line_; }

 private:
  std::unique_ptr<RecogniserReader> reader_;
  OutputParts parts_;
  std::size_t line_ = 1;
  bool ended_ = false, finishing_ = false;
};

/// The events of a whole output. Words that may still change are left out where they have no time. Errors: the first
/// problem; another event has no time.
Result<std::vector<Json>> read_output(const RecogniserFormat& format, std::string_view text, OutputSource source);

std::unique_ptr<RecogniserReader> whisper_reader(OutputSource source);
std::unique_ptr<RecogniserReader> vosk_reader(OutputSource source);
std::unique_ptr<RecogniserReader> pocketsphinx_reader(OutputSource source);
std::unique_ptr<RecogniserReader> mediapipe_reader(OutputSource source);
std::unique_ptr<RecogniserReader> emma_reader(OutputSource source);
std::unique_ptr<RecogniserReader> ros4hri_reader(OutputSource source);

}  // namespace continua
