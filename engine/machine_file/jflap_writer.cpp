#include "continua/machine_file/jflap_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <pugixml.hpp>
#include <sstream>
#include <vector>

#include "continua/core/characters.h"
#include "continua/core/located_json.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

using Symbols = std::vector<std::string>;

constexpr const char* bottom = "Z";

// The texts of a term in its notation, `'A'` or `['B', 'A']`; nothing if it is no such term.
std::optional<Symbols> texts_in(const std::string& notation) {
  Symbols texts;
  std::vector<Term> terms;
  for (std::size_t at = notation.find('\''); at < notation.size(); at = notation.find('\'', at + 1)) {
    std::string text;
    for (++at; at < notation.size() && notation[at] != '\''; ++at) {
      if (notation[at] == '\\') ++at;
      if (at < notation.size()) text += notation[at];
    }
    texts.push_back(text);
    terms.push_back(Term::text(text));
  }
  const bool same =
      (terms.size() == 1 && print(terms[0]) == notation) || print(Term::list(terms, Type::text_type())) == notation;
  return same ? std::optional(texts) : std::nullopt;
}

bool is_character(const std::string& text) { return !text.empty() && character_length(text) == text.size(); }

// A transition of the file; of a finite automaton `read` may be a range.
struct Row {
  std::string read, pop, push;
};

class Writer {
 public:
  explicit Writer(const Machine& machine) : machine_(machine), pushdown_(!machine.slots.empty()) {}

  Result<std::string> write() {
    for (const auto part :
         {&Writer::check_slots, &Writer::find_start, &Writer::write_states, &Writer::write_transitions})
      if (auto problem = (this->*part)()) return Error{machine_.name, *problem + "; a JFLAP file has no such thing"};
    std::ostringstream out;
    document_.save(out, " ", pugi::format_indent, pugi::encoding_utf8);
    return out.str();
  }

 private:
  using Problem = std::optional<std::string>;

  Problem check_slots() {
    if (machine_.slots.size() > 1) return "found several slots";
    if (pushdown_ && machine_.slots[0].type != Type::text_type()) return "found a slot that is no text";
    root_ = document_.append_child("structure");
    root_.append_child("type").text() = pushdown_ ? "pda" : "fa";
    root_ = root_.append_child("automaton");
    return std::nullopt;
  }

  // A machine that was read from a file begins in a passing state, which puts Z on the stack.
  Problem find_start() {
    start_ = machine_.start;
    if (!pushdown_ || !machine_.states[start_].passing) return std::nullopt;
    for (const auto& transition : machine_.transitions) {
      if (transition.from != std::vector<StateIndex>{start_}) continue;
      if (transition.on || transition.when || pushed_by(transition, "") != std::optional(Symbols{bottom})) break;
      start_ = transition.to;
      own_bottom_ = true;
      return std::nullopt;
    }
    return fmt::format("found the passing state {}", in_quotes(machine_.states[start_].name));
  }

  bool is_left_out(StateIndex state) const { return own_bottom_ && state == machine_.start; }

  Problem write_states() {
    for (StateIndex i = 0; i < machine_.states.size(); ++i) {
      const auto& state = machine_.states[i];
      if (is_left_out(i)) continue;
      if (state.passing || state.gate || !state.enter.empty())
        return fmt::format("found the state {}, which passes, has a gate or an effect", in_quotes(state.name));
      auto element = root_.append_child("state");
      element.append_attribute("id") = static_cast<unsigned>(i - (own_bottom_ && i > machine_.start));
      element.append_attribute("name") = state.name.c_str();
      if (i == start_) element.append_child("initial");
      if (state.accepting) element.append_child("final");
    }
    return std::nullopt;
  }

  Problem write_transitions() {
    for (const auto& transition : machine_.transitions) {
      if (own_bottom_ && transition.from == std::vector<StateIndex>{machine_.start}) continue;
      if (!transition.effects.empty() || transition.rank != 0 || transition.weight != 1)
        return fmt::format("found the transition {} with effects, a rank or a weight", in_quotes(transition.id));
      std::vector<Row> rows;
      if (auto problem = add_rows(transition, rows)) return problem;
      for (const auto from : transition.from)
        for (const auto& row : rows) write_row(from, row, transition.to);
    }
    return std::nullopt;
  }

  Problem add_rows(const Transition& transition, std::vector<Row>& rows) {
    Symbols read;
    if (transition.on)
      std::copy_if(transition.on->names.begin(), transition.on->names.end(), std::back_inserter(read), is_character);
    if (transition.on && (read.empty() || !transition.on->prefixes.empty()))
      return fmt::format("found the transition {} on {}, which is no character", in_quotes(transition.id),
                         in_quotes(transition.on_text));
    if (!transition.on) read.emplace_back();
    for (const auto& symbol : read) {
      Row row{symbol, "", ""};
      if (auto problem = set_stack(transition, symbol, row)) return problem;
      rows.push_back(row);
    }
    if (!pushdown_ && rows.size() > 1 && is_range(read))
      rows = {{"[" + read.front() + "-" + read.back() + "]", "", ""}};
    return std::nullopt;
  }

  // The symbols that the transition pushes on reading `input`, in the order in which they are put on the stack.
  std::optional<Symbols> pushed_by(const Transition& transition, const std::string& input) const {
    if (transition.operation.kind == Operation::Kind::none || transition.operation.kind == Operation::Kind::pop)
      return Symbols();
    const Json source = Json::parse(transition.operation.source, nullptr, false);
    if (!source.is_object() || source.size() != 1 || !source.front().is_object() || source.front().size() != 1)
      return std::nullopt;
    const auto& term = source.front().front();
    if (!term.is_string()) return std::nullopt;
    if (term == "input" && !input.empty()) return Symbols{input};
    auto symbols = texts_in(term.get<std::string>());
    const bool characters = symbols && std::all_of(symbols->begin(), symbols->end(), is_character);
    return characters ? symbols : std::nullopt;
  }

  // The symbol that must be on top; empty: any.
  std::optional<std::string> top_of(const Transition& transition, const std::string& input) const {
    if (!transition.when) return "";
    const auto when = print(*transition.when), beginning = machine_.slots.empty() ? "" : machine_.slots[0].name + " = ";
    if (beginning.empty() || !when.starts_with(beginning)) return std::nullopt;
    const auto term = when.substr(beginning.size());
    if (term == "input" && !input.empty()) return input;
    if (term == "null" && !own_bottom_) return bottom;
    const auto symbols = texts_in(term);
    const bool one = symbols && symbols->size() == 1 && is_character(symbols->front());
    return one && (own_bottom_ || symbols->front() != bottom) ? std::optional(symbols->front()) : std::nullopt;
  }

  Problem set_stack(const Transition& transition, const std::string& input, Row& row) const {
    using Kind = Operation::Kind;
    const auto kind = transition.operation.kind;
    const auto top = top_of(transition, input);
    const auto pushed = pushed_by(transition, input);
    const bool pops = kind == Kind::pop || kind == Kind::rewrite || kind == Kind::rewrite_each;
    const bool known = kind == Kind::none || kind == Kind::push || kind == Kind::push_each || pops;
    const bool own_z = !own_bottom_ && pushed && std::count(pushed->begin(), pushed->end(), bottom) > 0;
    if (!known || !top || !pushed || own_z || (pops && top->empty()) ||
        (kind == Kind::pop && transition.operation.count != 1) || (pops && !own_bottom_ && *top == bottom))
      return fmt::format("found the transition {} with a condition or an operation of its own",
                         in_quotes(transition.id));
    row.pop = *top;
    for (auto symbol = pushed->rbegin(); symbol != pushed->rend(); ++symbol) row.push += *symbol;
    if (!pops) row.push += *top;
    return std::nullopt;
  }

  static bool is_range(const Symbols& symbols) {
    const auto point = [](const std::string& symbol) { return pugi::as_wide(symbol)[0]; };
    for (std::size_t i = 1; i < symbols.size(); ++i)
      if (point(symbols[i]) != point(symbols[i - 1]) + 1) return false;
    return true;
  }

  void write_row(StateIndex from, const Row& row, StateIndex to) {
    const auto id = [&](StateIndex i) { return static_cast<unsigned>(i - (own_bottom_ && i > machine_.start)); };
    auto element = root_.append_child("transition");
    element.append_child("from").text() = id(from);
    element.append_child("to").text() = id(to);
    element.append_child("read").text() = row.read.c_str();
    if (!pushdown_) return;
    element.append_child("pop").text() = row.pop.c_str();
    element.append_child("push").text() = row.push.c_str();
  }

  const Machine& machine_;
  const bool pushdown_;
  bool own_bottom_ = false;  // Z is a symbol like others; else it stands for the machine's bottom symbol
  StateIndex start_ = 0;
  pugi::xml_document document_;
  pugi::xml_node root_;
};

}  // namespace

Result<std::string> jflap_of(const Machine& machine) { return Writer(machine).write(); }

}  // namespace continua
