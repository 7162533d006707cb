// One thing is edited in a worked example: its run parts from the original's at the edit, and diff names it.
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/log/time_text.h"
#include "replay/diff/edited_example.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

// The answer that diff must give for an edit.
struct Named {
  std::string kind;         ///< of the cause
  std::string what;         ///< part of the subject of the cause, or of its sentence
  std::string change = {};  ///< of an input
  bool may_be_without_effect = false;
};

using Edit = std::function<std::optional<Named>(EditedExample&, const RunIndex& original, std::size_t which)>;

std::optional<std::size_t> nth(const std::vector<std::size_t>& places, std::size_t which) {
  return which < places.size() ? std::optional(places[which]) : std::nullopt;
}

std::vector<std::size_t> speech_of(const EditedExample& example) {
  auto places = example.inputs();
  std::erase_if(places, [&](std::size_t i) { return example.lines[i]["kind"] != "speech"; });
  return places;
}

std::optional<Named> drop(EditedExample& example, const RunIndex&, std::size_t which) {
  const auto place = nth(example.inputs(), which);
  if (!place) return std::nullopt;
  example.lines.erase(example.lines.begin() + static_cast<std::ptrdiff_t>(*place));
  return Named{"input", "left out in B", "dropped"};
}

std::optional<Named> move(EditedExample& example, const RunIndex&, std::size_t which) {
  const auto place = nth(example.inputs(), which);
  if (!place) return std::nullopt;
  auto& event = example.lines[*place];
  const double t = event["t"].get<double>();
  event["t"] = t + 0.2;
  if (event.contains("until")) event["until"] = std::max(event["until"].get<double>(), t + 0.2);
  return Named{"input", fmt::format("comes at {} in A, at {} in B", time_text(t), time_text(t + 0.2)), "moved"};
}

// Two events change their contents; their times stay.
std::optional<Named> swap(EditedExample& example, const RunIndex&, std::size_t which) {
  const auto places = example.inputs();
  if (which + 1 >= places.size()) return std::nullopt;
  auto &one = example.lines[places[which]], &other = example.lines[places[which + 1]];
  if (one.contains("until") || other.contains("until") || one["t"] == other["t"]) return std::nullopt;
  const auto t = one["t"], t_other = other["t"];
  std::swap(one, other);
  one["t"] = t;
  other["t"] = t_other;
  auto content = one, content_other = other;
  content.erase("t");
  content_other.erase("t");
  if (content == content_other) return std::nullopt;
  return Named{"input", "change places", "swapped"};
}

std::optional<Named> change_word(EditedExample& example, const RunIndex&, std::size_t which) {
  const auto place = nth(speech_of(example), which);
  if (!place) return std::nullopt;
  auto& text = example.lines[*place]["text"];
  const auto was = text.get<std::string>();
  const auto last = was.rfind(' ') == std::string::npos ? 0 : was.rfind(' ') + 1;
  const auto is = was.substr(0, last) + "spoon.";
  text = is;
  example.lines[*place].erase("words");
  return Named{"input", fmt::format("A has “{}”, B “{}”", was, is), "changed"};
}

std::optional<Named> change_confidence(EditedExample& example, const RunIndex&, std::size_t which) {
  const auto place = nth(example.inputs(), which);
  if (!place || example.lines[*place]["kind"] == "pointing" || example.lines[*place].contains("alternatives"))
    return std::nullopt;
  example.lines[*place]["confidence"] = 0.35;
  return Named{"input", "confidence", "changed"};
}

// Transitions that fired, by their ids, each once.
std::vector<std::string> fired(const RunIndex& run) {
  std::vector<std::string> ids;
  for (const auto n : run.of_kind("transition")) {
    const auto id = run.record(n)->at("id").get<std::string>();
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  return ids;
}

Json* transition_of(EditedExample& example, const std::string& id) {
  for (auto& transition : example.machine["transitions"])
    if (transition.value("id", "") == id) return &transition;
  return nullptr;
}

std::optional<Named> change_transition(EditedExample& example, const RunIndex& original, std::size_t which,
                                       const std::string& field, const std::function<bool(Json&)>& edit) {
  const auto ids = fired(original);
  if (which >= ids.size()) return std::nullopt;
  auto* transition = transition_of(example, ids[which]);
  if (!transition || !edit(*transition)) return std::nullopt;
  return Named{"machine", fmt::format("transition '{}': {}", ids[which], field)};
}

std::optional<Named> change_weight(EditedExample& example, const RunIndex& original, std::size_t which) {
  return change_transition(example, original, which, "weight", [](Json& transition) {
    transition["weight"] = transition.value("weight", 1.0) / 2;
    return true;
  });
}

std::optional<Named> change_condition(EditedExample& example, const RunIndex& original, std::size_t which) {
  return change_transition(example, original, which, "when", [](Json& transition) {
    if (!transition.contains("when")) return false;
    transition["when"] = "not (" + transition["when"].get<std::string>() + ")";
    return true;
  });
}

std::optional<Named> change_target(EditedExample& example, const RunIndex& original, std::size_t which) {
  return change_transition(example, original, which, "to", [&](Json& transition) {
    for (const auto& [name, state] : example.machine["states"].items())
      if (!state.contains("gate") && name != transition["to"].get<std::string>()) {
        transition["to"] = name;
        return true;
      }
    return false;
  });
}

// Takes a word of the run out of the lexicon's file that has it in the sense in which it is used.
std::optional<Named> drop_entry(EditedExample& example, const RunIndex& original, std::size_t which) {
  std::vector<std::pair<std::string, Json>> words;  // with their categories
  for (const auto n : original.of_kind("reading")) {
    const auto record = *original.record(n);
    if (!record.contains("entries")) continue;
    for (const auto& entry : record["entries"]) words.emplace_back(entry["words"], entry["category"]);
  }
  if (which >= words.size()) return std::nullopt;
  const auto has_category = [](const Json& senses, const Json& category) {
    return std::any_of(senses.begin(), senses.end(), [&](const Json& sense) { return sense[0] == category; });
  };
  const auto folder = fs::path(source_dir()) / "engine/knowledge/lexicon/english";
  for (const auto& file : fs::directory_iterator(folder)) {
    auto content = Json::parse(*read_file(file.path().string()));
    if (!content.contains("words")) continue;
    Json without = Json::object();
    bool found = false;
    for (const auto& [key, senses] : content["words"].items()) {
      std::string kept;
      for (std::size_t at = 0; at < key.size();) {
        const auto end = std::min(key.find(" | ", at), key.size());
        const auto one = key.substr(at, end - at);
        if (one == words[which].first && has_category(senses, words[which].second))
          found = true;
        else
          kept += (kept.empty() ? "" : " | ") + one;
        at = end + 3;
      }
      if (!kept.empty()) without[kept] = senses;
    }
    if (!found) continue;
    content["words"] = without;
    example.lexicon = {file.path().filename().string(), content};
    return Named{"lexicon", words[which].first};
  }
  return std::nullopt;
}

std::optional<Named> move_object(EditedExample& example, const RunIndex& original, std::size_t which) {
  const auto scene = original.record(0)->at("scene");
  std::vector<std::string> objects;
  for (const auto n : original.of_kind("reading")) {
    const auto record = *original.record(n);
    for (const auto& name : record.value("referents", Json::array()))
      if (scene["bodies"].contains(name.get<std::string>())) objects.push_back(name.get<std::string>());
  }
  if (which >= objects.size()) return std::nullopt;
  const auto pose = scene["bodies"][objects[which]];
  auto& start = example.header()["objects"];
  if (!start.is_object()) start = Json::object();
  start[objects[which]]["position"] = {pose[0].get<double>() + 0.04, pose[1], pose[2]};
  return Named{"scene", objects[which] + " starts at"};
}

const std::vector<std::pair<std::string, Edit>> edits{
    {"drop an input", drop},
    {"move it by 0.2 s", move},
    {"swap two", swap},
    {"change a word", change_word},
    {"change a confidence", change_confidence},
    {"change a weight", change_weight},
    {"change a condition", change_condition},
    {"change a transition's target", change_target},
    {"drop an entry of the lexicon", drop_entry},
    {"move an object", move_object},
};

// The fault of diff's answer; empty if it has none.
std::string wrong(const RunDiff& diff, const Named& named) {
  if (is_same(diff)) return "called the same";
  if (diff.cause.kind != named.kind) return "cause is " + diff.cause.kind;
  if ((diff.cause.what + "\n" + diff.cause.sentence).find(named.what) == std::string::npos)
    return "cause does not name " + named.what;
  if (diff.sentence.find(diff.cause.sentence) == std::string::npos) return "the sentence does not tell the cause";
  const auto& first = diff.differences.at(diff.first);
  if (!named.change.empty() && (!first.input || name_of(first.input->kind) != named.change))
    return "first difference is " + std::string(first.input ? name_of(first.input->kind) : name_of(first.kind));
  return "";
}

}  // namespace

TEST_CASE("diff names the edit as the first divergence and its cause") {
  std::vector<fs::path> traces;
  for (const auto& file : fs::directory_iterator(fs::path(source_dir()) / "traces/paper"))
    if (file.path().string().ends_with(".trace.jsonl")) traces.push_back(file.path());
  std::sort(traces.begin(), traces.end());
  REQUIRE(traces.size() >= 12);

  constexpr std::size_t most = 1;  // of a kind in a trace
  std::map<std::string, int> tried;
  for (const auto& trace : traces) {
    const auto original = EditedExample(trace).run();
    for (const auto& [name, edit] : edits)
      for (std::size_t which = 0, done = 0; which < 12 && done < most; ++which) {
        EditedExample edited(trace);
        const auto named = edit(edited, original, which);
        if (!named) continue;
        ++done;
        ++tried[name];
        const auto run = edited.run();
        const auto diff = diff_runs(original, run);
        REQUIRE(diff.ok());
        INFO(trace.filename() << ", " << name << " no. " << which);
        INFO(diff_text(original, run, *diff));
        CHECK(wrong(*diff, *named) == "");
      }
  }
  for (const auto& [name, edit] : edits) {
    INFO(name);
    CHECK(tried[name] >= 10);
  }
}
