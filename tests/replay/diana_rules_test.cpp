// The rules of the recorded system that changed during the study: the effect of each parameter of its machine.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/session/session.h"
#include "support/catch.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

std::string speech(const std::string& word) { return fmt::format(R"("kind":"speech","text":"{}")", word); }
std::string gesture(const std::string& name, const std::string& phase) {
  return fmt::format(R"("kind":"gesture","name":"{}","phase":"{}")", name, phase);
}
std::string point(double x, double y) {
  return fmt::format(R"("kind":"gesture","name":"point","hand":"right","phase":"start","target":[{},{}])", x, y);
}

// The avatar's utterances and acts after the inputs, a second apart; gestures are left out.
std::string answers(const std::string& parameters, const std::vector<std::string>& inputs,
                    const std::string& objects = "{}") {
  const auto path = fs::temp_directory_path() / fmt::format("continua_rules_{}.jsonl", ::getpid());
  std::ofstream file(path);
  file << R"({"kind":"trace","version":1,"scene":"staircase","machine":"diana2018","parameters":)" << parameters
       << R"(,"objects":)" << objects << "}\n"
       << R"({"t":0,"kind":"gesture","name":"engage","phase":"start"})" << '\n';
  for (std::size_t i = 0; i < inputs.size(); ++i) file << fmt::format("{{\"t\":{},{}}}\n", i + 1, inputs[i]);
  file.close();
  ReplayOptions options;
  options.physics = false;
  options.episodes = true;
  auto session = Session::load(path.string(), options);
  if (!session) FAIL(session.error().text());
  std::ostringstream log;
  const auto summary = session->run(log);
  fs::remove(path);
  std::string all;
  for (const auto& episode : summary.episodes)
    for (const auto& move : episode.produced)
      if (move.channel != "gesture" && episode.t > SimTime{}) all += move.content + "|";
  return all;
}

const std::string covered =
    R"({"block6":{"position":[0.1,0,0.03]},"block4":{"position":[0.148,0,0.09]}})";  // by a fifth of its width

}  // namespace

TEST_CASE("a rule that changed makes the difference that the study shows") {
  struct Row {
    std::string parameter, earlier;
    std::vector<std::string> inputs;
    std::string now, then, objects = "{}";
  };
  const std::vector<Row> rows = {
      {"colors_leave_out_focus", "false", {speech("RED"), speech("RED")}, "OK, go on.|", "OK, go on.|The red block?|"},
      {"colors_name_landmarks",
       "false",
       {speech("RED"), speech("GREEN"), speech("YES")},
       "OK, go on.|Should I put the red block on the green block?|OK.|put(block6, on(block4))|",
       "OK, go on.|Should I put the red block on the green block?|OK, go on.|"},
      {"suggests_object", "false", {point(-0.2, 0.04)}, "Are you pointing at this?|", "Are you pointing here?|"},
      {"colors_may_be_missing",
       "false",
       {speech("RED"), speech("PINK")},
       "OK, go on.|",
       "OK, go on.|Sorry, I don't know what you mean.|"},
      {"pointing_ends_at_table",
       "false",
       {point(0.1, 0), speech("YES"), speech("NEVERMIND"), point(0.1, 0.15)},
       "Are you pointing here?|Should I place something here?|OK, never mind.|Which object do you want?|",
       "Are you pointing here?|Should I place something here?|OK, never mind.|Should I place something here?|"},
      {"covered_from", "0", {speech("RED")}, "OK, go on.|", "Sorry, I don't know what you mean.|", covered},
      {"grab_stop_releases",
       "true",
       {speech("RED"), speech("GRAB"), gesture("grab", "stop")},
       "OK, go on.|OK.|grasp(block6)|",
       "OK, go on.|OK.|grasp(block6)|ungrasp(block6)|"},
  };
  for (const auto& row : rows) {
    INFO(row.parameter);
    CHECK(answers("{}", row.inputs, row.objects) == row.now);
    CHECK(answers(fmt::format("{{\"{}\":{}}}", row.parameter, row.earlier), row.inputs, row.objects) == row.then);
  }
}
