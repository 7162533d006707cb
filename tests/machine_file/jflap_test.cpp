// JFLAP files become machines that mean the same: their shape here, the words they accept in jflap_acceptance_test.cpp.
#include "continua/machine_file/jflap.h"

#include "continua/core/characters.h"
#include "support/jflap_files.h"
#include "support/machines.h"

using namespace continua;

namespace {

const std::string two_states =
    "<state id=\"0\" name=\"q0\"><initial/></state>\n<state id=\"1\" name=\"q1\"><final/></state>\n";

std::string transition(const std::string& inside) {
  return "<transition><from>0</from><to>1</to>" + inside + "</transition>\n";
}

// The machine, a transition a line: "id | condition | operation". A text that the loader refuses fails the test.
std::string outline(const std::string& text) {
  const auto machine = machine_of_jflap(text, "m.jff");
  if (!machine) return machine.error().text();
  const auto loaded = parse_machine(compact(*machine), "m.jff", {});
  if (!loaded) return loaded.error().text();
  std::string lines;
  for (const auto& one : loaded->transitions)
    lines += fmt::format("{} | {} | {}\n", one.id, one.when ? print(*one.when) : "", one.operation.source);
  return lines;
}

std::string error_of(const std::string& text) {
  const auto machine = machine_of_jflap(text, "m.jff");
  return machine ? "" : machine.error().text();
}

}  // namespace

TEST_CASE("a transition of a finite automaton reads its symbols one after another") {
  CHECK(outline(jff("fa", two_states + transition("<read>a</read>") + transition("<read/>"))) ==
        "q0: a -> q1 |  | {\"none\":true}\n"
        "q0: λ -> q1 |  | {\"none\":true}\n");
  CHECK(outline(jff("fa", two_states + transition("<read>añb</read>"))) ==
        "q0: a -> q0 after a |  | {\"none\":true}\n"
        "q0 after a: ñ -> q0 after añ |  | {\"none\":true}\n"
        "q0 after añ: b -> q1 |  | {\"none\":true}\n");
}

TEST_CASE("pop and push of a pushdown automaton become a condition and an operation") {
  const auto pda = [](const std::string& pop, const std::string& push) {
    const auto text =
        outline(jff("pda", two_states + transition("<read>a</read><pop>" + pop + "</pop><push>" + push + "</push>")));
    CHECK(text.find("start: λ, λ; Z -> q0 |  | {\"push\":{\"symbol\":\"'Z'\"}}\n") == 0);
    return text.substr(text.find('\n') + 1);
  };
  CHECK(pda("", "") == "q0: a, λ; λ -> q1 |  | {\"none\":true}\n");
  CHECK(pda("", "A") == "q0: a, λ; A -> q1 |  | {\"push\":{\"symbol\":\"'A'\"}}\n");
  CHECK(pda("", "AB") == "q0: a, λ; AB -> q1 |  | {\"push_each\":{\"symbol\":\"['B', 'A']\"}}\n");
  CHECK(pda("Z", "") == "q0: a, Z; λ -> q1 | symbol = 'Z' | {\"pop\":1}\n");
  CHECK(pda("Z", "A") == "q0: a, Z; A -> q1 | symbol = 'Z' | {\"rewrite\":{\"symbol\":\"'A'\"}}\n");
  CHECK(pda("Z", "ZA") == "q0: a, Z; ZA -> q1 | symbol = 'Z' | {\"rewrite_each\":{\"symbol\":\"['A', 'Z']\"}}\n");
  CHECK(pda("Z", "Z") == "q0: a, Z; Z -> q1 | symbol = 'Z' | {\"none\":true}\n");
  CHECK(pda("Z", "AZ") == "q0: a, Z; AZ -> q1 | symbol = 'Z' | {\"push\":{\"symbol\":\"'A'\"}}\n");
  CHECK(pda("'\\", "\\") ==
        "q0: a, '; λ -> q0 after a, ' | symbol = '\\'' | {\"pop\":1}\n"
        "q0 after a, ': λ, \\; \\ -> q1 | symbol = '\\\\' | {\"none\":true}\n");
}

TEST_CASE(
    "chains share their beginnings, so that where one transition applied in the file one applies in the machine") {
  struct Case {
    std::vector<classical::Move> moves;
    const char* transitions;
  };
  // Without the pushing of Z, conditions and operations.
  const std::vector<Case> cases = {
      {{{0, "ab", "", "", 1}, {0, "ac", "", "", 2}},
       "q0: a, λ; λ -> q0 after a, λ\nq0 after a, λ: b, λ; λ -> q1\nq0 after a, λ: c, λ; λ -> q2\n"},
      {{{0, "ab", "A", "", 1}, {0, "a", "B", "", 2}},
       "q0: a, B; λ -> q2\nq0: a, A; λ -> q0 after a, A\nq0 after a, A: b, λ; λ -> q1\n"},
      {{{0, "a", "ABC", "", 1}, {0, "ab", "ABD", "X", 2}},
       "q0: a, A; λ -> q0 after a, A\nq0 after a, A: λ, B; λ -> q0 after a, AB\n"
       "q0 after a, AB: λ, C; λ -> q1\nq0 after a, AB: b, D; X -> q2\n"},
      {{{0, "abc", "A", "", 1}, {0, "abd", "AB", "", 2}},
       "q0: a, A; λ -> q0 after a, A\nq0 after a, A: b, λ; λ -> q0 after ab, A\n"
       "q0 after ab, A: c, λ; λ -> q1\nq0 after ab, A: d, B; λ -> q2\n"},
      {{{0, "ab", "", "", 1}, {0, "", "AB", "", 2}},
       "q0: λ, A; λ -> q0 after λ, A\nq0: a, λ; λ -> q0 after a, λ\n"
       "q0 after λ, A: λ, B; λ -> q2\nq0 after a, λ: b, λ; λ -> q1\n"},
      {{{0, "ab", "", "X", 1}, {0, "ab", "", "Y", 2}, {0, "ab", "", "X", 1}},
       "q0: a, λ; λ -> q0 after a, λ\nq0 after a, λ: b, λ; X -> q1\nq0 after a, λ: b, λ; Y -> q2\n"},
  };
  for (const auto& [moves, expected] : cases) {
    classical::Pda pda;
    pda.states = 3;
    pda.moves = moves;
    const auto machine = machine_of_jflap(jff_of(pda), "m.jff");
    REQUIRE(machine.ok());
    std::string found;
    for (const auto& one : (*machine)["transitions"])
      if (one["from"] != "start") found += one["id"].get<std::string>() + "\n";
    CHECK(found == expected);
  }
}

TEST_CASE("no word ends in an added state") {
  const auto machine =
      machine_of_jflap(jff("pda",
                           "<state id='0' name='start'><initial/><final/></state>\n<transition><from>0</from><to>0</to>"
                           "<read>ab</read></transition>"),
                       "dir/m.jff");
  REQUIRE(machine.ok());
  CHECK(compact((*machine)["states"]) ==
        R"json({"start":{},"start (2)":{"passing":true},"start after a, λ":{"passing":true}})json");
  CHECK((*machine)["start"] == "start (2)");
  CHECK(compact((*machine)["accept"]) == R"(["start"])");
  CHECK((*machine)["name"] == "m");
}

TEST_CASE("states are called as in the file, as long as that is clear") {
  const auto names = [](const std::string& states) {
    const auto machine = machine_of_jflap(jff("fa", states), "m.jff");
    if (!machine) return machine.error().text();
    std::string text;
    for (const auto& [name, state] : (*machine)["states"].items()) text += name + "|";
    return text;
  };
  CHECK(names("<state id='3' name='A b'><initial/></state><state id='4'><name>C</name></state><state id='5'/>") ==
        "A b|C|q5|");
  CHECK(names("<state id='1' name='A'><initial/></state><state id='2' name='A'/><state id='3' name='A (id 2)'/>") ==
        "A (id 1)|A (id 2) (2)|A (id 2)|");
  CHECK(names("<state id='1' name='*'><initial/></state><state id='2' name=''/><state id='-1' name='&lt;&amp;\"'/>") ==
        "* (id 1)|q2|<&\"|");
}

TEST_CASE("both layouts and every way to write XML are read") {
  const std::string states =
      "<state id=\"0\"><x>1.0</x><y>no number</y><initial/></state><state id=\"1\"><final/></state>";
  const std::string old_layout = "<structure><type>fa</type>" + states + transition("<read>é</read>") + "</structure>";
  const std::string expected = "q0: é -> q1 |  | {\"none\":true}\n";
  CHECK(outline(old_layout) == expected);
  CHECK(outline("\xEF\xBB\xBF<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?><!--Created with JFLAP 6.4.-->"
                "<!DOCTYPE structure [<!ELEMENT x "
                "(#PCDATA)>]>\r\n<structure>&#13;\r\n\t<type>fa</type>&#13;\r\n<automaton>&#13;" +
                states + transition("<read><![CDATA[é]]></read>") + "</automaton></structure>\r\n") == expected);
  CHECK(outline(jff("\r\n fa\r\n ", states + transition("<read>\r\n\té<!-- acute -->\r\n</read>"))) == expected);
  CHECK(outline(jff("fa", states + transition("<read>&#233;</read><note/><controlx>3</controlx>"))) == expected);

  std::string latin1 = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + old_layout;
  latin1.replace(latin1.find("é"), 2, "\xE9");
  CHECK(outline(latin1) == expected);
  for (const bool little : {true, false}) {
    std::string utf16 = little ? "\xFF\xFE" : "\xFE\xFF";
    for (const auto& character : characters(old_layout)) {
      const std::string low(1, character == "é" ? '\xE9' : character[0]), high(1, '\0');
      utf16 += little ? low + high : high + low;
    }
    CHECK(outline(utf16) == expected);
  }
}

TEST_CASE("λ is a missing or an empty label, a blank is a symbol") {
  for (const auto* read : {"", "<read/>", "<read></read>", "<read>\n  </read>", "<read><!-- nothing --></read>"})
    CHECK(outline(jff("fa", two_states + transition(read))) == "q0: λ -> q1 |  | {\"none\":true}\n");
  CHECK(outline(jff("fa", two_states + transition("<read> </read>"))) == "q0:   -> q1 |  | {\"none\":true}\n");
}

TEST_CASE("a label [x-y] of a finite automaton reads one character of the range, others are plain") {
  const auto on = [](const std::string& type, const std::string& read) {
    const auto machine = machine_of_jflap(jff(type, two_states + transition("<read>" + read + "</read>")), "m.jff");
    return compact((*machine)["transitions"].back()["on"]);
  };
  CHECK(on("fa", "[b-d]") == R"(["b","c","d"])");
  CHECK(on("fa", "[β-δ]") == R"(["β","γ","δ"])");
  CHECK(on("fa", "[)-+]") == R"json([")","\\*","+"])json");
  CHECK(on("fa", "[d-b]") == "[]");
  CHECK(on("fa", "[") == R"("[")");
  CHECK(on("fa", "[b-d]]") == R"("]")");
  CHECK(on("pda", "[b-d]") == R"("]")");
}

TEST_CASE("an asterisk is a symbol, not the beginning of all symbols") {
  const auto machine =
      machine_of(compact(machine_of_jflap(jff("fa", two_states + transition("<read>*</read>")), "m.jff").value()));
  CHECK(machine->knows_input("*"));
  CHECK_FALSE(machine->knows_input("a"));
  CHECK_FALSE(machine->knows_input("**"));
}

TEST_CASE("what is wrong with a JFLAP file is told by line, what was found and what was expected") {
  struct Broken {
    std::string text, message;
  };
  const std::string one = "<state id='0'><initial/></state>\n";
  const std::vector<Broken> cases = {
      {"", "m.jff:1: not valid XML: No document element found; expected a JFLAP file"},
      {"hello", "m.jff:1: not valid XML: No document element found; expected a JFLAP file"},
      {"<structure>\n<type>fa</type>\n<automaton>\n</structure>\n",
       "m.jff:4: not valid XML: Start-end tags mismatch; expected a JFLAP file"},
      {"<structure>\n<type", "m.jff:2: not valid XML: Error parsing start element tag; expected a JFLAP file"},
      {"<mujoco/>", "m.jff:1: found <mujoco>; expected <structure>, the root of a JFLAP file"},
      {"<structure>\n<automaton/></structure>",
       "m.jff:1: there is no <type>; expected <type>fa</type> or <type>pda</type>"},
      {"<structure>\n<type>turing</type></structure>",
       "m.jff:2: found an automaton of type 'turing'; expected fa or pda"},
      {"<structure><type>fa</type>\n<automaton/></structure>",
       "m.jff:2: there are no states; expected <state id=\"0\">"},
      {jff("fa", "<state id='0'/>"), "m.jff:1: no state is initial; expected one with <initial/>"},
      {jff("fa", one + "<state id='1'>\n<initial/></state>"),
       "m.jff:3: a second initial state; the first is in line 2, expected one"},
      {jff("fa", one + "<state/>"), "m.jff:3: a state without an id; expected <state id=\"0\">"},
      {jff("fa", one + "<state id='q1'/>"), "m.jff:3: found the state id 'q1'; expected an integer"},
      {jff("fa", one + "<state id=''/>"), "m.jff:3: found the state id ''; expected an integer"},
      {jff("fa", one + "<state id='99999999999999999999'/>"),
       "m.jff:3: found the state id '99999999999999999999'; expected an integer"},
      {jff("fa", one + "\r\n<!--\n--><state id='00'/>"),
       "m.jff:5: a second state with the id 0; the first is in line 2"},
      {jff("fa", one + "<transition>\n<to>0</to></transition>"),
       "m.jff:3: a transition without <from>; expected the id of a state"},
      {jff("fa", one + "<transition><from>0</from></transition>"),
       "m.jff:3: a transition without <to>; expected the id of a state"},
      {jff("fa", one + "<transition><from>0</from>\n<to>7</to></transition>"),
       "m.jff:4: found <to> '7'; expected the id of a state"},
      {jff("fa", one + "<transition><from>q0</from><to>0</to></transition>"),
       "m.jff:3: found <from> 'q0'; expected the id of a state"},
      {jff("fa", one + "<transition><from>0</from><to>0</to><read>a</read>\n<read>b</read></transition>"),
       "m.jff:4: a second <read> of a transition; expected one"},
      {jff("fa", one + "<!-- \xC3\x28 -->"),
       "m.jff:3: found the byte 0xc3, which is not UTF-8; expected a JFLAP file in XML"},
  };
  for (const auto& [text, message] : cases) {
    CAPTURE(text);
    CHECK(error_of(text) == message);
  }
}

TEST_CASE("a line is a line in other encodings too") {
  std::string text = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!--";
  for (int i = 0; i < 100; ++i) text += "\xE9\n";
  CHECK(error_of(text + "--><structure><type>pda</type></structure>") ==
        "m.jff:102: there are no states; expected <state id=\"0\">");
}

TEST_CASE("a long label makes a long chain and short names") {
  const auto machine =
      machine_of_jflap(jff("pda", two_states + transition("<pop>" + std::string(5000, 'A') + "</pop>")), "m.jff");
  REQUIRE(machine.ok());
  CHECK((*machine)["transitions"].size() == 5001);
  CHECK((*machine)["transitions"][5000]["id"] == "q0 after λ, AAAAAAAAAAAA… (4987): λ, A; λ -> q1");
}
