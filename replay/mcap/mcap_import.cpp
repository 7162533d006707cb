#include "continua/replay/mcap/mcap_import.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "continua/replay/log/run_brief.h"
#include "continua/replay/mcap/mcap_reader.h"
#include "continua/replay/mcap/ros4hri_frames.h"
#include "continua/replay/mcap/ros_message.h"
#include "continua/replay/mcap/run_channels.h"
#include "continua/replay/recogniser/recogniser_import.h"
#include "continua/replay/recogniser/ros4hri.h"
#include "continua/replay/trace/trace_header.h"

namespace continua {
namespace {

constexpr double nanosecond_s = 1e-9;

class McapImport {
 public:
  McapImport(const std::string& name, const std::string& world) : world_(world), frames_(world) { trace_.name = name; }

  Result<Trace> read(std::istream& in) {
    const McapUse use{[this](const McapChannel& channel) { return wanted(channel); },
                      [this](const McapMessage& message) { return take(message); },
                      [this](const std::string& name, const McapEntries& entries) { return take(name, entries); }};
    if (auto problem = read_mcap(in, trace_.name, use)) return *problem;
    for (const auto& frame : frames_.unconnected())
      note(fmt::format("{} is left out: no transforms lead from it to the frame {}", in_quotes(frame),
                       in_quotes(world_)));
    auto& events = own_.empty() ? ros_ : own_;
    if (events.empty()) return nothing_found();
    if (own_.empty()) trace_.header.source = std::filesystem::path(trace_.name).filename().string();
    return with_events(std::move(trace_), std::move(events));
  }

 private:
  bool wanted(const McapChannel& channel) {
    const auto& type = channel.schema.name;
    const auto ros = ros_type(type);
    if (type != mcap_event_schema && ros != "hri_msgs/LiveSpeech" && ros != "hri_msgs/Gesture" &&
        ros != "tf2_msgs/TFMessage")
      return false;
    const bool readable = channel.message_encoding == "json" ||
                          (channel.message_encoding == "cdr" && channel.schema.encoding == "ros2msg");
    if (!readable)
      note(fmt::format("{} is left out: found messages in {} by a schema in {}; expected json, or cdr by ros2msg",
                       in_quotes(channel.topic), in_quotes(channel.message_encoding),
                       in_quotes(channel.schema.encoding)));
    return readable;
  }

  Outcome take(const McapMessage& message) {
    const auto json = decoded(message);
    if (!json) return json.error();
    const auto t_s = static_cast<double>(message.t_ns) * nanosecond_s;
    if (message.channel.schema.name == mcap_event_schema) return take_event(*json, t_s);
    if (ros_type(message.channel.schema.name) == "tf2_msgs/TFMessage") {
      for (auto& event : frames_.take(*json, t_s)) ros_.push_back(std::move(event));
    } else if (is_ros4hri(*json)) {
      if (auto event = ros4hri_event(*json, t_s)) ros_.push_back(*std::move(event));
    }
    return std::nullopt;
  }

  Result<Json> decoded(const McapMessage& message) {
    if (message.channel.message_encoding == "json") {
      auto json = parse_json_line(message.data, in_quotes(message.channel.topic), 1);
      if (json && !json->is_object())
        return Error{in_quotes(message.channel.topic), "found " + in_quotes(message.data) + "; expected a JSON object"};
      return json;
    }
    const auto& schema = message.channel.schema;
    auto& definition = definitions_[schema.name];
    if (definition.type.empty()) {
      auto read = read_ros_definition(schema.name, schema.data);
      if (!read) return read.error();
      definition = *std::move(read);
    }
    return message_of_cdr(definition, message.data);
  }

  // An event without a time has that of its message.
  Outcome take_event(Json event, double t_s) {
    if (!event.contains("t")) event["t"] = t_s;
    if (!event["t"].is_number() || !std::isfinite(event["t"].get<double>()))
      return Error{"", fmt::format("found the time {}; expected a number", event["t"].dump())};
    own_.push_back(std::move(event));
    return std::nullopt;
  }

  Outcome take(const std::string& name, const McapEntries& entries) {
    for (const auto& [key, value] : entries) {
      if (name != mcap_metadata || key != "trace") continue;
      std::vector<Error> problems;
      const auto header = header_from_line(std::string_view(value), "the trace's header", 1, problems);
      if (!problems.empty()) return problems.front();
      if (header) trace_.header = *header;
    }
    return std::nullopt;
  }

  Error nothing_found() const {
    const auto notes = trace_.notes.empty() ? "" : "; " + trace_.notes.front().sentence;
    return {trace_.name,
            "found no event; expected a channel of continua.Event, hri_msgs/LiveSpeech or hri_msgs/Gesture with "
            "something in it, or transforms of ROS4HRI's gaze_ID, l_wrist_ID or r_wrist_ID" +
                notes};
  }

  void note(std::string sentence) { trace_.notes.push_back({1, std::move(sentence)}); }

  std::string world_;
  Ros4hriFrames frames_;
  Trace trace_;
  std::map<std::string, RosDefinition> definitions_;  // by the schema's name
  std::vector<Json> own_, ros_;
};

}  // namespace

Result<Trace> trace_of_mcap(std::istream& in, const std::string& name, const std::string& world) {
  return McapImport(name, world).read(in);
}

}  // namespace continua
