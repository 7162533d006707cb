// Runs as MCAP files and back; bags of ROS4HRI as traces.
#include "continua/replay/mcap/mcap_import.h"

#include <filesystem>
#include <sstream>

#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/mcap/mcap_reader.h"
#include "continua/replay/mcap/mcap_writer.h"
#include "continua/replay/mcap/message_schemas.h"
#include "continua/replay/mcap/ros_message.h"
#include "continua/replay/mcap/run_channels.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

std::string mcap_of(const RunIndex& run, const std::string& header) {
  std::ostringstream out;
  const auto problem = export_mcap(run, {{1, 2, "look here"}}, header, out);
  if (problem) FAIL(problem->text());
  return out.str();
}

Result<Trace> trace_of(const std::string& bytes, const std::string& world = "world") {
  std::istringstream in(bytes);
  return trace_of_mcap(in, "t.mcap", world);
}

// A run takes inputs of one time by their content, and its log has them in that order.
std::vector<Json> inputs_of(const Trace& trace) {
  std::vector<Json> inputs;
  for (const auto& event : trace.events)
    if (std::holds_alternative<InputEvent>(event.what)) {
      inputs.push_back(Json::parse(write_event(event)));
      inputs.back().erase("row");
    }
  std::sort(inputs.begin(), inputs.end(), [](const Json& a, const Json& b) {
    const double a_s = a["t"], b_s = b["t"];
    return a_s != b_s ? a_s < b_s : a.dump() < b.dump();
  });
  return inputs;
}

// The trace of a run below traces/, if it is there.
std::string trace_path(const fs::path& run) {
  auto name = run.filename().string();
  name.resize(name.find('.'));
  const auto path = run.parent_path() / (name + ".trace.jsonl");
  return fs::exists(path) ? path.string() : std::string();
}

TEST_CASE(
    "Speech, gestures and pointing of a run come back from MCAP, and the file is no longer than 1.5 times the log") {
  std::size_t runs = 0;
  for (const auto& file : fs::recursive_directory_iterator(fs::path(source_dir()) / "traces")) {
    if (!file.path().string().ends_with(".run.jsonl")) continue;
    const auto run = RunIndex::open(file.path().string());
    REQUIRE(run);
    const auto trace = read_trace(trace_path(file.path()));
    if (!trace || text_of(member_of(*run->record(0), "trace"), "digest") != trace->digest) continue;
    INFO(file.path().string());
    const auto bytes = mcap_of(*run, write_header(trace->header));
    CHECK(2 * bytes.size() <= 3 * read_run_log(file.path().string())->size());
    const auto back = trace_of(bytes);
    const auto expected = inputs_of(*trace);
    if (expected.empty()) continue;
    REQUIRE(back);
    CHECK(write_header(back->header) == write_header(trace->header));
    auto events = inputs_of(*back);
    REQUIRE(events.size() == expected.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      CHECK(std::abs(events[i]["t"].get<double>() - expected[i]["t"].get<double>()) < 0.001);
      events[i]["t"] = expected[i]["t"];
      CHECK(events[i] == expected[i]);
    }
    ++runs;
  }
  CHECK(runs > 60);
}

struct Message {
  std::string topic;
  Json json;
  std::uint64_t t_ns = 0;
};

std::vector<Message> messages_of(const std::string& bytes) {
  std::vector<Message> messages;
  std::istringstream in(bytes);
  const auto problem =
      read_mcap(in, "t.mcap",
                {[](const McapChannel&) { return true; },
                 [&](const McapMessage& message) {
                   const auto& schema = message.channel.schema;
                   auto json = message.channel.message_encoding == "json"
                                   ? Result<Json>(Json::parse(message.data))
                                   : message_of_cdr(*read_ros_definition(schema.name, schema.data), message.data);
                   messages.push_back({message.channel.topic, *json, message.t_ns});
                   return Outcome();
                 },
                 [](const std::string&, const McapEntries&) { return Outcome(); }});
  if (problem) FAIL(problem->text());
  return messages;
}

TEST_CASE("A run's channels tell its states, its stack, its words, its scene and its notes") {
  const auto run = RunIndex::open(source_dir() + "/traces/building_blocks.run.jsonl");
  REQUIRE(run);
  std::map<std::string, std::vector<Message>> topics;
  for (auto& message : messages_of(mcap_of(*run, "{}"))) topics[message.topic].push_back(std::move(message));
  CHECK(topics["/state"].size() == run->of_kind("transition").size() + 1);
  CHECK(topics["/state"].back().json["state"] == text_of(*run->record(run->of_kind("transition").back()), "to"));
  CHECK(topics["/avatar/say"].size() == run->of_kind("utterance").size());
  CHECK(topics["/avatar/say"].at(0).json == Json{{"data", "Hello."}});
  CHECK(topics["/humans/voices/human/speech"].size() == topics["/human/speech"].size());
  CHECK(topics["/dialogue"].at(0).json["message"] == "shows “steps up” (start)");
  REQUIRE(topics["/scene"].size() == 1);
  for (const auto& entity : topics["/scene"][0].json["entities"]) CHECK(entity["frame_id"] == entity["id"]);
  CHECK(topics["/tf"].size() == 1 + run->of_kind("pose").size());
  const auto& first = topics["/tf"][0].json["transforms"];
  CHECK(std::none_of(first.begin(), first.end(), [](const Json& one) { return one["child_frame_id"] == "world"; }));
  const auto& moved = topics["/tf"][1].json["transforms"];
  REQUIRE(moved.size() == 1);
  CHECK(moved[0]["child_frame_id"] == "block6");
  CHECK(moved[0]["translation"] == Json{{"x", -0.3184}, {"y", 0.0816}, {"z", 0.09}});
  CHECK(topics["/tf"][1].t_ns == 11500000000);
  CHECK(topics["/stack"].back().json["depth"] == topics["/stack"].back().json["symbols"].size());
  REQUIRE(topics["/notes"].size() == 1);
  CHECK(topics["/notes"][0].json["text"] == "look here");
}

constexpr const char* transforms_definition =
    "geometry_msgs/TransformStamped[] transforms\n"
    "================================================================================\n"
    "MSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring child_frame_id\nTransform transform\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Transform\nVector3 translation\nQuaternion rotation\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Quaternion\nfloat64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n";

Json transform(const std::string& parent, const std::string& child, std::array<double, 3> place,
               std::array<double, 4> xyzw = {0, 0, 0, 1}) {
  return {{"header", {{"frame_id", parent}}},
          {"child_frame_id", child},
          {"transform",
           {{"translation", {{"x", place[0]}, {"y", place[1]}, {"z", place[2]}}},
            {"rotation", {{"x", xyzw[0]}, {"y", xyzw[1]}, {"z", xyzw[2]}, {"w", xyzw[3]}}}}}};
}

// A bag of ROS 2 as a recorder writes it.
class Bag {
 public:
  Bag& add(const std::string& topic, const std::string& type, const std::string& definition, double t_s,
           const Json& message) {
    const auto read = read_ros_definition(type, definition);
    if (!read) FAIL(read.error().text());
    mcap_.message(mcap_.channel({topic, "cdr", {type, "ros2msg", definition}}),
                  std::uint64_t{1700000000} * 1000000000 + static_cast<std::uint64_t>(t_s * 1e9),
                  cdr_of_message(*read, message));
    return *this;
  }
  Bag& speech(double t_s, const Json& message) {
    const auto channel = ros_channel("/humans/voices/v1/speech", "hri_msgs/msg/LiveSpeech");
    return add(channel.topic, channel.schema.name, channel.schema.data, t_s, message);
  }
  Bag& transforms(double t_s, const Json& list) {
    return add("/tf", "tf2_msgs/msg/TFMessage", transforms_definition, t_s, {{"transforms", list}});
  }
  std::string bytes() {
    mcap_.finish();
    return out_.str();
  }

 private:
  std::ostringstream out_;
  McapWriter mcap_{out_, "ros2", "test"};
};

std::string told(const Result<Trace>& trace) {
  if (!trace) return trace.error().text();
  std::string text;
  for (const auto& note : trace->notes) text += note.sentence + "\n";
  for (const auto& event : trace->events) text += write_event(event) + "\n";
  return text;
}

TEST_CASE("Speech, gestures and transforms of ROS4HRI make a trace that begins with the first") {
  const auto half = std::sqrt(0.5);
  Bag bag;
  bag.speech(0, {{"incremental", "put"}})
      .speech(1, {{"final", "put it there"}, {"confidence", 0.75}})
      .add("/humans/bodies/b1/gesture", "hri_msgs/msg/Gesture",
           "std_msgs/Header header\nuint8 WAVING = 6\nuint8 gesture\n"
           "================================================================================\n"
           "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n",
           2, {{"gesture", 6}})
      .transforms(2.5, Json::array({transform("r_elbow_b1", "r_wrist_b1", {0, 0, 0.25})}))
      .transforms(3, {transform("camera", "r_elbow_b1", {0.5, 0, 0}, {half, 0, 0, half}),
                      transform("/table", "camera", {0, -1, 1})})
      .transforms(4, {transform("camera", "gaze_f1", {0, 0, 0.5}), transform("elsewhere", "l_wrist_b2", {0, 0, 0})});
  CHECK(told(trace_of(bag.bytes(), "table")) ==
        R"('l_wrist_b2' is left out: no transforms lead from it to the frame 'table'
{"t":0.0,"kind":"speech","text":"put","final":false}
{"t":1.0,"kind":"speech","text":"put it there","confidence":0.75}
{"t":2.0,"kind":"gesture","name":"waving"}
{"t":3.0,"kind":"pointing","hand":"right","ray":{"from":[0.5,-1.25,1.0],"direction":[0.0,-1.0,0.0]}}
{"t":4.0,"kind":"gaze","ray":{"from":[0.0,-1.0,1.5],"direction":[0.0,0.0,1.0]}}
)");
}

TEST_CASE("Events in JSON of other programs make a trace, channels that cannot be read are told") {
  std::ostringstream out;
  McapWriter mcap(out, "", "test");
  mcap.message(mcap.channel({"/e", "json", {"continua.Event", "jsonschema", "{}"}}), 2500000000,
               R"({"kind":"speech","text":"hi"})");
  mcap.message(mcap.channel({"/s", "ros1", {"hri_msgs/LiveSpeech", "ros1msg", ""}}), 0, "x");
  mcap.finish();
  CHECK(told(trace_of(out.str())) ==
        R"('/s' is left out: found messages in 'ros1' by a schema in 'ros1msg'; expected json, or cdr by ros2msg
{"t":2.5,"kind":"speech","text":"hi"}
)");
}

TEST_CASE("Messages that are not as they should be are errors with their place") {
  const auto one = [](const McapChannel& channel, const std::string& data) {
    std::ostringstream out;
    McapWriter mcap(out, "", "test");
    mcap.message(mcap.channel(channel), 0, data);
    mcap.finish();
    auto text = told(trace_of(out.str()));
    return text.substr(text.find(": ", text.find("chunk")) + 2);
  };
  const McapChannel event{"/e", "json", {"continua.Event", "jsonschema", "{}"}};
  CHECK(one(event, "{") ==
        "'/e':1:2: not valid JSON: syntax error while parsing object key - unexpected end of input; expected string "
        "literal");
  CHECK(one(event, "[]") == "'/e': found '[]'; expected a JSON object");
  CHECK(one(event, R"({"t":"now","kind":"speech"})") == "found the time \"now\"; expected a number");
  CHECK(
      one({"/s", "cdr", {"hri_msgs/msg/LiveSpeech", "ros2msg", "Header header"}}, "").starts_with("the definition of"));
  CHECK(
      one(ros_channel("/s", "hri_msgs/msg/LiveSpeech"), "").starts_with("the message of hri_msgs/LiveSpeech does not"));
}

}  // namespace
}  // namespace continua
