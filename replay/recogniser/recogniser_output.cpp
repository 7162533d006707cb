#include "continua/replay/recogniser/recogniser_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "continua/replay/recogniser/json_reader.h"

namespace continua {

const std::vector<RecogniserFormat>& recogniser_formats() {
  static const std::vector<RecogniserFormat> formats = {
      {"whisper", "Whisper's verbose JSON, or whisper.cpp's of -oj or -ojf", "as its segments have them",
       PartKind::json, false, whisper_reader},
      {"vosk", "Vosk's results, one after the other", "as SetWords(True) gives them", PartKind::json, false,
       vosk_reader},
      {"pocketsphinx", "lines of pocketsphinx -time yes", "as -time yes gives them", PartKind::lines, false,
       pocketsphinx_reader},
      {"mediapipe", "results of MediaPipe's GestureRecognizer with timestamp_ms, one after the other",
       "by timestamp_ms", PartKind::json, false, mediapipe_reader},
      {"emma", "W3C's EMMA 1.0", "by emma:start, in milliseconds", PartKind::xml, true, emma_reader},
      {"ros4hri", "messages LiveSpeech and Gesture of hri_msgs and TFMessage as JSON, one after the other",
       "by their header's stamp", PartKind::json, true, ros4hri_reader}};
  return formats;
}

const RecogniserFormat* recogniser_format(std::string_view name) {
  const auto& all = recogniser_formats();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& format) { return format.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<Recognised> RecogniserStream::next() {
  auto part = parts_.next();
  if (!part && ended_) part = parts_.last();
  Recognised gain;
  if (part) {
    line_ = part->line;
    reader_->read(*part, gain);
    return gain;
  }
  if (!std::exchange(finishing_, false)) return std::nullopt;
  reader_->finish(gain);
  return gain;
}

Result<std::vector<Json>> read_output(const RecogniserFormat& format, std::string_view text, OutputSource source) {
  const auto name = source.name;
  RecogniserStream stream(format, std::move(source));
  stream.add(text);
  stream.end();
  std::vector<Json> events;
  while (auto gain = stream.next()) {
    if (!gain->problems.empty()) return gain->problems.front();
    for (auto& event : gain->events) {
      const bool timed = event.contains("t"), passing = event.contains("final");
      if (!timed && passing) continue;  // later words repeat these
      if (!timed) return lacks(name, stream.line(), fmt::format("times, {}; found an event without", format.timed));
      events.push_back(std::move(event));
    }
  }
  return events;
}

}  // namespace continua
