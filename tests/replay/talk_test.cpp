// Speech in replays: its records in the run log.
#include <algorithm>
#include <fstream>

#include "continua/knowledge_files/named_machine.h"
#include "continua/replay/commands/accept.h"
#include "replay/played.h"
#include "support/folders.h"
#include "support/sources.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const auto traces = fs::path(source_dir()) / "traces";

// The human says one thing after the other over a scene.
Played talk(const std::vector<std::string>& says, const std::string& scene = "place_setting",
            const std::string& machine = "interaction") {
  const TemporaryFolder folder;
  std::string text = R"({"kind":"trace","version":1,"scene":")" + scene + R"(","machine":")" + machine + "\"}\n";
  for (std::size_t i = 0; i < says.size(); ++i)
    text += compact(Json{{"t", i + 1}, {"kind", "speech"}, {"text", says[i]}}) + "\n";
  return play(folder.file("talk.trace.jsonl", text));
}

// "V put(knife, in(cup_blue)) : t" of each reading.
std::vector<std::string> meanings(const Played& played) {
  std::vector<std::string> all;
  for (const auto& reading : played.all("reading"))
    all.push_back(reading["move"].is_null() ? "not understood"
                                            : reading["move"].get<std::string>() + " " + reading.value("meaning", "") +
                                                  " : " + reading.value("type", ""));
  return all;
}

std::vector<std::string> said(const Played& played) {
  std::vector<std::string> all;
  for (const auto& utterance : played.all("utterance")) all.push_back(utterance["text"]);
  return all;
}

std::vector<std::string> programs(const Played& played) {
  std::vector<std::string> all;
  for (const auto& act : played.all("act"))
    if (act["status"] == "asked") all.push_back(act["program"]);
  return all;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("what is said is told as what it means here and now, with the type of what is missing") {
  CHECK(meanings(talk({"Put the knife in the blue cup."})) == Texts{"V put(knife, in(cup_blue)) : t"});
  CHECK(meanings(talk({"Put it there."})) == Texts{"V \\x v. put(x, v) : e -> loc -> t"});
  CHECK(meanings(talk({"Put the knife in the cup."})) == Texts{"V \\x. put(knife, in(x)) : e -> t"});
  CHECK(meanings(talk({"The plate.", "Put it in front of you."})) ==
        Texts{"N plate : e", "V put(plate, in_front(avatar)) : t"});
  CHECK(meanings(talk({"no, the blue one"})) == Texts{"n no : t", "N cup_blue : e"});
  CHECK(meanings(talk({"glorp"})) == Texts{"not understood"});
}

TEST_CASE("applications name the inputs that each part came from") {
  const auto played = play(traces / "paper/dialogue_language.trace.jsonl");
  const auto inputs = played.all("input"), applications = played.all("application");
  REQUIRE(inputs.size() == 4);  // with the beginning and the end of the act
  const std::size_t plate = inputs[0]["n"], put = inputs[1]["n"];
  Texts told;
  for (const auto& each : applications) {
    const auto behind = inputs_behind(played.records, each);
    told.push_back(each["function"].get<std::string>() + " @ " + each["argument"].get<std::string>() +
                   (behind == std::set{plate, put} ? ", both"
                    : behind == std::set{put}      ? ", the second"
                                                   : ""));
  }
  CHECK(told == Texts{"in_front @ avatar, the second", "put @ plate, both", "put(plate) @ in_front(avatar), both"});
}

TEST_CASE("an object that is told where a place is asked for is raised, by a rule that the log names") {
  const auto played = talk({"put the knife", "the blue cup"});
  CHECK(said(played) == Texts{"Where should I put it?", "Okay, the knife in the blue cup."});
  CHECK(programs(played) == Texts{"put(knife, in(cup_blue))"});
  Texts rules;
  for (const auto& each : played.all("application"))
    if (!each["rule"].is_null()) rules.push_back(each["rule"]);
  CHECK(rules == Texts{"object_to_place_in"});
}

TEST_CASE("a noun phrase without one object becomes a question or is told") {
  CHECK(said(talk({"the cup", "no", "yes"})) ==
        Texts{"Which cup do you mean? The white cup?", "The blue cup?", "Okay, go on."});
  CHECK(said(talk({"the blue plate"})) == Texts{"I see no blue plate."});
  CHECK(said(talk({"grasp the cup", "the blue one"})) ==
        Texts{"Which cup do you mean? Should I take the white cup?", "Okay, the blue cup."});
  const auto readings = talk({"the cup"}).all("reading");
  CHECK(readings[0]["referents"] == Json{"cup", "cup_blue"});
  CHECK(readings[0]["resolved"][0]["ruled_out"] == Json::parse(R"json([{"object":"plate","reason":"not cup(plate)"
},
                                                                    {"object":"knife","reason":"not cup(knife)"}])json"));
}

TEST_CASE("commands for several objects are carried out one by one") {
  CHECK(programs(talk({"put the knife and the plate in front of me"})) ==
        Texts{"put(knife, in_front(human))", "put(plate, in_front(human))"});
}

TEST_CASE("words go with what was pointed at in the two seconds before them") {
  const auto after = [](double seconds) {
    const TemporaryFolder folder;
    const auto event = compact(Json{{"t", 1 + seconds}, {"kind", "speech"}, {"text", "put the plate there"}});
    return meanings(play(folder.file("t.trace.jsonl",
                                     R"({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"}
{"t":1,"kind":"pointing","target":[0.1,-0.2]}
)" + event + "\n")));
  };
  CHECK(after(0.5).back() == "V put(plate, <0.1, -0.2, 0>) : t");
  // "there" is said about a second after the first word, but it is one utterance.
  CHECK(after(1.9).back() == "V put(plate, <0.1, -0.2, 0>) : t");
  CHECK(after(2.1).back() == "V \\v. put(plate, v) : loc -> t");
}

TEST_CASE(
    "pointing is a move when it begins, and when it comes to mean something else, and what is ignored is not refused") {
  const TemporaryFolder folder;
  std::string trace = R"({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"})"
                      "\n";
  const auto sample = [&](double t, double x, double y) {
    trace += compact(Json{{"t", t}, {"kind", "pointing"}, {"hand", "right"}, {"target", {x, y}}}) + "\n";
  };
  for (int i = 0; i < 10; ++i) sample(1 + i / 30.0, 0.12, 0.03);
  for (int i = 0; i < 10; ++i) sample(2 + i / 30.0, -0.2, 0.01);
  sample(9, -0.2, 0.01);
  const auto played = play(folder.file("t.trace.jsonl", trace));
  Texts moves;
  for (const auto& reading : played.all("reading"))
    moves.push_back(reading["move"].get<std::string>() + " " + reading["referents"][0].get<std::string>());
  CHECK(moves == Texts{"δ cup", "δ plate", "δ plate"});
  CHECK(played.summary.refusals == 0);
}

TEST_CASE("a machine without a lexicon tells moves by its inputs") {
  Texts moves;
  for (const auto& reading : play(traces / "building_blocks.trace.jsonl").all("reading"))
    moves.push_back(reading["move"]);
  for (const char* move : {"δ", "α", "y", "n", "N"}) CHECK(std::count(moves.begin(), moves.end(), move) > 0);
}

TEST_CASE("one, it and them mean what was said nearest by") {
  CHECK(meanings(talk({"the plate", "put the white cup beside the blue one"})).back() ==
        "V put(cup, beside(cup_blue)) : t");
  CHECK(meanings(talk({"a cup", "the one behind the knife", "the white one"})).back() == "N cup : e");
  CHECK(meanings(talk({"grasp the knife", "the plate", "put it on the plate"})).back() ==
        "V put(knife, on(plate)) : t");
  CHECK(meanings(talk({"put the knife left of the blue cup", "the other cup"})).back() == "N cup : e");
  CHECK(meanings(talk({"put both cups in front of you", "put them on the plate"})).back() ==
        "V [put(cup, on(plate)), put(cup_blue, on(plate))] : t*");
}

TEST_CASE("a run's moves are held against the grammar of Table 1") {
  const TemporaryFolder folder;
  const auto machine = load_named_machine("table_1");
  REQUIRE(machine.ok());
  ReplayOptions options;
  options.physics = false;
  const auto moves = [&](const std::string& trace) {
    auto session = Session::load((traces / (trace + ".trace.jsonl")).string(), options);
    if (!session) FAIL(session.error().text());
    std::ofstream file(folder.at("run.jsonl"));
    session->run(file);
    file.close();
    return moves_of_run(folder.at("run.jsonl"), **machine).value();
  };
  CHECK(moves("paper/dialogue_language") == "N V");
  CHECK(moves("paper/predicate_first") == "δ V N");
  CHECK(moves("talk/speech_only") == "V n y V V N P");
  CHECK(run_accept({"table_1", {"N V"}, "", false, {folder.at("run.jsonl")}}) == exit_no);
}
