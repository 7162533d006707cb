// A small run log for tests of its readers: two states, a stack of two symbols, a question, an act.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "continua/core/located_json.h"
#include "support/catch.h"

namespace continua {

/// Matches a text that contains another, in Catch2 2 and 3.
inline auto Contains(const std::string& part) {
#ifdef CATCH2_3
  return Catch::Matchers::ContainsSubstring(part);
#else
  return Catch::Matchers::Contains(part);
#endif
}

/// A folder that is gone at the end of the test.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "continua-inspector-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() {
    std::error_code problem;
    std::filesystem::remove_all(path_, problem);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path() const { return path_; }

  /// Writes a file below the folder and gives its path.
  std::string write(const std::string& name, const std::string& text) const {
    const auto file = std::filesystem::path(path_) / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file.string();
  }

 private:
  std::string path_;
};

/// Writes records in the log's order of keys, numbered.
class LogBuilder {
 public:
  std::size_t add(const std::string& kind, double t, const Json& fields = Json::object(), int cause = -1) {
    Json record{{"kind", kind}, {"n", next_}, {"t", t}};
    if (cause >= 0) record["cause"] = cause;
    record.update(fields);
    text_ += compact(record) + "\n";
    return next_++;
  }
  void line(const std::string& raw) {
    text_ += raw + "\n";
    ++next_;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t next_ = 0;
};

inline Json transition_fields(const char* id, const char* from, const char* to, int stack, int depth) {
  return {{"id", id},
          {"from", from},
          {"to", to},
          {"input", "n"},
          {"operation", {{"none", nullptr}}},
          {"weight", 1},
          {"probability", 1},
          {"draw", nullptr},
          {"candidates", {{{"id", id}, {"weight", 1}}}},
          {"refused", {{{"id", "other"}, {"reason", "size(options) > 1 is false"}}}},
          {"gates", Json::array()},
          {"stack", stack},
          {"depth", depth},
          {"margin", nullptr}};
}

/// 0 run, 1 symbol 1, 2 speech, 3 application, 4 symbol 2, 5 transition ask, 6 utterance, 7 pointing, 8 transition
/// stay, 9 pose, 10 gesture, 11 application, 12 symbol 3, 13 transition agree, 14 to 16 act, 17 rest, 18 refusal, 19
/// expect, 20 a kind of later versions, 21 end.
inline LogBuilder small_log() {
  LogBuilder log;
  log.add("run", 0,
          {{"version", 1},
           {"continua", "test"},
           {"trace", {{"name", "small"}, {"digest", "00"}}},
           {"seed", 0},
           {"choice", "likeliest"},
           {"machine", {{"name", "two"}, {"document", {{"machine", 1}}}}},
           {"graph",
            {{"states", {{{"id", "Wait"}, {"accepting", true}}, {{"id", "AskWhichBlock"}, {"accepting", false}}}},
             {"start", "Wait"},
             {"edges",
              {{{"id", "ask"},
                {"from", "Wait"},
                {"to", "AskWhichBlock"},
                {"input", "n"},
                {"condition", "size(options) > 1"},
                {"operation", "push"}},
               {{"id", "stay"},
                {"from", "AskWhichBlock"},
                {"to", "AskWhichBlock"},
                {"input", "d"},
                {"condition", nullptr},
                {"operation", "none"}},
               {{"id", "agree"},
                {"from", "AskWhichBlock"},
                {"to", "Wait"},
                {"input", "y"},
                {"condition", nullptr},
                {"operation", "rewrite"}},
               {{"id", "other"},
                {"from", "Wait"},
                {"to", "Wait"},
                {"input", "w"},
                {"condition", nullptr},
                {"operation", "flush"}}}}}},
           {"scene", {{"name", "table"}, {"mjcf", "<mujoco/>"}}}});
  log.add("symbol", 0, {{"id", 1}, {"below", nullptr}, {"slots", Json::object()}}, 0);
  log.add("input", 1.5,
          {{"line", 2}, {"event", {{"kind", "speech"}, {"text", "Put it there."}, {"until", 2.25}}}, {"symbol", "P"}});
  log.add("application", 1.5,
          {{"function", "\\v. \\b. put(b, v)"},
           {"argument", "on(block1)"},
           {"result", "\\b. put(b, on(block1))"},
           {"types", {{"function", "loc -> e -> t"}, {"argument", "loc"}, {"result", "e -> t"}}},
           {"rule", nullptr},
           {"because", {2}}},
          2);
  log.add(
      "symbol", 1.5,
      {{"id", 2}, {"below", 1}, {"slots", {{"action", "\\b. put(b, on(block1))"}, {"options", "[block2, block3]"}}}},
      5);
  log.add("transition", 1.5, transition_fields("ask", "Wait", "AskWhichBlock", 2, 2), 2);
  log.add("utterance", 1.5, {{"text", "Which block?"}}, 5);
  log.add("input", 2.0,
          {{"line", 3}, {"event", {{"kind", "pointing"}, {"hand", "right"}, {"target", {0.1, 0.2}}}}, {"symbol", "d"}});
  log.add("transition", 2.0, transition_fields("stay", "AskWhichBlock", "AskWhichBlock", 2, 2), 7);
  log.add("pose", 2.1, {{"bodies", {{"hand", {0, 0, 0, 1, 0, 0, 0}}}}});
  log.add("input", 3.0,
          {{"line", 4},
           {"event", {{"kind", "gesture"}, {"name", "point"}, {"hand", "right"}, {"phase", "start"}}},
           {"symbol", "y"}});
  log.add("application", 3.0,
          {{"function", "\\b. put(b, on(block1))"},
           {"argument", "block2"},
           {"result", "put(block2, on(block1))"},
           {"types", {{"function", "e -> t"}, {"argument", "e"}, {"result", "t"}}},
           {"rule", nullptr},
           {"because", {2, 10}}},
          10);
  log.add("symbol", 3.0, {{"id", 3}, {"below", 1}, {"slots", {{"action", "put(block2, on(block1))"}}}}, 13);
  log.add("transition", 3.0, transition_fields("agree", "AskWhichBlock", "Wait", 3, 2), 10);
  log.add("act", 3.0, {{"act", 1}, {"program", "put(block2, on(block1))"}, {"status", "asked"}}, 13);
  log.add("act", 3.1, {{"act", 1}, {"program", "put(block2, on(block1))"}, {"status", "started"}}, 14);
  log.add("act", 5.0,
          {{"act", 1},
           {"program", "put(block2, on(block1))"},
           {"status", "done"},
           {"result", {{"position_error_m", 0.001}}}},
          15);
  log.add("rest", 8, {{"from", 5.5}, {"to", 8}});
  log.add("refusal", 8,
          {{"state", "Wait"}, {"input", "x"}, {"reason", "no transition takes x"}, {"refused", Json::array()}});
  log.add("expect", 8.5,
          {{"line", 5}, {"met", true}, {"expected", {{"state", "Wait"}}}, {"found", {{"state", "Wait"}}}});
  log.add("novelty", 9, {{"what", "a kind of a later version"}});
  log.add("end", 10, {{"counts", Json::object()}, {"decisions", "d"}, {"physics", "p"}, {"digest", "x"}});
  return log;
}

}  // namespace continua
