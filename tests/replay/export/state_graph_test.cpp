#include "continua/replay/export/state_graph.h"

#include <map>
#include <pugixml.hpp>
#include <set>

#include "continua/machine_file/machine_loader.h"
#include "continua/replay/export/graph_dot.h"
#include "continua/replay/export/graph_svg.h"
#include "continua/replay/log/record_json.h"
#include "continua/replay/recorder/machine_graph.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

StateGraph graph_of_text(const std::string& text) {
  const auto machine = parse_machine(text, "m.json", {});
  if (!machine) FAIL(machine.error().text());
  auto graph = state_graph_of(log::to_json(graph_of(*machine)), machine->name);
  if (!graph) FAIL(graph.error().text());
  return *std::move(graph);
}

std::string machine_with(const std::string& transitions, const std::string& more = "") {
  return R"({"machine":1,"name":"m","start":"A","slots":{"options":"e*","region":"loc"},)" + more +
         R"("transitions":[)" + transitions + "]}";
}

// "A->B: label | label", one arrow a line; "!" before those of gates, "e" before ε-loops.
std::string arrows_text(const StateGraph& graph) {
  std::string text;
  for (const auto& arrow : arrows_of(graph)) {
    text += (arrow.rejected  ? "! "
             : arrow.epsilon ? "e "
                             : "") +
            (arrow.from ? graph.states[*arrow.from].name : "*") + "->" + graph.states[arrow.to].name + ":";
    for (std::size_t i = 0; i < arrow.lines.size(); ++i) text += (i ? " | " : " ") + arrow.lines[i];
    text += "\n";
  }
  return text;
}

// An SVG picture as its states and arrows: class → titles.
std::multimap<std::string, std::string> titles_of(const std::string& svg) {
  pugi::xml_document document;
  const auto parsed = document.load_string(svg.c_str());
  if (!parsed) FAIL(parsed.description());
  std::multimap<std::string, std::string> titles;
  for (const auto& group : document.select_nodes("//g[@class]"))
    titles.emplace(group.node().attribute("class").value(), group.node().child("title").text().get());
  return titles;
}

const char* const hostile_names[] = {
    "plain",     "\"quoted\"", "back\\slash\\", "new\nline\ttab", "λ ε 積木 🤖", "<b>&amp;</b>", "]]> --> <!--",
    "\\N\\G\\l", "",           "\xEF\xBF\xBF",  "a|{b}",          "everywhere",        "s0",           "node"};

// One state of each hostile name, each with an arrow to the next, a loop, and the name as its input.
Json hostile_graph() {
  Json states = Json::array(), edges = Json::array();
  const auto count = std::size(hostile_names);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = hostile_names[i];
    states.push_back({{"id", name}, {"accepting", i % 2 == 0}});
    for (const auto to : {i, (i + 1) % count})
      edges.push_back({{"id", name + std::to_string(to)},
                       {"from", name},
                       {"to", hostile_names[to]},
                       {"input", name},
                       {"condition", name},
                       {"operation", "push"},
                       {"content", {{name, name}}}});
  }
  return {{"states", states}, {"start", hostile_names[0]}, {"edges", edges}};
}

// U+FFFF may not stand in XML.
std::string in_xml(std::string text) {
  for (auto at = text.find("\xEF\xBF\xBF"); at != text.npos; at = text.find("\xEF\xBF\xBF"))
    text.replace(at, 3, "\xEF\xBF\xBD");
  return text;
}

}  // namespace

TEST_CASE("a label has input, condition, weight and operation, as far as there are any") {
  const std::vector<std::pair<const char*, const char*>> labels = {
      {R"("on":"n","to":"B")", "n"},
      {R"("on":"n","to":"B","pop":1)", "n / pop"},
      {R"("on":"n","to":"B","pop":2)", "n / pop 2"},
      {R"("on":null,"to":"B","when":"size(options) > 0","push":{"region":null})",
       "ε [size(options) > 0] / push region: null"},
      {R"("on":null,"to":"B","weight":0.25)", "ε weight 0.25"},
      {R"("on":["y","n"],"to":"B","flush":{})", "y, n / flush"},
      {R"("on":"n","to":"B","pop_until":"A")", "n / pop_until A"},
      {R"("on":"n","to":"B","rewrite":null)", "n / rewrite"},
  };
  for (const auto& [transition, label] : labels)
    CHECK(arrows_text(graph_of_text(machine_with(R"({"id":"a","from":"A",)" + std::string(transition) + "}"))) ==
          "A->B: " + std::string(label) + "\n");
}

TEST_CASE("long parts of a label are cut between characters, and stand in full beside") {
  std::string word;
  for (int i = 0; i < 40; ++i) word += "λ";
  const auto graph = graph_of_text(machine_with(R"({"id":"a","from":"A","on":")" + word + R"(","to":"B"})"));
  const auto arrow = arrows_of(graph).at(0);
  CHECK(columns(arrow.lines.at(0)) == 18);
  CHECK(arrow.lines[0].ends_with("λ…"));
  CHECK(arrow.full.at(0) == "a: " + word);
}

TEST_CASE("parallel transitions are one arrow, but loops with and without input, and rejections, are apart") {
  const auto graph =
      graph_of_text(machine_with(R"({"id":"1","from":"A","on":"x","to":"B"},
      {"id":"2","from":"A","on":"y","to":"A"}, {"id":"3","from":"A","on":null,"to":"B","pop":1},
      {"id":"4","from":"A","on":null,"when":"region = null","to":"A"}, {"id":"5","from":"A","on":"z","to":"A","pop":1},
      {"id":"6","from":"B","on":"x","to":"A"})",
                                 R"("states":{"A":{},"B":{"gate":{"when":"size(options) > 1","else":"A","pop":1}}},)"));
  CHECK(arrows_text(graph) ==
        "! B->A: [not (size(options) > 1)] / pop\nA->B: x | ε / pop\nA->A: y | z / pop\ne A->A: ε [region = "
        "null]\nB->A: x\n");
}

TEST_CASE("what leads from all of many states is one arrow") {
  const auto loops = [](int states) {
    std::string transitions = R"({"id":"stop","from":"*","on":"x","to":"S0"})";
    for (int i = 0; i < states; ++i) {
      const auto number = std::to_string(i);
      transitions += R"(,{"id":"t)" + number + R"(","from":"S)" + number + R"(","on":"y","to":"S)" + number + "\"}";
    }
    return graph_of_text(R"({"machine":1,"name":"m","start":"S0","transitions":[)" + transitions + "]}");
  };
  CHECK(loops(4).edges.size() == 8);
  const auto graph = loops(5);
  CHECK(graph.edges.size() == 6);
  CHECK(arrows_text(graph).starts_with("*->S0: x\n"));
  CHECK(titles_of(*svg_of(graph)).count("state everywhere") == 1);
  CHECK(titles_of(*svg_of(loops(4))).count("state everywhere") == 0);
}

TEST_CASE("a run's graph counts what was visited") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("small.run.jsonl", small_log().text()));
  const auto graph = state_graph_of(*run);
  REQUIRE(graph.ok());
  CHECK(graph->name == "two");
  CHECK(arrows_text(*graph) ==
        "Wait->AskWhichBlock: 1× n [size(options) > 1] / push\nAskWhichBlock->AskWhichBlock: 1× d\n"
        "AskWhichBlock->Wait: 1× y / rewrite\nWait->Wait: w / flush\n");
  CHECK(description(graph->states[1]) == "AskWhichBlock, entered 2 times");
  const auto titles = titles_of(*svg_of(*graph));
  CHECK(titles.count("arrow taken") == 3);
  CHECK(titles.count("arrow never") == 1);
  CHECK(titles.count("state taken") == 2);
  CHECK_THAT(dot_of(*graph), Contains(R"(s1 -> s1 [label="1× d")"));
}

TEST_CASE("what a gate rejected was taken up to the gate, and from there") {
  const auto machine =
      parse_machine(machine_with(R"({"id":"in","from":"A","on":"x","to":"B"})",
                                 R"("states":{"A":{},"B":{"gate":{"when":"region = null","else":"C"}},"C":{}},)"),
                    "m.json", {});
  const ScratchFolder folder;
  for (const bool gate_known : {true, false}) {
    auto header = log::to_json(graph_of(*machine));
    if (!gate_known)
      for (auto& state : header["states"]) state.erase("gate");
    LogBuilder log;
    log.add("run", 0, {{"version", 1}, {"graph", header}});
    log.add("transition", 1, transition_fields("in", "A", "B", 1, 1));
    log.add("transition", 2, transition_fields("in", "A", "C", 1, 1));
    const auto run = RunIndex::open(folder.write("gate.run.jsonl", log.text()));
    const auto graph = state_graph_of(*run);
    REQUIRE(graph.ok());
    auto text = arrows_text(*graph);
    CHECK_THAT(text, Contains("A->B: 2× x\n"));
    CHECK_THAT(text, Contains(gate_known ? "! B->C: 1× [not (region = null)]\n" : "! B->C: 1× gate\n"));
    CHECK(titles_of(*svg_of(*graph)).count("arrow taken rejected") == 1);
  }
}

TEST_CASE("what several gates rejected passed all of them") {
  const auto machine = parse_machine(machine_with(R"({"id":"in","from":"A","on":"x","to":"B"})",
                                                  R"("states":{"A":{},"B":{"gate":{"when":"region = null","else":"C"}},
                                "C":{"gate":{"when":"region = null","else":"D"}},"D":{}},)"),
                                     "m.json", {});
  const ScratchFolder folder;
  LogBuilder log;
  log.add("run", 0, {{"version", 1}, {"graph", log::to_json(graph_of(*machine))}});
  log.add("transition", 1, transition_fields("in", "A", "D", 1, 1));
  const auto graph = state_graph_of(*RunIndex::open(folder.write("gates.run.jsonl", log.text())));
  CHECK(arrows_text(*graph) == "! B->C: 1× [not (region = null)]\n! C->D: 1× [not (region = null)]\nA->B: 1× x\n");
}

TEST_CASE("a header without a graph cannot be drawn") {
  for (const char* graph : {"null", "[]", "{}", R"({"states":3,"edges":"x","start":null})"})
    CHECK_FALSE(state_graph_of(Json::parse(graph), "m").ok());
}

TEST_CASE("edges may name states that the header forgot") {
  const auto graph = state_graph_of(Json::parse(R"({"edges":[{"id":"a","from":"A","to":"B","input":"x"},5]})"), "m");
  REQUIRE(graph.ok());
  CHECK(arrows_text(*graph) == "A->B: x\n");
}

TEST_CASE("the picture has each state and each arrow, whatever they are called") {
  const auto graph = state_graph_of(hostile_graph(), "m \"<&>\" \n");
  REQUIRE(graph.ok());
  const auto svg = svg_of(*graph);
  REQUIRE(svg.ok());
  const auto titles = titles_of(*svg);
  std::multiset<std::string> found, expected;
  for (const auto& [kind, title] : titles) found.insert(kind.substr(0, kind.find(' ')) + " " + title);
  for (const auto& state : graph->states) expected.insert("state " + in_xml(state.name));
  for (const auto& arrow : arrows_of(*graph))
    for (const std::string part : {"arrow ", "label "})
      expected.insert(in_xml(part + graph->states[*arrow.from].name + " → " + graph->states[arrow.to].name + "\n" +
                             arrow.full.at(0)));
  expected.insert("arrow start");
  CHECK(found == expected);
}

TEST_CASE("dot text quotes what is special in it") {
  const auto dot = dot_of(*state_graph_of(hostile_graph(), "m \"x\" \\"));
  for (const char* part : {R"(digraph "m \"x\" \\" {)", R"( [label="\"quoted\"" )", R"( [label="back\\slash\\" )",
                           R"( [label="new␊line␉tab" )", R"( [label="λ ε 積木 🤖" )",
                           R"( [label="<b>&amp;amp;</b>" )", R"( [label="\\N\\G\\l" )", R"(s12 [label="s0" )"})
    CHECK_THAT(dot, Contains(part));
}

TEST_CASE("loops that consume an input leave their state above, ε-loops below") {
  const auto graph = graph_of_text(
      machine_with(R"({"id":"1","from":"A","on":"x","to":"A"}, {"id":"2","from":"A","on":null,"to":"A"})"));
  pugi::xml_document document;
  REQUIRE(document.load_string(svg_of(graph)->c_str()));
  const auto y = [&](const char* path) { return document.select_node(path).node().attribute("y").as_double(); };
  const double box = y("//g[@class='state']/rect");
  CHECK(y("//g[@class='label'][contains(title, '1:')]//tspan") < box);
  CHECK(y("//g[@class='label'][contains(title, '2:')]//tspan") > box + 32);
  CHECK_THAT(dot_of(graph), Contains(R"(tooltip="1: x" tailport=n headport=n)"));
  CHECK_THAT(dot_of(graph), Contains(R"(tooltip="2: ε" tailport=s headport=s)"));
}

TEST_CASE("the same graph gives the same bytes") {
  const auto graph = state_graph_of(hostile_graph(), "m");
  CHECK(*svg_of(*graph) == *svg_of(*graph));
  CHECK(dot_of(*graph) == dot_of(*state_graph_of(hostile_graph(), "m")));
}

TEST_CASE("a picture that would take minutes is refused") {
  StateGraph graph{"big", 0, {}, {}};
  const std::size_t count = 100;
  for (std::size_t i = 0; i < count; ++i) graph.states.push_back({std::to_string(i), false, "", std::nullopt});
  for (std::size_t from = 0; from < count; ++from)
    for (auto to = from + 1; to < count; ++to)
      graph.edges.push_back({from, to, "t", "x", false, false, "", "", 1, std::nullopt});
  const auto svg = svg_of(graph);
  REQUIRE_FALSE(svg.ok());
  CHECK(svg.error().text().starts_with("big: has 4950 arrows; expected at most 600 in a picture"));
}
