#include "continua/replay/export/state_graph.h"

#include <fmt/format.h>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_views.h"

namespace continua {
namespace {

// A transition from all states is drawn once where there are more states than this.
constexpr std::size_t few_states = 4;
// Lengths of a label and its parts, in columns; longer text is cut.
constexpr std::size_t longest_label = 40, longest_input = 18, longest_operation = 18, shortest_condition = 14;

constexpr const char* epsilon = "ε";

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20)
      line += {'\xE2', '\x90', static_cast<char>(0x80 + c)};  // U+2400 and on: pictures of control characters
    else if (c == 0x7F)
      line += "\xE2\x90\xA1";
    else
      line += c;
  }
  return line;
}

std::string shortened(const std::string& text, std::size_t longest) {
  if (columns(text) <= longest) return text;
  std::string cut;
  for (const char c : text) {
    if (begins_character(c) && columns(cut) + 1 >= longest) break;
    cut += c;
  }
  return cut + "…";
}

// A label of several inputs is a list in JSON.
std::string input_of(const Json& edge) {
  const auto label = text_of(edge, "input");
  const auto list = Json::parse(label, nullptr, false);
  if (!list.is_array()) return label;
  std::string inputs;
  for (const auto& one : list) {
    if (!one.is_string()) return label;
    inputs += (inputs.empty() ? "" : ", ") + one.get<std::string>();
  }
  return inputs;
}

// "push options: tail(options), region: null", "pop 2", "flush"; empty for none.
std::string operation_of(const Json& edge) {
  const auto name = text_of(edge, "operation");
  if (name == "none" || name.empty()) return {};
  const auto content = edge.value("content", Json());
  const auto plain = [](const Json& value) { return value.is_string() ? value.get<std::string>() : compact(value); };
  if (content.is_null() || (name == "pop" && content == 1)) return name;
  if (!content.is_object()) return name + " " + plain(content);
  std::string slots;
  for (const auto& [slot, term] : content.items())
    slots += fmt::format("{} {}: {}", slots.empty() ? "" : ",", slot, plain(term));
  return name + slots;
}

std::optional<std::size_t> visits_of(const Json& object) {
  const auto found = object.find("visits");
  if (found == object.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::size_t>();
}

void add(std::optional<std::size_t>& visits, std::optional<std::size_t> more) {
  if (more) visits = visits.value_or(0) + *more;
}

// Reads the header's graph part by part.
class Reader {
 public:
  Result<StateGraph> read(const Json& graph, const std::string& name) {
    graph_.name = one_line(name);
    const auto part = [&](const char* key) { return graph.is_object() ? graph.value(key, Json()) : Json(); };
    const auto states = part("states"), edges = part("edges");
    for (const auto& state : states) read_state(state);
    const auto start = part("start");
    if (start.is_string()) graph_.start = state_named(start.get<std::string>());
    for (const auto& edge : edges)
      if (edge.is_object() && !is_diverted(edge)) read_edge(edge);
    for (const auto& edge : edges)
      if (edge.is_object() && is_diverted(edge)) read_diversion(edge);
    if (graph_.states.empty()) return Error{name, "has no states; expected a machine's graph"};
    merge_edges_from_everywhere();
    return std::move(graph_);
  }

 private:
  static bool is_diverted(const Json& edge) { return edge.value("diverted", Json()) == true; }

  std::size_t state_named(const std::string& name) {
    const auto [found, is_new] = index_.emplace(name, graph_.states.size());
    if (is_new) graph_.states.push_back({one_line(name), false, "", std::nullopt});
    return found->second;
  }

  void read_state(const Json& json) {
    if (!json.is_object()) return;
    const auto index = state_named(text_of(json, "id"));
    auto& state = graph_.states[index];
    state.accepting = json.value("accepting", Json()) == true;
    state.visits = visits_of(json);
    const auto gate = json.find("gate");
    if (gate == json.end() || !gate->is_object()) return;
    state.gate = one_line(text_of(*gate, "condition"));
    const auto rejection = add_rejection(index, state_named(text_of(*gate, "else")));
    graph_.edges[rejection].operation = one_line(operation_of(*gate));
    if (visits_of(json)) graph_.edges[rejection].visits = 0;
  }

  std::size_t add_rejection(std::size_t gated, std::size_t otherwise) {
    StateGraph::Edge edge;
    edge.from = gated;
    edge.to = otherwise;
    edge.rejected = true;
    const auto& gate = graph_.states[gated].gate;
    if (!gate.empty()) edge.condition = fmt::format("not ({})", gate);
    rejections_[gated] = graph_.edges.size();
    graph_.edges.push_back(std::move(edge));
    return graph_.edges.size() - 1;
  }

  void read_edge(const Json& json) {
    StateGraph::Edge edge;
    edge.id = one_line(text_of(json, "id"));
    edge.from = state_named(text_of(json, "from"));
    edge.to = state_named(text_of(json, "to"));
    edge.input = one_line(input_of(json));
    edge.epsilon = edge.input.empty() || edge.input == epsilon;
    if (edge.epsilon) edge.input = epsilon;
    edge.condition = one_line(text_of(json, "condition"));
    edge.operation = one_line(operation_of(json));
    const auto weight = json.value("weight", Json());
    if (weight.is_number()) edge.weight = weight.get<double>();
    edge.visits = visits_of(json);
    taken_[{edge.id, *edge.from}] = graph_.edges.size();
    graph_.edges.push_back(std::move(edge));
  }

  // A run took the transition up to the gate of the state it leads to, and went on from there, maybe through others.
  void read_diversion(const Json& json) {
    const auto taken = taken_.find({one_line(text_of(json, "id")), state_named(text_of(json, "from"))});
    if (taken == taken_.end()) return read_edge(json);
    add(graph_.edges[taken->second].visits, visits_of(json));
    const auto end = state_named(text_of(json, "to"));
    auto gated = graph_.edges[taken->second].to;
    for (std::set<std::size_t> passed; gated != end && passed.insert(gated).second;) {
      const auto known = rejections_.find(gated);
      auto& rejection = graph_.edges[known == rejections_.end() ? add_rejection(gated, end) : known->second];
      add(rejection.visits, visits_of(json));
      gated = rejection.to;
    }
  }

  void merge_edges_from_everywhere() {
    if (graph_.states.size() <= few_states) return;
    std::map<std::pair<std::string, std::size_t>, std::size_t> count, kept;
    for (const auto& edge : graph_.edges)
      if (!edge.rejected) ++count[{edge.id, edge.to}];
    std::vector<StateGraph::Edge> edges;
    for (auto& edge : graph_.edges) {
      const std::pair key{edge.id, edge.to};
      if (edge.rejected || count[key] < graph_.states.size()) {
        edges.push_back(std::move(edge));
      } else if (const auto [first, is_first] = kept.emplace(key, edges.size()); is_first) {
        edge.from = std::nullopt;
        edges.push_back(std::move(edge));
      } else {
        add(edges[first->second].visits, edge.visits);
      }
    }
    graph_.edges = std::move(edges);
  }

  StateGraph graph_;
  std::map<std::string, std::size_t> index_;
  std::map<std::pair<std::string, std::size_t>, std::size_t> taken_;  ///< transition and state → edge
  std::map<std::size_t, std::size_t> rejections_;                     ///< gated state → edge
};

// "2× no [size(options) > 1] / pop".
std::string label_of(const StateGraph::Edge& edge) {
  std::string label = edge.input;
  const auto append = [&](const std::string& text) { label += (label.empty() ? "" : " ") + text; };
  if (!edge.condition.empty()) append("[" + edge.condition + "]");
  if (edge.weight != 1) append(fmt::format("weight {}", edge.weight));
  if (!edge.operation.empty()) append("/ " + edge.operation);
  if (label.empty()) label = "gate";
  return edge.visits.value_or(0) > 0 ? fmt::format("{}× {}", *edge.visits, label) : label;
}

// The same with its parts as short as they must be, the condition last to give way.
std::string short_label_of(StateGraph::Edge edge) {
  edge.input = shortened(edge.input, longest_input);
  edge.operation = shortened(edge.operation, longest_operation);
  const auto others = columns(edge.input) + columns(edge.operation);
  edge.condition = shortened(edge.condition, std::max(longest_label - others, shortest_condition));
  return label_of(edge);
}

}  // namespace

Result<StateGraph> state_graph_of(const Json& graph, const std::string& name) { return Reader().read(graph, name); }

Result<StateGraph> state_graph_of(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  const auto graph = run_graph(run);
  if (!graph) return graph.error();
  return state_graph_of(*graph, text_of(header->value("machine", Json()), "name"));
}

std::vector<Arrow> arrows_of(const StateGraph& graph) {
  std::vector<Arrow> arrows;
  std::map<std::tuple<std::optional<std::size_t>, std::size_t, bool, bool>, std::size_t> index;
  for (const auto& edge : graph.edges) {
    const bool epsilon_loop = edge.epsilon && edge.from == edge.to;
    const auto [found, is_new] =
        index.emplace(std::tuple(edge.from, edge.to, epsilon_loop, edge.rejected), arrows.size());
    if (is_new) arrows.push_back({edge.from, edge.to, epsilon_loop, edge.rejected, {}, {}, {}, std::nullopt});
    auto& arrow = arrows[found->second];
    arrow.lines.push_back(short_label_of(edge));
    arrow.labels.push_back(label_of(edge));
    arrow.full.push_back((edge.id.empty() ? "" : edge.id + ": ") + arrow.labels.back());
    add(arrow.visits, edge.visits);
  }
  return arrows;
}

std::string description(const StateGraph::State& state) {
  auto text = state.name;
  if (!state.gate.empty()) text += ", gate: " + state.gate;
  if (state.visits) text += fmt::format(", entered {} time{}", *state.visits, *state.visits == 1 ? "" : "s");
  return text;
}

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) {
    if (begins_character(c)) ++count;
    // A character of three bytes from U+3000 on, or of four, is mostly as wide as two letters.
    if (static_cast<unsigned char>(c) >= 0xE3 && static_cast<unsigned char>(c) != 0xEF) ++count;
  }
  return count;
}

}  // namespace continua
