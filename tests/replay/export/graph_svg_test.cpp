// The picture of a state graph: nothing of it is cut or covered, at the width that it is made for.
#include "continua/replay/export/graph_svg.h"

#include <pugixml.hpp>

#include "continua/knowledge_files/named_machine.h"
#include "continua/replay/export/arrow_labels.h"
#include "continua/replay/export/badge_places.h"
#include "continua/replay/export/graph_part.h"
#include "continua/replay/log/record_json.h"
#include "continua/replay/recorder/machine_graph.h"
#include "replay/inspector/inspector_log.h"
#include "support/folders.h"

using namespace continua;

namespace {

StateGraph graph_of_machine(const std::string& name) {
  const auto machine = load_named_machine(name, "");
  if (!machine) FAIL(machine.error().text());
  return state_graph_of(log::to_json(graph_of(**machine)), (*machine)->name).value();
}

pugi::xml_document parsed(const std::string& svg) {
  pugi::xml_document document;
  REQUIRE(document.load_string(svg.c_str()));
  return document;
}

PageBox box_of(const pugi::xml_node& rect) {
  const auto of = [&](const char* name) { return rect.attribute(name).as_double(); };
  return {{of("x") + of("width") / 2, of("y") + of("height") / 2}, of("width"), of("height")};
}

// The states and labels of a drawing.
std::vector<PageBox> boxes_of(const pugi::xml_document& svg) {
  std::vector<PageBox> boxes;
  for (const auto& box : svg.select_nodes("//rect[@class='box' or @class='badge']"))
    boxes.push_back(box_of(box.node()));
  for (const auto& label : svg.select_nodes("//g[starts-with(@class,'label') and not(rect)]/text")) {
    std::size_t widest = 0, lines = 0;
    for (const auto& line : label.node().children()) {
      widest = std::max(widest, columns(line.text().get()));
      ++lines;
    }
    const auto first = label.node().first_child();
    const double height = 12 * static_cast<double>(lines);
    boxes.push_back({{first.attribute("x").as_double(), first.attribute("y").as_double() - 9.4 + height / 2},
                     5.6 * static_cast<double>(widest),
                     height});
  }
  return boxes;
}

std::size_t overlaps(const std::vector<PageBox>& boxes) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (boxes[i].meets(boxes[j])) ++count;
  return count;
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

// All of the picture that can be read, without blanks.
std::string told(const pugi::xml_document& svg) {
  std::string text;
  for (const auto& part : svg.select_nodes("//text//text()")) text += part.node().value();
  return without_blanks(text);
}

double width_of(const pugi::xml_document& svg) { return svg.child("svg").attribute("width").as_double(); }

StateGraph three_states() {
  StateGraph graph{"m", 0, {}, {}};
  for (const char* name : {"Wait", "AskWhichBlock", "Done"}) graph.states.push_back({name, false, "", std::nullopt});
  const auto add = [&](std::size_t from, std::size_t to, const char* input, std::size_t visits) {
    graph.edges.push_back({from, to, "t", input, false, false, "", "", 1, visits});
  };
  add(0, 1, "n", 16);
  add(1, 2, "y", 1);
  add(2, 0, "x", 0);
  return graph;
}

}  // namespace

TEST_CASE("nothing of a machine's picture is cut or covered, on a page or in a column") {
  for (const char* name : {"palindromes", "brackets", "figure_three_states", "table_1", "raising", "diana2018"}) {
    const auto graph = graph_of_machine(name);
    for (const double width : {page_width_mm, 85.0}) {
      CAPTURE(name, width);
      const auto picture = svg_of(graph, width);
      REQUIRE(picture);
      const auto svg = parsed(*picture);
      CHECK(overlaps(boxes_of(svg)) == 0);
      CHECK(width_of(svg) <= width + 0.1);
      const auto text = told(svg);
      for (const auto& arrow : arrows_of(graph))
        for (const auto& label : arrow.labels) {
          INFO(label);
          CHECK(text.find(without_blanks(label)) != std::string::npos);
        }
    }
  }
}

TEST_CASE("an arrow with a number has it in the legend, with its states and its labels") {
  auto graph = three_states();
  graph.edges[0].condition =
      "size(options) > 1 and size(candidates) > 1 and not some(options, \\x. near(x, region)) and region != null and "
      "shown_places = null";
  const auto svg = parsed(*svg_of(graph, 60));
  CHECK(svg.select_nodes("//rect[@class='badge']").size() == 1);
  const auto text = told(svg);
  CHECK(text.find(without_blanks("1Wait → AskWhichBlockt: 16× n [" + graph.edges[0].condition + "]")) !=
        std::string::npos);
}

TEST_CASE("a line is as thick as a run used it") {
  const auto svg = parsed(*svg_of(three_states()));
  const auto style = [&](const char* from) {
    const auto path = fmt::format("//g[starts-with(@class,'arrow') and starts-with(title,'{}')]/path", from);
    return std::string(svg.select_node(path.c_str()).node().attribute("style").value());
  };
  CHECK(style("Wait") == "stroke-width:4px");
  CHECK(style("AskWhichBlock") == "stroke-width:1.8px");
  CHECK(style("Done").empty());
}

TEST_CASE("a part of a graph has the states that are asked for, and the arrows among them") {
  const auto part = part_with_states(three_states(), {"Done", "Wait"});
  REQUIRE(part);
  REQUIRE(part->states.size() == 2);
  CHECK(part->states[1].name == "Done");
  REQUIRE(part->edges.size() == 1);
  CHECK(part->edges[0].from == 1);
  CHECK(part->start == 0);
  const auto without_start = part_with_states(three_states(), {"AskWhichBlock"});
  REQUIRE(without_start);
  CHECK_FALSE(without_start->start);
  CHECK(svg_of(*without_start));
  CHECK(part_with_states(three_states(), {})->states.size() == 3);
  CHECK(part_with_states(three_states(), {"AskWichBlock"}).error().text() ==
        "--states: found 'AskWichBlock'; expected states of m (did you mean 'AskWhichBlock'?)");
}

TEST_CASE("the visited part of a graph has what a run used, and the start") {
  const auto part = visited_part(three_states());
  CHECK(part.states.size() == 3);
  CHECK(part.edges.size() == 2);
  auto unused = three_states();
  for (auto& edge : unused.edges) edge.visits = 0;
  CHECK(visited_part(unused).states.size() == 1);
}

TEST_CASE("a run of another machine has no visits of this one") {
  const ScratchFolder folder;
  const auto run = RunIndex::open(folder.write("small.run.jsonl", small_log().text()));
  REQUIRE(run);
  CHECK(visits_of_machine("two", *run));
  CHECK(visits_of_machine("three", *run).error().sentence == "is a run of the machine 'two'; expected one of 'three'");
}

TEST_CASE("a text is broken at blanks, and in a word that is too long") {
  struct Case {
    const char* text;
    std::vector<std::string> lines;
  };
  const Case cases[] = {{"", {""}},
                        {"ab cd ef", {"ab cd", " ef"}},
                        {"abcdefgh", {"abcde", " fgh"}},
                        {"λλλλλλ", {"λλλλλ", " λ"}},
                        {"a bcdefghi", {"a", " bcde", " fghi"}}};
  for (const auto& [text, lines] : cases) {
    CAPTURE(text);
    CHECK(broken(text, 5, " ") == lines);
  }
}

TEST_CASE("a name is broken between its words, never cut") {
  CHECK(broken_name("ComposeObjectAndAction", 10) == std::vector<std::string>{"Compose", "ObjectAnd", "Action"});
  CHECK(broken_name("first half", 14) == std::vector<std::string>{"first half"});
  CHECK(broken_name("first half", 6) == std::vector<std::string>{"first", "half"});
  CHECK(broken_name("unbreakablename", 6) == std::vector<std::string>{"unbreakablename"});
  CHECK(broken_name("", 6) == std::vector<std::string>{""});
}

TEST_CASE("the width of a picture has a unit, or is in millimetres") {
  for (const auto& [text, mm] : std::vector<std::pair<const char*, double>>{
           {"85", 85}, {"85mm", 85}, {"85 mm", 85}, {"8.5cm", 85}, {"960px", 254}, {"720pt", 254}}) {
    CAPTURE(text);
    CHECK(picture_width(text, "--width").value() == Approx(mm));
  }
  for (const char* wrong : {"", "wide", "85in", "0", "-85", "nan", "39", "1e9"}) {
    CAPTURE(wrong);
    CHECK_FALSE(picture_width(wrong, "--width"));
  }
  CHECK(picture_width("9in", "--width").error().text() ==
        "--width: found '9in'; expected a width from 40 to 2000 mm, such as 85, 85mm, 8.5cm or 320px");
}
