#include "continua/replay/explain/explain_text.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/explain/explain_lines.h"
#include "continua/replay/explain/explain_origin.h"
#include "continua/replay/explain/explain_scope.h"
#include "continua/replay/explain/explain_steps.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

constexpr std::size_t few_inputs = 6, few_steps = 8, few_refusals = 3, few_objects = 6, few_symbols = 4;

double number_of(const Json& object, const char* key) {
  const auto& value = member_of(object, key);
  return value.is_number() ? value.get<double>() : 0.0;
}

std::string at(const Json& object, const char* key = "t") { return time_text(number_of(object, key)); }

std::string numbered(const Json& object, const char* key = "n") { return "#" + text_of(object, key); }

const Json& list_of(const Json& object, const char* key) {
  static const Json none = Json::array();
  const auto& list = member_of(object, key);
  return list.is_array() ? list : none;
}

std::string value_text(const Json& value) {
  return value.is_null() ? "nothing" : value.is_string() ? value.get<std::string>() : compact(value);
}

// The member in words, or as it is logged.
std::string told_of(const Json& object, const char* told, const char* logged) {
  return text_of(object, member_of(object, told).is_null() ? logged : told);
}

// "the cup (not plate), the knife (not plate)"
std::string ruled_out_text(const Json& ruled_out, bool all) {
  std::string text;
  std::size_t told = 0;
  for (const auto& one : ruled_out) {
    if (!all && told == few_objects) break;
    text += fmt::format("{}{} ({})", told++ == 0 ? "" : ", ", told_of(one, "told", "object"),
                        told_of(one, "why", "reason"));
  }
  return told < ruled_out.size() ? text + fmt::format(" and {} more", ruled_out.size() - told) : text;
}

// Lays the parts out.
class Teller {
 public:
  Teller(const Json& explained, const ExplainTextOptions& options) : told_(explained), options_(options) {}

  std::string text() {
    out_ = wrapped(text_of(told_, "headline") + "  " + numbered(told_), "", "", options_.width);
    if (options_.colour) out_ = "\x1b[1m" + out_.substr(0, out_.size() - 1) + "\x1b[0m\n";
    for (const auto& one : list_of(told_, "fragile"))
      out_ +=
          line(fmt::format("Fragile: {} was decided by a margin of {} m.", numbered(one), text_of(one, "margin")), "");
    tell_inputs();
    tell_steps();
    tell_stack();
    tell_derivation();
    tell_act();
    tell_consequences();
    if (const auto trouble = text_of(told_, "trouble"); !trouble.empty()) out_ += "\n" + line(trouble, "");
    return out_;
  }

 private:
  std::string line(const std::string& text, const std::string& indent) const {
    return wrapped(text, indent, indent + "  ", options_.width);
  }
  void heading(const std::string& text) {
    out_ += options_.colour ? fmt::format("\n\x1b[1m{}\x1b[0m\n", text) : fmt::format("\n{}\n", text);
  }
  void tell(const std::string& text, int depth = 1) {
    out_ += line(text, std::string(static_cast<std::size_t>(2 * depth), ' '));
  }

  void tell_inputs() {
    const auto& inputs = list_of(told_, "inputs");
    if (inputs.empty()) return;
    heading("What came in");
    const auto left_out = options_.all || inputs.size() <= few_inputs ? 0 : inputs.size() - few_inputs;
    if (left_out > 0) tell(fmt::format("… {} earlier inputs (--all)", left_out));
    for (auto i = left_out; i < inputs.size(); ++i) tell_input(inputs[i]);
  }

  void tell_input(const Json& input) {
    const auto count = number_of(input, "count");
    if (count > 1)
      tell(fmt::format("{} samples of pointing, {} to {}  {}", count, at(input), at(input, "until"), numbered(input)));
    else
      tell(fmt::format("{}  {}  {}", at(input), text_of(input, "told"), numbered(input)));
    for (const auto& percept : list_of(input, "percepts")) tell_percept(percept);
    for (const auto& reading : list_of(input, "readings")) tell_reading(reading);
  }

  void tell_percept(const Json& percept) {
    if (const auto waited = number_of(percept, "waited_s"); waited > 0)
      tell(fmt::format("attended to {} after it began  {}", seconds_text(waited), numbered(percept)), 2);
    for (const auto& bound : list_of(percept, "bound")) {
      const auto& deixis = member_of(bound, "deixis");
      const auto hand = text_of(deixis, "hand");
      const auto from = at(deixis, "from"), until = at(deixis, "until");
      const auto samples = number_of(deixis, "samples"), left_out = number_of(deixis, "left_out");
      tell(fmt::format("“{}” goes with a pointing{} at the place {}, {}{}, {}{}  {}", text_of(bound, "words"),
                       hand.empty() ? "" : " of the " + hand + " hand", told_of(deixis, "told", "place"), from,
                       until == from ? "" : " to " + until,
                       member_of(deixis, "gesture") == true ? std::string("a gesture’s own target")
                       : samples == 1
                           ? std::string("one sample")
                           : fmt::format("{} samples within {:.0f} mm", samples, 1000 * number_of(deixis, "spread_m")),
                       left_out > 0 ? fmt::format(", {} left out", left_out) : "", numbered(percept)),
           2);
    }
  }

  void tell_reading(const Json& reading) {
    const auto move = text_of(reading, "move"), meaning = text_of(reading, "meaning");
    std::string text;
    if (const auto& alternative = member_of(reading, "alternative"); !alternative.is_null())
      text = fmt::format("alternative {}, confidence {}{}: ", compact(alternative), text_of(reading, "confidence"),
                         member_of(reading, "taken") == true ? "" : ", not gone on with");
    const auto& referents = list_of(reading, "referents");
    if (move.empty())
      text += "not understood";
    else if (!meaning.empty())
      text += fmt::format("taken to mean {} : {}, as {}", meaning, text_of(reading, "type"), move);
    else if (reading.contains("referents"))
      text += fmt::format("taken as {}, which can mean {}", move,
                          referents.empty() ? "no object" : alternatives_text(referents));
    else
      text += "taken as " + move;
    tell(text + "  " + numbered(reading), 2);
    if (const auto& shape = member_of(reading, "shape"); shape.is_object()) tell(text_of(shape, "reason"), 3);
    for (const auto& one : list_of(reading, "resolved")) tell_resolved(one);
    if (const auto& ruled_out = list_of(reading, "ruled_out"); !ruled_out.empty())
      tell("not " + ruled_out_text(ruled_out, options_.all), 3);
    for (const auto& one : list_of(reading, "missing"))
      if (text_of(one, "why") == "unsaid" || list_of(reading, "resolved").empty())  // else told with its phrase
        tell(fmt::format("lacks its {}: {}", text_of(one, "type"), missing_text(RunWords::raw(), one)), 3);
    if (const auto& unknown = list_of(reading, "unknown"); !unknown.empty())
      tell(fmt::format("nobody knows “{}”", alternatives_text(unknown, " and ")), 3);
    if (const auto& unused = list_of(reading, "unused"); !unused.empty())
      tell(fmt::format("of no use: “{}”", alternatives_text(unused, " and ")), 3);
    tell_entries(reading);
    tell_parses(reading);
  }

  void tell_resolved(const Json& resolved) {
    const auto words = text_of(resolved, "words"), value = text_of(resolved, "value");
    const auto& named = list_of(resolved, "referents_told");
    const auto& referents = named.empty() ? list_of(resolved, "referents") : named;
    auto text = words.empty() ? text_of(resolved, "phrase") : "“" + words + "”";
    text += value.empty() || value == "null" ? " may be " + alternatives_text(referents)
                                             : " is " + told_of(resolved, "told", "value");
    if ((value.empty() || value == "null") && referents.empty()) text = "“" + words + "” is no object here";
    if (const auto way = way_text(text_of(resolved, "by")); !way.empty()) text += ", " + way;
    if (const auto sides = text_of(resolved, "sides"); !sides.empty())
      text += ", its sides taken in a " + sides + " sense";
    if (const auto& ruled_out = list_of(resolved, "ruled_out"); !ruled_out.empty())
      text += "; not " + ruled_out_text(ruled_out, options_.all);
    tell(text, 3);
  }

  void tell_entries(const Json& reading) {
    std::string text;
    for (const auto& entry : list_of(reading, "entries"))
      if (is_of_reading(entry, reading))
        text += fmt::format("{}“{}” {} {}", text.empty() ? "" : "; ", text_of(entry, "words"),
                            text_of(entry, "category"), text_of(entry, "term"));
    if (!text.empty()) tell("words: " + text, 3);
  }

  void tell_parses(const Json& reading) {
    const auto& parses = list_of(reading, "parses");
    if (parses.size() < 2) return;
    const auto last = static_cast<double>(parses.size() - 1);
    const auto rank = static_cast<std::size_t>(std::clamp(number_of(reading, "rank"), 0.0, last));
    std::string text;
    for (std::size_t i = 0; i < parses.size(); ++i)
      if (i != rank)
        text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", text_of(parses[i], "reading"),
                            text_of(parses[i], "cost"));
    tell(fmt::format("reading {} of {}; the others: {}", rank + 1, parses.size(), text), 3);
  }

  void tell_steps() {
    const auto& steps = list_of(told_, "steps");
    const auto& refused = list_of(told_, "refused");
    if (steps.empty() && refused.empty()) return;
    heading("What was decided");
    const auto left_out = options_.all || steps.size() <= few_steps ? 0 : steps.size() - few_steps;
    if (left_out > 0) tell(fmt::format("… {} earlier transitions (--all)", left_out));
    for (auto i = left_out; i < steps.size(); ++i) tell_step(steps[i]);
    if (!refused.empty()) {
      tell("No transition could take it:");
      tell_refusals(refused);
    }
  }

  void tell_step(const Json& step) {
    const auto input = text_of(step, "input"), condition = text_of(step, "condition");
    tell(fmt::format("{}  {} → {} by ‘{}’, {}, step {}  {}", at(step), text_of(step, "from"), text_of(step, "to"),
                     text_of(step, "id"), input.empty() ? "without input" : "on " + input, text_of(step, "step"),
                     numbered(step)));
    if (!condition.empty()) tell("since " + condition, 2);
    tell(operation_text(member_of(step, "operation")), 2);
    tell_choice(step);
    for (const auto& gate : list_of(step, "gates"))
      tell(fmt::format("the gate of {} {}: {}", text_of(gate, "state"),
                       member_of(gate, "passed") == true ? "lets it in" : "turns it away", text_of(gate, "condition")),
           2);
    tell_refusals(list_of(step, "refused"));
  }

  void tell_choice(const Json& step) {
    const auto& candidates = list_of(step, "candidates");
    if (member_of(step, "forced") == true) tell("forced", 2);
    if (candidates.size() < 2) return;
    const auto policy = text_of(told_, "choice");
    std::string text;
    double total = 0;
    for (const auto& one : candidates) total += number_of(one, "weight");
    for (const auto& one : candidates) {
      text += fmt::format("{}‘{}’ {:.3g} %", text.empty() ? "" : ", ", text_of(one, "id"),
                          100 * number_of(one, "weight") / total);
      if (const auto& alternative = member_of(one, "alternative"); !alternative.is_null())
        text += fmt::format(" (alternative {})", compact(alternative));
    }
    text = fmt::format("chosen{} of {}: {}; probability {:.3g}", policy.empty() ? "" : fmt::format(" ({})", policy),
                       candidates.size(), text, number_of(step, "probability"));
    if (const auto draw = text_of(step, "draw"); !draw.empty()) text += ", drawn " + draw;
    tell(text, 2);
  }

  void tell_refusals(const Json& refused) {
    std::size_t told = 0, left_out = 0;
    for (const auto& group : refused) {
      const auto& ids = list_of(group, "ids");
      if (!options_.all && told == few_refusals) {
        left_out += ids.size();
        continue;
      }
      ++told;
      std::vector<std::string> names;
      for (const auto& id : ids) names.push_back("‘" + value_text(id) + "’");
      tell(fmt::format("not {}: {}", fmt::join(names, ", "), text_of(group, "reason")), 2);
    }
    if (left_out > 0) tell(fmt::format("nor {} other{} (--all)", left_out, left_out == 1 ? "" : "s"), 2);
  }

  void tell_stack() {
    const auto& stack = member_of(told_, "stack");
    const auto& symbols = list_of(stack, "symbols");
    const auto& removed = list_of(stack, "removed");
    if (symbols.empty() && removed.empty()) return;
    const auto symbols_text = [](double count) { return fmt::format("{} symbol{}", count, count == 1 ? "" : "s"); };
    heading(fmt::format("The stack, {} before, {} after, the top first", symbols_text(number_of(stack, "before")),
                        symbols_text(number_of(stack, "after"))));
    std::size_t same = 0, told = 0, more = 0;
    for (const auto& symbol : symbols) {
      if (text_of(symbol, "change") == "same" && told > 0) {
        ++same;
      } else if (!options_.all && told == few_symbols) {
        ++more;
      } else {
        tell_symbol(symbol, told++ == 0);
      }
    }
    if (more > 0) tell(fmt::format("… {} more new or changed (--all)", more));
    if (same > 0) tell(fmt::format("below: {} as before", symbols_text(static_cast<double>(same))));
    for (const auto& symbol : removed)
      tell(fmt::format("- gone: {}  {}", slots_text(symbol), numbered(symbol, "made")));
  }

  // A value of a symbol's slot, in words where the symbol has them.
  static std::string slot_text(const Json& symbol, const Json& value) {
    const auto logged = value_text(value);
    const auto told = text_of(member_of(symbol, "told"), logged.c_str());
    return told.empty() ? logged : told;
  }

  static std::string slots_text(const Json& symbol) {
    const auto& slots = member_of(symbol, "slots");
    std::string text;
    if (slots.is_object())
      for (const auto& [slot, value] : slots.items())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", slot, slot_text(symbol, value));
    return text.empty() ? "an empty symbol" : text;
  }

  void tell_symbol(const Json& symbol, bool top) {
    const auto change = text_of(symbol, "change");
    const char* mark = change == "added" ? "+" : change == "changed" ? "~" : "=";
    const auto& slots = member_of(symbol, "slots");
    const auto& changed = member_of(symbol, "slots_changed");
    tell(fmt::format("{} symbol {}{}  {}", mark, text_of(symbol, "id"),
                     change == "added"     ? ", pushed"
                     : change == "changed" ? ", changed"
                                           : ", as before",
                     numbered(symbol, "made")));
    std::string as_below;
    if (slots.is_object())
      for (const auto& [slot, value] : slots.items()) {
        if (changed.is_object() && changed.contains(slot)) continue;
        if (change == "added" && !top)
          as_below += (as_below.empty() ? "as the one below: " : ", ") + slot;
        else
          tell(fmt::format("  {} {}", slot, slot_text(symbol, value)), 2);
      }
    if (!as_below.empty()) tell("  " + as_below, 2);
    if (!changed.is_object()) return;
    for (const auto& [slot, how] : changed.items()) {
      auto text = fmt::format("* {} {}", slot, slot_text(symbol, member_of(how, "now")));
      if (const auto& was = member_of(how, "was"); !was.is_null() && change == "changed")
        text += ", was " + slot_text(symbol, was);
      std::string by;
      if (const auto& expression = member_of(how, "expression"); !expression.is_null())
        by += " ← " + value_text(expression);
      if (const auto& setter = member_of(how, "by"); !setter.is_null()) by += fmt::format(" (#{})", compact(setter));
      if (const auto& made = member_of(how, "application"); !made.is_null())
        by += fmt::format("; applied in #{}", compact(made));
      else if (const auto from = text_of(member_of(how, "origin"), "text"); !from.empty())
        by += "; from " + from;
      tell(text + by, 2);
    }
  }

  void tell_derivation() {
    const auto tree = explain_tree(told_, options_);
    if (tree.empty()) return;
    heading("Where " + text_of(member_of(told_, "derivation"), "term") + " comes from");
    out_ += tree;
  }

  void tell_act() {
    const auto& act = member_of(told_, "act");
    if (!act.is_object()) return;
    heading(fmt::format("How act {} went", text_of(act, "act")));
    for (const auto& record : list_of(act, "records")) {
      const auto& result = member_of(record, "result");
      const auto step = text_of(record, "step");
      auto text = fmt::format("{}  {}{} {}", at(record), step.empty() ? "" : "step " + step + ", ",
                              told_of(record, "told", "program"), text_of(record, "status"));
      if (const auto reason = text_of(record, "why"); !reason.empty()) text += ": " + reason;
      if (const auto error = number_of(result, "position_error_m"); error > 0)
        text += fmt::format(", {:.1f} mm from what was meant", 1000 * error);
      if (const auto& touches = list_of(result, "touches"); !touches.empty())
        text += ", touches " + alternatives_text(touches, " and ");
      tell(text + "  " + numbered(record));
    }
  }

  void tell_consequences() {
    const auto tell_list = [&](const char* key, const std::string& title) {
      std::string text;
      for (const auto& one : list_of(told_, key)) {
        const auto kind = text_of(one, "kind");
        if (log::is<log::Act>(kind) && log::is<log::Act>(text_of(told_, "kind")))
          continue;  // how it went has been told
        if (!options_.all && (log::is<log::Memory>(kind) || log::is<log::Belief>(kind))) continue;
        text += fmt::format("{}{} {} {}", text.empty() ? "" : "; ", log::is<log::Rewrite>(kind) ? "on entering" : kind,
                            text_of(one, "brief"), numbered(one));
      }
      if (!text.empty()) {
        heading(title);
        tell(text);
      }
    };
    tell_list("brought_about", "What it brought about");
    tell_list("along", "What came along with it");
  }

  const Json& told_;
  const ExplainTextOptions& options_;
  std::string out_;
};

}  // namespace

std::string explain_text(const Json& explained, const ExplainTextOptions& options) {
  return Teller(explained, options).text();
}

}  // namespace continua
