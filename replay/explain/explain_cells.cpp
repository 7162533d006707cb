#include "continua/replay/explain/explain_cells.h"

#include <algorithm>
#include <set>

#include "continua/replay/explain/explain_origin.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/term/written_term.h"

namespace continua {
namespace {

constexpr std::size_t most_symbols = 24, most_cells = 96;  // of a stack
constexpr std::size_t most_hops = 300, most_changes = 8;   // of a cell's history
constexpr std::size_t most_marks = 200;                    // looked at for who reads
constexpr std::size_t most_scopes = 24;                    // turns that values are traced to

std::string value_of(const Json& value) {
  return value.is_null() ? std::string() : value.is_string() ? value.get<std::string>() : compact(value);
}

struct Cell {
  std::int64_t symbol = -1;
  std::string slot;
  Json value;
  std::vector<std::int64_t> symbols;  // of its place, the latest first
  std::size_t set = 0;
  std::vector<std::size_t> changes;
  std::optional<std::size_t> read;
};

class Cells {
 public:
  explicit Cells(ExplainScope& scope) : scope_(scope), run_(scope.run()), marks_(run_.stack_marks()) {
    conditions_of(header_member(run_, "graph"));
    if (run_.size() > 1 && log::is<log::Symbol>(run_.kind(1)))
      if (const auto& id = member_of(scope_.record(1), "id"); id.is_number_integer()) first_ = id.get<std::int64_t>();
  }

  std::vector<Cell> all() {
    std::vector<Cell> cells;
    const auto mark = run_.mark_at(scope_.n());
    if (!mark) return cells;
    auto id = marks_[*mark].top;
    for (std::size_t depth = 0; depth < most_symbols && run_.symbol(id); ++depth, id = run_.symbol(id)->below) {
      const auto& slots = slots_of(id);
      if (!slots.is_object()) continue;
      const auto place = places_of(id);
      for (const auto& [slot, value] : slots.items()) {
        if (value.is_null() || cells.size() == most_cells) continue;
        cells.push_back({id, slot, value, place, 0, {}, {}});
        follow(cells.back());
      }
    }
    find_readers(cells, *mark);
    return cells;
  }

  Json expression(std::size_t n, const std::string& slot) {
    const auto& operation = member_of(scope_.record(n), "operation");
    if (!operation.is_object() || operation.empty()) return nullptr;
    return member_of(operation.begin().value(), slot.c_str());
  }

 private:
  void conditions_of(const Json& graph) {
    for (const auto& edge : member_of(graph, "edges"))
      conditions_[text_of(edge, "id")] += " " + text_of(edge, "condition");
    for (const auto& state : member_of(graph, "states"))
      if (const auto& gate = member_of(state, "gate"); gate.is_object())
        entries_[text_of(state, "id")] += " " + text_of(gate, "condition");
  }

  const Json& slots_of(std::int64_t id) {
    const auto* place = run_.symbol(id);
    static const Json none = Json::object();
    return place ? member_of(scope_.record(place->n), "slots") : none;
  }

  // The first mark after the symbol was made: place in marks_.
  std::size_t mark_of(std::int64_t id) const {
    return static_cast<std::size_t>(std::upper_bound(marks_.begin(), marks_.end(), run_.symbol(id)->n,
                                                     [](std::size_t n, const StackMark& one) { return n < one.n; }) -
                                    marks_.begin());
  }

  // The record that put the symbol there.
  std::size_t made_by(std::int64_t id) const {
    const auto mark = mark_of(id);
    return id == first_ || mark == marks_.size() ? run_.symbol(id)->n : marks_[mark].n;
  }

  std::int64_t top_before(std::size_t mark) const { return mark == 0 ? first_ : marks_[mark - 1].top; }

  // The symbol whose place this one took when it was made: the one on the same tail; -1 for none.
  std::int64_t before(std::int64_t id) const {
    const auto mark = mark_of(id);
    if (id == first_ || mark == marks_.size()) return -1;
    const auto below = run_.symbol(id)->below;
    auto other = top_before(mark);
    for (std::size_t hops = 0; hops < most_hops; ++hops, other = run_.symbol(other)->below) {
      if (!run_.symbol(other)) return -1;
      if (run_.symbol(other)->below == below) return other == id ? -1 : other;
    }
    return -1;
  }

  std::vector<std::int64_t> places_of(std::int64_t id) const {
    std::vector<std::int64_t> ids;
    for (; id >= 0 && ids.size() < most_hops; id = before(id)) ids.push_back(id);
    return ids;
  }

  bool names(std::size_t n, const std::string& slot) {
    const auto& operation = member_of(scope_.record(n), "operation");
    return operation.is_object() && !operation.empty() && operation.begin().value().is_object() &&
           operation.begin().value().contains(slot);
  }

  // Back through the symbols that had the slot: the source of the value, and its earlier values.
  void follow(Cell& cell) {
    bool settled = false;
    auto value = cell.value;
    auto id = cell.symbol;
    for (std::size_t hops = 0; hops < most_hops; ++hops) {
      const auto made = made_by(id);
      auto older = before(id);
      // A pushed symbol takes over the slots that the operation does not set.
      if (older < 0 && !names(made, cell.slot)) older = run_.symbol(id)->below;
      const auto& was = older < 0 ? Json() : member_of(slots_of(older), cell.slot.c_str());
      if (was != value || names(made, cell.slot)) {
        if (!settled)
          cell.set = made;
        else
          cell.changes.push_back(made);
        settled = true;
      }
      if (was.is_null() || older == id || !run_.symbol(older) || cell.changes.size() == most_changes) break;
      value = was;
      id = older;
    }
    if (!settled) cell.set = made_by(id);
  }

  // The texts that the record read.
  std::string looked_at(std::size_t n) {
    const auto& record = scope_.record(n);
    std::string text = conditions_[text_of(record, "id")] + entries_[text_of(record, "state")];
    if (const auto& gates = member_of(record, "gates"); gates.is_array())
      for (const auto& gate : gates) text += " " + text_of(gate, "condition");
    const auto& operation = member_of(record, "operation");
    if (operation.is_object() && !operation.empty() && operation.begin().value().is_object())
      for (const auto& [slot, value] : operation.begin().value().items()) text += " " + value_of(value);
    return text;
  }

  void find_readers(std::vector<Cell>& cells, std::size_t last) {
    for (auto marks = last + 1; marks > 0 && last + 1 - marks < most_marks; --marks) {
      const auto mark = marks - 1;
      const auto top = top_before(mark);
      std::optional<std::string> text;
      for (auto& cell : cells) {
        if (cell.read || std::find(cell.symbols.begin(), cell.symbols.end(), top) == cell.symbols.end()) continue;
        if (!text) text = looked_at(marks_[mark].n);
        if (mentions(*text, cell.slot)) cell.read = static_cast<std::size_t>(marks_[mark].n);
      }
    }
  }

  ExplainScope& scope_;
  const RunIndex& run_;
  const std::vector<StackMark>& marks_;
  std::int64_t first_ = -1;  // the symbol that the log begins with
  std::map<std::string, std::string> conditions_, entries_;
};

// Whether it says no more than which record set the value.
bool tells_nothing(const Json& origin, const ExplainScope& turn) {
  const auto kind = text_of(origin, "kind");
  const auto& input = member_of(origin, "input");
  const bool here = input.is_null() || turn.input_of(turn.n()) == input.get<std::size_t>();
  return kind == "machine" || (here && (kind == "slot" || kind == "memory"));
}

// The origin of a value that the machine itself made: the input that it answered, or null.
Json made_of_input(ExplainScope& turn) {
  const auto input = turn.input_of(turn.n());
  if (!input) return nullptr;
  return {{"kind", "machine"},
          {"text", "what the machine made of " + told_input(turn, *input)},
          {"n", turn.n()},
          {"input", *input},
          {"t", turn.run().entry(*input).t.seconds()}};
}

}  // namespace

Json explained_cells(ExplainScope& scope) {
  Cells cells(scope);
  std::map<std::size_t, ExplainScope> scopes;  // of the records that set values
  Json told = Json::array();
  for (const auto& cell : cells.all()) {
    Json origin;
    if (scopes.count(cell.set) != 0 || scopes.size() < most_scopes) {
      auto& turn = scopes.try_emplace(cell.set, scope.run(), cell.set).first->second;
      origin = origin_of(turn, value_of(cell.value), cell.set);
      if (tells_nothing(origin, turn)) origin = made_of_input(turn);
    }
    told.push_back({{"symbol", cell.symbol},
                    {"slot", cell.slot},
                    {"value", cell.value},
                    {"symbols", cell.symbols},
                    {"set", cell.set},
                    {"t", scope.run().entry(cell.set).t.seconds()},
                    {"expression", cells.expression(cell.set, cell.slot)},
                    {"changes", cell.changes},
                    {"read", cell.read ? Json(*cell.read) : Json()},
                    {"origin", std::move(origin)}});
  }
  return told;
}

std::string cell_value(const RunIndex& run, const std::string& cell) {
  const auto dot = cell.find('.');
  if (dot == std::string::npos) return {};
  const auto id = number_in<std::int64_t>(std::string_view(cell).substr(0, dot));
  const auto* place = id ? run.symbol(*id) : nullptr;
  const auto record = place ? run.record(place->n) : Result<Json>(Json());
  return record ? value_of(member_of(member_of(*record, "slots"), cell.substr(dot + 1).c_str())) : std::string();
}

}  // namespace continua
