// The analysis of machines: for machines of known classes, and for random ones, against their behaviour.
#include "continua/analysis/machine_analysis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <set>
#include <sstream>

#include "reference/naive_machines.h"
#include "support/machines.h"
#include "support/twin_samples.h"

using namespace continua;

namespace {

std::string machine(const std::string& transitions, const std::string& more = "") {
  return R"({"machine":1,"name":"m","start":"A","accept":["F"],"slots":{"s":"text","n":"num"},)" + more +
         R"("transitions":[)" + transitions + "]}";
}

// "NPDA decided; A x: 1 2 (s = 'a') after y; unreachable: B; dead ends: C; never: 3; cycle: 4 5"
std::string analysed(const std::string& text) {
  const auto loaded = machine_of(text);
  const auto analysis = analyse(loaded);
  const auto id = [&](std::size_t transition) { return loaded->transitions[transition].id; };
  auto told = analysis.class_name() + (analysis.decided ? "" : " undecided");
  for (const auto& conflict : analysis.conflicts)
    told += fmt::format("; {} {}: {} {} ({}){}", loaded->states[conflict.state].name, conflict.input.value_or("ε"),
                        id(conflict.first), id(conflict.second), conflict.witness,
                        conflict.word ? " after '" + *conflict.word + "'" : "");
  const auto list = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) told += fmt::format("; {}: {}", what, fmt::join(names, " "));
  };
  const auto names = [&](const auto& indices, const auto& name) {
    std::vector<std::string> all;
    for (const auto index : indices) all.push_back(name(index));
    return all;
  };
  const auto state = [&](StateIndex index) { return loaded->states[index].name; };
  list("unreachable", names(analysis.unreachable, state));
  list("dead ends", names(analysis.dead_ends, state));
  list("never", names(analysis.never_fires, id));
  for (const auto& cycle : analysis.epsilon_cycles) list("cycle", names(cycle, id));
  return told;
}

}  // namespace

TEST_CASE("the class is that of the definitions, weights but 1 are no certainty") {
  CHECK(analysed(machine(R"({"id":"1","from":"A","on":"x","to":"F"})")) == "DFA");
  CHECK(analysed(machine(R"({"id":"1","from":"A","on":"x","to":"F","weight":2})")) == "NFA");
  CHECK(analysed(machine(R"({"id":"1","from":"A","on":"x","to":"F"},{"id":"2","from":"A","on":"x","to":"A"})")) ==
        "NFA; A x: 1 2 (the bottom symbol) after ''");
  CHECK(analysed(machine(R"({"id":"1","from":"A","on":"x","to":"F","push":{}})")) == "DPDA");
  CHECK(analysed(
            machine(R"({"id":"1","from":"A","on":"x","to":"F","push":{}},{"id":"2","from":"A","on":null,"to":"F"})")) ==
        "NPDA; A x: 1 2 (the bottom symbol) after ''");
}

TEST_CASE("a conflict comes with a configuration and the shortest word that leads there") {
  CHECK(analysed(machine(R"(
    {"id":"a","from":"A","on":"a","to":"A","push":{"s":"'a'"}}, {"id":"b","from":"A","on":"b","to":"A","push":{"s":"'b'","n":"1"}},
    {"id":"any","from":"A","on":"p*","to":"F"}, {"id":"some","from":"A","on":["pq","r"],"when":"s = 'b'","to":"F"})")) ==
        "NPDA; A pq: any some (s = 'b', n = 1) after 'b'");
  // After x the top is never 'a' again, so the second pair cannot meet.
  CHECK(analysed(machine(R"(
    {"id":"a","from":"A","on":"a","to":"B","push":{"s":"'a'"}}, {"id":"x","from":"B","on":"x","to":"F","rewrite":{"s":"'b'"}},
    {"id":"1","from":"F","on":"y","when":"s = 'a'","to":"A"}, {"id":"2","from":"F","on":"y","to":"F"})")) ==
        "DPDA; never: 1");
}

TEST_CASE("parts that play none are found: by their conditions too") {
  CHECK(analysed(machine(R"(
    {"id":"1","from":"A","on":"x","to":"F"}, {"id":"2","from":"A","on":"y","to":"T"}, {"id":"3","from":"T","on":"x","to":"T"},
    {"id":"4","from":"A","on":"z","when":"s = 'never'","to":"U"}, {"id":"5","from":"U","on":"x","to":"F"})")) ==
        "DFA; unreachable: U; dead ends: T; never: 4 5");
  CHECK(analysed(machine(R"({"id":"1","from":"A","on":"x","to":"G"}, {"id":"2","from":"G","on":"x","to":"F"})",
                         R"("states":{"A":{},"F":{},"H":{},"G":{"gate":{"when":"s = 'a'","else":"H"}}},)")) ==
        "DFA; unreachable: F G; dead ends: A H; never: 2");
}

TEST_CASE("ε-cycles that change nothing are told with their path, one that pushes is none") {
  CHECK(analysed(machine(R"(
    {"id":"in","from":"A","on":"x","to":"B"}, {"id":"bc","from":"B","on":null,"to":"C"}, {"id":"cb","from":"C","on":null,"to":"B"},
    {"id":"out","from":"C","on":"x","when":"s = 'a'","to":"F"})")) ==
        "DFA; unreachable: F; dead ends: A B C; never: out; cycle: bc cb");
  CHECK(analysed(machine(R"(
    {"id":"in","from":"A","on":"x","to":"F"}, {"id":"grow","from":"F","on":null,"to":"F","push":{"s":"'a'"}})")) ==
        "DPDA");
}

TEST_CASE("a machine that reads the world, or counts without end, is judged by its text") {
  const auto pair = [](const std::string& a, const std::string& b) {
    return analysed(machine(R"({"id":"far","from":"A","on":"z","when":"first(target) > 0","to":"F"},
      {"id":"1","from":"A","on":"x","when":")" +
                                a + R"(","to":"F"}, {"id":"2","from":"A","on":"x","when":")" + b + R"(","to":"F"})",
                            R"json("define":{"first":"\\p. x(p)","big":"n > 2 or s = 'huge'"},)json"));
  };
  const std::string none = "DFA undecided";
  CHECK(pair("n > 1", "n <= 1") == none);
  CHECK(pair("n > 1", "1 >= n") == none);
  CHECK(pair("n = 1", "n != 1") == none);
  CHECK(pair("n = 1", "n = 2") == none);
  CHECK(pair("s = null", "s = 'a' and n = 1") == none);
  CHECK(pair("n = null", "n < 4") == none);
  CHECK(pair("not (s = 'a' or n = 1)", "n = 1") == none);
  CHECK(pair("big", "not big") == none);
  CHECK(pair("n > x(target)", "n <= x(target)") == none);
  CHECK(pair("n > 1", "n < 3") == "NFA undecided; A x: 1 2 (n > 1 and n < 3)");
  CHECK(pair("s = 'a'", "n = 1") == "NFA undecided; A x: 1 2 (s = 'a' and n = 1)");
  CHECK(pair("big", "n < 3") == "NFA undecided; A x: 1 2 (n > 2 and n < 3)");
  CHECK(analysed(machine(R"json({"id":"up","from":"A","on":"x","to":"F","push":{"n":"if(n = null, 0, n + 1)"
}
},
    {"id":"again","from":"F","on":"x","to":"F","rewrite":{"n":"n + 1"}})json")) == "DPDA undecided");
}

TEST_CASE("what random machines do is what was told of them") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(300); ++number) {
    const auto text = naive::json(naive::sampled_machine(number, {true, false}));
    CAPTURE(text);
    const auto loaded = machine_of(text);
    const auto analysis = analyse(loaded);
    REQUIRE(analysis.decided);
    std::set<std::tuple<StateIndex, std::size_t, std::size_t>> told;
    for (const auto& conflict : analysis.conflicts) told.emplace(conflict.state, conflict.first, conflict.second);

    // All configurations that few transitions lead to, whether inputs or ε.
    const Stepper stepper(loaded, no_facts);
    const Beliefs beliefs(loaded->beliefs);
    const Facts facts{.beliefs = &beliefs};
    std::deque<Configuration> open{stepper.initial()};
    std::set<std::tuple<StateIndex, std::size_t, std::size_t>> met;
    for (int visited = 0; !open.empty() && visited < 150; ++visited, open.pop_front()) {
      const auto configuration = open.front();
      REQUIRE(std::count(analysis.unreachable.begin(), analysis.unreachable.end(), configuration.state) == 0);
      std::vector<std::size_t> silent;
      for (const std::string input : {"", "a", "b"}) {
        Input offered;
        offered.symbol = input;
        const auto* given = input.empty() ? nullptr : &offered;
        auto takers = input.empty() ? std::vector<std::size_t>() : silent;
        for (const auto& one : stepper.firing(configuration, given, facts, nullptr).applicable().candidates) {
          auto firing = stepper.firing(configuration, given, facts, nullptr);
          if (!firing.fire({one.transition, 1, {}, false}, {}, 0)) continue;
          takers.push_back(one.transition);
          open.push_back(std::move(firing).take());
          REQUIRE(std::count(analysis.never_fires.begin(), analysis.never_fires.end(), one.transition) == 0);
        }
        for (std::size_t b = 0; b < takers.size(); ++b)
          for (std::size_t a = 0; a < b; ++a)
            met.emplace(configuration.state, std::min(takers[a], takers[b]), std::max(takers[a], takers[b]));
        if (input.empty()) silent = takers;
      }
    }
    REQUIRE(std::includes(told.begin(), told.end(), met.begin(), met.end()));
    for (const auto& conflict : analysis.conflicts) CHECK((conflict.word || told.size() > met.size()));
    ++agreed.machines;
  }
  agreed.tell();
}
