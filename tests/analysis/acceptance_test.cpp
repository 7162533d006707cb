// Which words machines accept, where searching would not end.
#include "continua/analysis/acceptance.h"

#include "support/machines.h"

using namespace continua;

namespace {

std::vector<std::string> letters(const std::string& word) {
  std::vector<std::string> letters;
  for (const char letter : word) letters.emplace_back(1, letter);
  return letters;
}

// The accepted words among these.
std::string accepted(const std::string& machine, const std::vector<std::string>& words,
                     AcceptBy by = AcceptBy::final_state) {
  Acceptance acceptance(machine_of(machine), by);
  std::string found;
  for (const auto& word : words) {
    const auto verdict = acceptance.accepts(letters(word));
    if (!verdict) return verdict.error().text();
    if (*verdict) found += (found.empty() ? "" : " ") + (word.empty() ? "''" : word);
  }
  return found;
}

std::string machine(const std::string& transitions, const std::string& more = "") {
  return R"({"machine":1,"name":"m","start":"p","accept":["f"],"slots":{"s":"text","k":{"type":"text","persists":true}},)" +
         more + R"("states":{"p":{},"q":{},"f":{}},"transitions":[)" + transitions + "]}";
}

}  // namespace

TEST_CASE("even palindromes: the middle is guessed") {
  const auto palindromes = machine(R"(
    {"id":"a","from":"p","on":"a","to":"p","push":{"s":"'a'"}},
    {"id":"b","from":"p","on":"b","to":"p","push":{"s":"'b'"}},
    {"id":"middle","from":"p","on":null,"to":"q"},
    {"id":"a back","from":"q","on":"a","when":"s = 'a'","to":"q","pop":1},
    {"id":"b back","from":"q","on":"b","when":"s = 'b'","to":"q","pop":1},
    {"id":"end","from":"q","on":null,"when":"s = null","to":"f"})");
  CHECK(accepted(palindromes, {"", "a", "aa", "ab", "abba", "abab", "aabaabaa", "bbaabb", "abbb"}) ==
        "'' aa abba aabaabaa bbaabb");
}

TEST_CASE("ε-cycles that grow the stack are decided, not followed") {
  // Any number of x is pushed before the first letter; each letter takes one off.
  const auto growing = machine(R"(
    {"id":"grow","from":"p","on":null,"to":"p","push":{"s":"'x'"}},
    {"id":"go","from":"p","on":null,"to":"q"},
    {"id":"take","from":"q","on":"a","when":"s = 'x'","to":"q","pop":1},
    {"id":"twice","from":"q","on":"b","when":"s = 'x'","to":"q","pop":2},
    {"id":"end","from":"q","on":null,"when":"s = null","to":"f"})");
  CHECK(accepted(growing, {"", "a", "aaaa", "ab", "c"}) == "'' a aaaa ab");
  CHECK(accepted(growing, {"", "a", "c"}, AcceptBy::empty_stack) == "'' a");
}

TEST_CASE("an ε-cycle that changes nothing ends") {
  const auto circle = machine(R"(
    {"id":"there","from":"p","on":null,"to":"q"},
    {"id":"back","from":"q","on":null,"to":"p"},
    {"id":"end","from":"q","on":"a","to":"f"})");
  CHECK(accepted(circle, {"", "a", "aa"}) == "a");
}

TEST_CASE("pops stop at the bottom, flush and pop_until go down to where they should") {
  const std::string grow = R"(
    {"id":"x","from":"p","on":"x","to":"p","push":{"s":"'x'"}},
    {"id":"y","from":"p","on":"y","to":"p","push":{"s":"'y'","k":"'held'"}},)";
  CHECK(accepted(machine(grow + R"({"id":"end","from":"p","on":"e","to":"q","pop":3},
    {"id":"seen","from":"q","on":null,"when":"s = 'y'","to":"f"})"),
                 {"e", "xe", "ye", "yxxxe", "xyxxxe", "yxxe", "yxxxxe"}) == "yxxxe xyxxxe");
  CHECK(accepted(machine(grow + R"({"id":"end","from":"p","on":"e","to":"q","flush":{}},
    {"id":"seen","from":"q","on":null,"when":"s = null and k = 'held'","to":"f"})"),
                 {"e", "xe", "ye", "xyxe", "yxxxxxe"}) == "ye xyxe yxxxxxe");
  // q is entered with the symbol that was on top at m; pop_until comes back to it however much was pushed since.
  CHECK(accepted(machine(grow + R"({"id":"mark","from":"p","on":"m","to":"q"},
    {"id":"on","from":"q","on":null,"to":"p"},
    {"id":"end","from":"p","on":"e","to":"f","pop_until":"q"},
    {"id":"more","from":"f","on":"y","when":"s = 'y'","to":"f","none":true})",
                         R"("about":"",)"),
                 {"e", "ymxxe", "ymxxey", "xmxxxey", "ymxyxey", "yxmyey"}) == "e ymxxe ymxxey ymxyxey");
}

TEST_CASE("effects on entry take part: a rewrite of what a pop laid open") {
  const auto peek = R"({"machine":1,"name":"m","start":"p","accept":["f"],"slots":{"s":"text"},
    "states":{"p":{},"q":{"enter":[{"when":"s = 'x'","rewrite":{"s":"'z'"}}]},"f":{}},"transitions":[
    {"id":"x","from":"p","on":"x","to":"p","push":{"s":"'x'"}},
    {"id":"y","from":"p","on":"y","to":"p","push":{"s":"'y'"}},
    {"id":"end","from":"p","on":"e","to":"q","pop":1},
    {"id":"seen","from":"q","on":null,"when":"s = 'z'","to":"f"}]})";
  CHECK(accepted(peek, {"e", "xe", "xye", "yye", "yxxe"}) == "xye yxxe");
}

TEST_CASE("registers count as long as they are finitely many") {
  const std::string counter = R"({"machine":1,"name":"m","start":"p","accept":["p"],"slots":{},
    "memory":{"n":{"type":"num","initial":"0"}},"transitions":[
    {"id":"up","from":"p","on":"a","to":"q","do":[{"remember":{"n":"LIMIT"}}]},
    {"id":"zero","from":"q","on":null,"when":"n = 0","to":"p"},
    {"id":"other","from":"q","on":null,"when":"n != 0","to":"p1"},
    {"id":"up again","from":"p1","on":"a","to":"q","do":[{"remember":{"n":"LIMIT"}}]}]})";
  const auto with = [](std::string text, const std::string& what, const std::string& instead) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what))
      text.replace(at, what.size(), instead);
    return text;
  };
  CHECK(accepted(with(counter, "LIMIT", "if(n = 2, 0, n + 1)"), {"", "a", "aa", "aaa", "aaaa", "aaaaaa"}) ==
        "'' aaa aaaaaa");
  const auto endless = with(with(counter, "LIMIT", "n + 1"), R"("on":"a")", R"("on":null)");
  CHECK(accepted(endless, {"b"}).starts_with("m: makes more than 20028 different"));
}

TEST_CASE("ε-transitions that are tried only after a rewrite are taken only then") {
  const std::string transitions = R"(
    {"id":"silent","from":"p","on":null,"to":"f"},
    {"id":"plain","from":"p","on":"a","to":"p"},
    {"id":"rewriting","from":"p","on":"b","to":"p","rewrite":{}})";
  CHECK(accepted(machine(transitions), {"", "a", "b", "ba"}) == "'' a b ba");
  CHECK(accepted(machine(transitions, R"("epsilon":"after_rewrite",)"), {"", "a", "b", "ba", "ab"}) == "b ab");
}

TEST_CASE("a transition that a gate turns away does nothing beside") {
  const auto gated = [](const std::string& holds) {
    return R"({"machine":1,"name":"m","start":"p","accept":["f"],"slots":{},"memory":{"n":{"type":"num","initial":"0"}},
      "states":{"p":{},"q":{"gate":{"when":")" +
           holds + R"(","else":"r"}},"r":{},"f":{}},"transitions":[
      {"id":"in","from":"p","on":"a","to":"q","do":[{"remember":{"n":"1"}}]},
      {"id":"changed","from":["q","r"],"on":"b","when":"n = 1","to":"f"},
      {"id":"unchanged","from":["q","r"],"on":"c","when":"n = 0","to":"f"}]})";
  };
  CHECK(accepted(gated("n = 0"), {"ab", "ac"}) == "ab");
  CHECK(accepted(gated("n = 9"), {"ab", "ac"}) == "ac");
}
