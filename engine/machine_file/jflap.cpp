#include "continua/machine_file/jflap.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "continua/machine_file/jflap_file.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

using Symbols = std::vector<std::string>;

// The symbols that a transition reads and pops, at most one of each.
struct Edge {
  std::optional<std::string> read, pop;
  auto operator<=>(const Edge&) const = default;
};

// A transition of the file, with the numbers of symbols that are read and popped already.
struct Rest {
  const JflapTransition* transition = nullptr;
  std::size_t read = 0, popped = 0;

  bool reads() const { return read < transition->read.size(); }
  bool pops() const { return popped < transition->pop.size(); }
  Edge next() const {
    return {reads() ? std::optional(transition->read[read]) : std::nullopt,
            pops() ? std::optional(transition->pop[popped]) : std::nullopt};
  }
};

// A few symbols in the names of states and transitions.
std::string label(const Symbols& symbols, std::size_t count) {
  constexpr std::size_t longest = 12;
  if (count == 0) return "λ";
  const auto end = symbols.begin() + static_cast<std::ptrdiff_t>(std::min(count, longest));
  return fmt::format("{}{}", fmt::join(symbols.begin(), end, ""), count > longest ? "…" : "");
}

std::string label(const std::optional<std::string>& symbol) { return symbol.value_or("λ"); }

// An input symbol in the notation of FORMAT.md.
std::string input(const std::string& symbol) { return symbol == "*" ? "\\*" : symbol; }

// Gives each name only once.
class Names {
 public:
  std::string fresh(const std::string& wanted) {
    auto name = wanted;
    while (!given_.insert(name).second) name = fmt::format("{} ({})", wanted, ++repeated_[wanted] + 1);
    return name;
  }

 private:
  std::set<std::string> given_;
  std::map<std::string, int> repeated_;
};

class Translator {
 public:
  Translator(const JflapAutomaton& file, const std::string& name) : file_(file) {
    machine_ = {{"machine", 1}, {"name", name}, {"start", ""}, {"accept", Json::array()}};
    if (file.pushdown) machine_["slots"] = {{"symbol", "text"}};
    machine_["states"] = Json::object();
    machine_["transitions"] = Json::array();
    name_states();
  }

  Json machine() && {
    if (file_.pushdown) {
      const auto start = passing_state("start");
      add(start, {}, {"Z"}, names_[file_.start]);
      machine_["start"] = start;
    } else {
      machine_["start"] = names_[file_.start];
    }
    std::map<std::size_t, std::vector<Rest>> chains;
    for (const auto& transition : file_.transitions) {
      if (transition.reads_any)
        add_any(transition);
      else if (transition.read.size() > 1 || transition.pop.size() > 1)
        chains[transition.from].push_back({&transition});
      else
        add(names_[transition.from], Rest{&transition}.next(), transition.push, names_[transition.to]);
    }
    for (auto& [from, rests] : chains) add_chains(names_[from], std::move(rests));
    return std::move(machine_);
  }

 private:
  // Keeps names that occur once. "*" is not a name, because it stands for all states.
  void name_states() {
    std::map<std::string, int> count{{"*", 1}};
    for (const auto& state : file_.states) ++count[state.name];
    for (const auto& state : file_.states)
      if (count[state.name] == 1) state_names_.fresh(state.name);
    for (const auto& state : file_.states) {
      names_.push_back(count[state.name] == 1 ? state.name
                                              : state_names_.fresh(fmt::format("{} (id {})", state.name, state.id)));
      machine_["states"][names_.back()] = Json::object();
      if (state.accepting) machine_["accept"].push_back(names_.back());
    }
  }

  std::string passing_state(const std::string& wanted) {
    auto name = state_names_.fresh(wanted);
    machine_["states"][name] = {{"passing", true}};
    return name;
  }

  // Adds the chains from one state as a tree: transitions with the same next edge share it.
  void add_chains(const std::string& from, std::vector<Rest> all) {
    std::deque<std::pair<std::string, std::vector<Rest>>> open{{from, std::move(all)}};
    for (; !open.empty(); open.pop_front()) {
      const auto& [state, rests] = open.front();
      for (const auto& [edge, after] : branches(rests)) {
        std::vector<Rest> unfinished;
        for (const auto& rest : after)
          if (rest.reads() || rest.pops())
            unfinished.push_back(rest);
          else
            add(state, edge, rest.transition->push, names_[rest.transition->to]);
        if (unfinished.empty()) continue;
        const auto& [transition, read, popped] = unfinished.front();
        auto name = fmt::format("{} after {}", from, label(transition->read, read));
        if (file_.pushdown) name += ", " + label(transition->pop, popped);
        const auto next = passing_state(name);
        add(state, edge, {}, next);
        open.emplace_back(next, std::move(unfinished));
      }
    }
  }

  // Groups `rests` by their next edge. If all of them read (else, if all pop), that decides the edge. The other half of
  // the edge is put off if some transition with the same symbol lacks it. So two transitions that can never apply
  // together part before one of them goes on alone.
  static std::map<Edge, std::vector<Rest>> branches(const std::vector<Rest>& rests) {
    const bool all_read = std::all_of(rests.begin(), rests.end(), [](const Rest& rest) { return rest.reads(); });
    const bool all_pop = std::all_of(rests.begin(), rests.end(), [](const Rest& rest) { return rest.pops(); });
    std::set<std::string> alone;
    for (const auto& rest : rests) {
      if (all_read && !rest.pops()) alone.insert(*rest.next().read);
      if (all_pop && !rest.reads()) alone.insert(*rest.next().pop);
    }
    std::map<Edge, std::vector<Rest>> found;
    for (auto rest : rests) {
      auto edge = rest.next();
      if (all_read && alone.contains(*edge.read)) edge.pop.reset();
      if (all_pop && !all_read && alone.contains(*edge.pop)) edge.read.reset();
      rest.read += edge.read.has_value();
      rest.popped += edge.pop.has_value();
      found[edge].push_back(rest);
    }
    return found;
  }

  void add(const std::string& from, const Edge& edge, const Symbols& push, const std::string& to) {
    auto description = label(edge.read);
    if (file_.pushdown) description += fmt::format(", {}; {}", label(edge.pop), label(push, push.size()));
    Json transition = {{"id", ids_.fresh(fmt::format("{}: {} -> {}", from, description, to))}, {"from", from}};
    transition["on"] = edge.read ? Json(input(*edge.read)) : Json();
    if (edge.pop) transition["when"] = "symbol = " + print(Term::text(*edge.pop));
    transition["to"] = to;
    add_operation(transition, edge.pop, push);
    machine_["transitions"].push_back(std::move(transition));
  }

  // Adds the operation. A symbol that is popped and pushed again stays on the stack.
  static void add_operation(Json& transition, const std::optional<std::string>& pop, const Symbols& push) {
    std::vector<Term> pushed;
    for (auto symbol = push.rbegin(); symbol != push.rend(); ++symbol) pushed.push_back(Term::text(*symbol));
    const bool stays = pop && !push.empty() && push.back() == *pop;
    if (stays) pushed.erase(pushed.begin());
    const std::string operation = pop && !stays ? "rewrite" : "push";
    if (pushed.empty() && pop && !stays) transition["pop"] = 1;
    if (pushed.size() == 1) transition[operation] = {{"symbol", print(pushed.front())}};
    if (pushed.size() > 1) transition[operation + "_each"] = {{"symbol", print(Term::list(pushed, Type::text_type()))}};
  }

  void add_any(const JflapTransition& transition) {
    const auto &from = names_[transition.from], &to = names_[transition.to];
    Json symbols = Json::array();
    for (const auto& symbol : transition.read) symbols.push_back(input(symbol));
    const auto range = transition.read.empty() ? "" : transition.read.front() + "-" + transition.read.back();
    machine_["transitions"].push_back({{"id", ids_.fresh(fmt::format("{}: [{}] -> {}", from, range, to))},
                                       {"from", from},
                                       {"on", std::move(symbols)},
                                       {"to", to}});
  }

  const JflapAutomaton& file_;
  std::vector<std::string> names_;  // of the file's states, by index
  Names state_names_, ids_;
  Json machine_;
};

}  // namespace

bool is_jflap(std::string_view text, std::string_view name) {
  text = without_byte_order_mark(text);
  const auto begin = text.find_first_not_of(" \t\r\n");
  const bool is_xml = begin != std::string_view::npos && text[begin] == '<';
  return name.ends_with(".jff") || (is_xml && text.find("<structure") != std::string_view::npos);
}

Result<Json> machine_of_jflap(std::string_view text, const std::string& name) {
  const auto automaton = read_jflap(text, name);
  if (!automaton) return automaton.error();
  return Translator(*automaton, std::filesystem::path(name).stem().string()).machine();
}

}  // namespace continua
