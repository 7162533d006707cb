#include "continua/replay/live/live_recognisers.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace continua {
namespace {

constexpr const char* kind = "recognised";
const std::vector<std::string> members = {"kind", "from", "parts", "camera", "end"};

// Formats whose values are JSON, with times since the beginning of the session.
std::vector<std::string> formats() {
  std::vector<std::string> names;
  for (const auto& format : recogniser_formats())
    if (format.parts == PartKind::json && !format.of_calendar) names.emplace_back(format.name);
  return names;
}

bool is_recognised(const Json& event) {
  const auto found = event.is_object() ? event.find("kind") : event.end();
  return found != event.end() && *found == kind;
}

// Why the event is none of this kind.
Outcome problem_of(const Json& event) {
  const auto wrong = [](std::string sentence) { return Error{kind, std::move(sentence)}; };
  for (const auto& [key, value] : event.items())
    if (std::find(members.begin(), members.end(), key) == members.end())
      return wrong(fmt::format("unknown field {}{}; expected {}", in_quotes(key), did_you_mean(key, members),
                               fmt::join(members, ", ")));
  const auto names = formats();
  const auto from = event.value("from", Json());
  if (std::find(names.begin(), names.end(), from) == names.end())
    return wrong(fmt::format("'from' is {}; expected one of {}", compact(from), fmt::join(names, ", ")));
  if (!event.value("parts", Json::array()).is_array())
    return wrong("'parts' is no list; expected values of the recogniser");
  if (!event.value("end", Json(false)).is_boolean()) return wrong("'end' is neither true nor false");
  return std::nullopt;
}

Outcome add_known(RecogniserStream& stream, std::vector<Json>& known) {
  while (auto gain = stream.next()) {
    if (!gain->problems.empty()) return gain->problems.front();
    for (auto& event : gain->events) known.push_back(std::move(event));
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<Json>> LiveRecognisers::known_by(const std::vector<Json>& events) {
  std::vector<Json> known;
  for (const auto& event : events) {
    if (!is_recognised(event))
      known.push_back(event);
    else if (const auto problem = hear(event, known))
      return *problem;
  }
  return known;
}

Outcome LiveRecognisers::hear(const Json& event, std::vector<Json>& known) {
  if (auto problem = problem_of(event)) return problem;
  const std::string from = event["from"];
  const auto heard = heard_from(from, event.contains("camera") ? compact(event["camera"]) : "", known);
  if (!heard) return heard.error();
  auto& stream = (*heard)->stream;
  for (const auto& part : event.value("parts", Json::array())) stream.add(compact(part) + "\n");
  const bool ends = event.value("end", false);
  if (ends) stream.end();
  auto problem = add_known(stream, known);
  if (ends || problem) heard_.erase(from);
  return problem;
}

// The recogniser with this camera. Empty: that which it has.
Result<LiveRecognisers::Heard*> LiveRecognisers::heard_from(const std::string& from, const std::string& camera,
                                                            std::vector<Json>& known) {
  if (const auto at = heard_.find(from); at != heard_.end()) {
    if (camera.empty() || camera == at->second.camera) return &at->second;
    at->second.stream.end();
    if (const auto problem = add_known(at->second.stream, known)) return *problem;
    heard_.erase(at);
  }
  std::shared_ptr<const Camera> seen_by;
  if (!camera.empty()) {
    const auto read = camera_of_text(camera, "camera");
    if (!read) return read.error();
    seen_by = std::make_shared<const Camera>(*read);
  }
  RecogniserStream stream(*recogniser_format(from), {.name = from, .camera = seen_by, .knowledge = knowledge_});
  return &heard_.emplace(from, Heard{camera, std::move(stream)}).first->second;
}

}  // namespace continua
