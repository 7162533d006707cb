#include "continua/replay/mcap/run_channels.h"

#include <filesystem>

#include "continua/core/gzip_blocks.h"
#include "continua/core/gzip_name.h"
#include "continua/replay/annotation/event_tiers.h"
#include "continua/replay/export/each_record.h"
#include "continua/replay/export/run_dialogue.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/mcap/mcap_writer.h"
#include "continua/replay/mcap/message_schemas.h"
#include "continua/replay/mcap/ros_message.h"
#include "continua/replay/mcap/scene_messages.h"
#include "continua/replay/scene/run_world.h"

namespace continua {
namespace {

// The whole stack of a machine that counts by it would be written again at every step.
constexpr std::size_t most_symbols = 50;

constexpr int log_info = 2, log_warning = 3;  // of foxglove.Log

std::uint64_t nanoseconds(SimTime t) { return static_cast<std::uint64_t>(t.us) * 1000; }

double number_or(const Json& object, const char* member, double otherwise) {
  const auto& value = member_of(object, member);
  return value.is_number() ? value.get<double>() : otherwise;
}

// "/human/speech" for the tier "human speech".
std::string topic_of_event(const Json& event) {
  auto topic = "/" + tier_of_event(event);
  std::replace(topic.begin(), topic.end(), ' ', '/');
  return topic;
}

class RunChannels {
 public:
  RunChannels(const RunIndex& run, std::vector<NoteOnRun> notes, std::ostream& out, const std::string& program)
      : run_(run), notes_(std::move(notes)), dialogue_(dialogue_of(run)), mcap_(out, "", program) {
    std::stable_sort(notes_.begin(), notes_.end(), [](const auto& a, const auto& b) { return a.n < b.n; });
  }

  Outcome write(const std::string& trace_header) {
    mcap_.metadata(mcap_metadata,
                   {{"trace", trace_header}, {"run", std::filesystem::path(run_.path()).filename().string()}});
    begin_scene();
    std::size_t n = 0;
    if (auto problem = each_record(run_, [&](const Json& record) { add(++n, record); })) return problem;
    if (problem_) return problem_;
    if (auto problem = attach_log()) return problem;
    mcap_.finish();
    return std::nullopt;
  }

 private:
  void put(const char* topic, const char* schema, SimTime t, const Json& message) {
    mcap_.message(mcap_.channel(json_channel(topic, schema)), nanoseconds(t), compact(message));
  }

  void put_ros(const char* topic, const char* type, SimTime t, const Json& message) {
    const auto channel = ros_channel(topic, type);
    const auto definition = read_ros_definition(type, channel.schema.data);
    mcap_.message(mcap_.channel(channel), nanoseconds(t), cdr_of_message(*definition, message));
  }

  // A log without a scene has none to show.
  void begin_scene() {
    const auto scene = run_scene(run_);
    if (!scene) return;
    put("/scene", "foxglove.SceneUpdate", {}, scene_update_of(*scene));
    put_poses({}, (*scene)["bodies"]);
  }

  void put_poses(SimTime t, const Json& numbers) {
    BodyPoses bodies;
    if (numbers.is_object())
      for (const auto& [name, pose] : numbers.items())
        if (const auto read = pose_in(pose)) bodies.emplace(name, *read);
    put("/tf", "foxglove.FrameTransforms", t, frame_transforms_of(t, bodies));
  }

  void add(std::size_t n, const Json& record) {
    const auto& kind = run_.kind(n);
    const auto t = run_.entry(n).t;
    if (log::is_any<log::Input, log::Observed, log::Mark, log::Expect>(kind))
      add_event(t, record);
    else if (log::is<log::Utterance>(kind))
      put_ros("/avatar/say", "std_msgs/msg/String", t, {{"data", text_of(record, "text")}});
    else if (log::is<log::AvatarGesture>(kind))
      put("/avatar/gesture", "continua.Gesture", t, {{"n", n}, {"gesture", text_of(record, "gesture")}});
    else if (log::is<log::Act>(kind))
      add_act(n, t, record);
    else if (log::is<log::Pose>(kind))
      put_poses(t, member_of(record, "bodies"));
    else if (log::is_any<log::Transition, log::Rewrite, log::Correction>(kind))
      add_step(n, t, record);
    for (; next_line_ < dialogue_.size() && dialogue_[next_line_].n <= n; ++next_line_) put_line(dialogue_[next_line_]);
    for (; next_note_ < notes_.size() && notes_[next_note_].n <= n; ++next_note_) put_note(t, notes_[next_note_]);
  }

  void add_event(SimTime t, const Json& record) {
    const auto event = event_of_record(record, t);
    if (event.is_null()) return;
    put(topic_of_event(event).c_str(), mcap_event_schema, t, event);
    if (text_of(event, "kind") != "speech") return;
    const bool final = member_of(event, "final") != false;
    const auto stamp = foxglove_time(t);
    put_ros("/humans/voices/human/speech", "hri_msgs/msg/LiveSpeech", t,
            {{"header", {{"stamp", {{"sec", stamp["sec"]}, {"nanosec", stamp["nsec"]}}}}},
             {final ? "final" : "incremental", label_of_event(event)},
             {"confidence", number_or(event, "confidence", 1.0)}});
  }

  void add_act(std::size_t n, SimTime t, const Json& record) {
    if (record.contains("step")) return;
    put("/avatar/act", "continua.Act", t,
        {{"n", n},
         {"act", member_of(record, "act")},
         {"program", text_of(record, "program")},
         {"status", text_of(record, "status")},
         {"reason", text_of(member_of(record, "result"), "reason")}});
  }

  void add_step(std::size_t n, SimTime t, const Json& record) {
    if (std::exchange(first_, false) && record.contains("from")) put_state(0, {}, text_of(record, "from"), {});
    if (record.contains("to")) put_state(n, t, text_of(record, "to"), record);
    if (record.contains("stack")) put_stack(n, t, record);
  }

  void put_state(std::size_t n, SimTime t, const std::string& state, const Json& record) {
    put("/state", "continua.State", t,
        {{"n", n}, {"state", state}, {"transition", text_of(record, "id")}, {"input", text_of(record, "input")}});
  }

  void put_stack(std::size_t n, SimTime t, const Json& record) {
    const auto& top = member_of(record, "stack");
    auto ids = run_.stack_ids(top.is_number_integer() ? top.get<std::int64_t>() : -1);
    if (ids == stack_) return;
    stack_ = ids;
    ids.resize(std::min(ids.size(), most_symbols));
    Json symbols = Json::array();
    for (const auto id : ids) {
      const auto made = run_.symbol(id)->n;
      const auto symbol = run_.record(made);
      if (!symbol) return problem_ = symbol.error(), void();
      Json slots = Json::array();
      for (const auto& [slot, term] : member_of(*symbol, "slots").items())
        slots.push_back({{"slot", slot}, {"term", term}});
      symbols.push_back({{"id", id}, {"made", made}, {"slots", std::move(slots)}});
    }
    put("/stack", "continua.Stack", t, {{"n", n}, {"depth", stack_.size()}, {"symbols", std::move(symbols)}});
  }

  void put_line(const DialogueLine& line) {
    const bool amiss = line.how.starts_with("did not") || line.who == "expectation";
    put("/dialogue", "foxglove.Log", line.t,
        {{"timestamp", foxglove_time(line.t)},
         {"level", amiss ? log_warning : log_info},
         {"message", line.how + ' ' + line.what},
         {"name", line.who},
         {"file", std::filesystem::path(run_.path()).filename().string()},
         {"line", line.n}});
  }

  void put_note(SimTime t, const NoteOnRun& note) {
    put("/notes", "continua.Note", t,
        {{"n", note.n}, {"to", note.to}, {"until", run_.entry(note.to).t.seconds()}, {"text", note.text}});
  }

  Outcome attach_log() {
    const auto log = source_of_log(run_.path());
    if (!log) return log.error();
    GzipBlocks blocks;
    std::string packed;
    const auto problem = read_pieces(**log, run_.path(), [&](std::string_view piece) { packed += blocks.add(piece); });
    if (problem) return problem;
    packed += blocks.finish();
    auto name = std::filesystem::path(without_gzip_ending(run_.path())).filename().string();
    mcap_.attach(name + std::string(gzip_ending), "application/gzip", packed);
    return std::nullopt;
  }

  const RunIndex& run_;
  std::vector<NoteOnRun> notes_;
  const std::vector<DialogueLine> dialogue_;
  McapWriter mcap_;
  Outcome problem_;
  std::size_t next_line_ = 0, next_note_ = 0;
  std::vector<std::int64_t> stack_;
  bool first_ = true;
};

}  // namespace

Outcome export_mcap(const RunIndex& run, const std::vector<NoteOnRun>& notes, const std::string& trace_header,
                    std::ostream& out) {
  const auto& header = run.header();
  if (!header) return header.error();
  if (auto problem = RunChannels(run, notes, out, "continua " + text_of(*header, "continua")).write(trace_header))
    return problem;
  return out ? Outcome() : Error{run.path(), "the export could not be written"};
}

}  // namespace continua
