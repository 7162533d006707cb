#include "continua/replay/explain/explain_headline.h"

#include <algorithm>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/explain/explain_origin.h"
#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/expectation_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

constexpr std::size_t most_named = 3;  // inputs that contributed, besides the one that is answered

std::string kind_of_input(ExplainScope& scope, std::size_t input) {
  return text_of(member_of(scope.record(input), "event"), "kind");
}

// "“Put it there.” (0:01), pointing right [0.1,0.2] (0:02) and 3 more"; samples of pointing as one.
std::string listed(ExplainScope& scope, const std::vector<std::size_t>& inputs) {
  std::vector<std::string> told;
  std::size_t samples = 0;
  for (const auto input : inputs)
    if (kind_of_input(scope, input) == "pointing")
      ++samples;
    else
      told.push_back(told_input(scope, input));
  if (samples == 1)
    told.push_back(told_input(scope, *std::find_if(inputs.begin(), inputs.end(), [&](std::size_t input) {
                                return kind_of_input(scope, input) == "pointing";
                              })));
  if (samples > 1) told.push_back(fmt::format("{} samples of pointing", samples));
  if (told.size() > most_named + 1) {
    const auto more = told.size() - most_named;
    told.resize(most_named);
    told.push_back(fmt::format("{} more", more));
  }
  if (told.size() < 2) return told.empty() ? "" : told.front();
  const auto last = told.back();
  told.pop_back();
  return fmt::format("{} and {}", fmt::join(told, ", "), last);
}

// The turn's input and the inputs that it drew on: "the human said “Yes.” (0:07) after “Take the block.” (0:01)".
std::string due_to(ExplainScope& scope, std::size_t input) {
  const auto kind = kind_of_input(scope, input);
  const auto told = told_input(scope, input);
  auto text = kind == "speech"     ? "the human said " + told
              : kind == "gesture"  ? "the human made the " + told
              : kind == "pointing" ? "the human was " + told
              : kind == "act"      ? "the body reported " + told
                                   : "there was the input " + told;
  std::vector<std::size_t> with, after;
  for (const auto percept : scope.of_turn(input, log::Percept::kind.name))
    for (const auto other : record_numbers(scope.record(percept), "because", percept))
      if (other != input && log::is<log::Input>(scope.run().kind(other))) with.push_back(other);
  for (const auto other : scope.inputs())
    if (other < input && std::find(with.begin(), with.end(), other) == with.end()) after.push_back(other);
  if (!with.empty()) text += " with " + listed(scope, with);
  if (!after.empty()) text += (with.empty() ? " after " : ", after ") + listed(scope, after);
  return text;
}

// Why the turn's words were not enough: the parts that they leave open, or that they mean nothing.
std::string left_open(ExplainScope& scope, std::size_t input) {
  const auto readings = scope.of_turn(input, log::Reading::kind.name);
  if (readings.empty()) return {};
  const Json& reading = scope.record(readings.back());
  const auto& unknown = member_of(reading, "unknown");
  if (unknown.is_array() && !unknown.empty())
    return fmt::format("nobody knows “{}”", alternatives_text(unknown, " and "));
  if (reading.contains("move") && reading["move"].is_null()) return "nothing of it was understood";
  if (const auto& missing = member_of(reading, "missing"); missing.is_array() && !missing.empty()) {
    const auto& first = missing.front();
    if (text_of(first, "why") != "unsaid") return missing_text(scope.words(), first);
    if (const auto gap = scope.words().missing(text_of(first, "type")); !gap.empty()) return gap + " is left unsaid";
    return fmt::format("{} leaves its argument of type {} unsaid", text_of(reading, "meaning"), text_of(first, "type"));
  }
  return {};
}

std::string quoted(const std::string& text) { return "“" + text + "”"; }

// An event of the run without its cause, by the kind of its record: "the avatar asks “Which block?”".
struct Happened {
  const Json& record;
  const RunWords& run_words;

  // "the avatar puts …"; "the avatar does put(…)" where there are no words for it.
  std::string deed(const std::string& term, const char* otherwise) const {
    const auto told = run_words.term(term);
    return fmt::format("{}{}", told == term ? otherwise : "", told);
  }

  // Quoted where there are words for it.
  std::string in_words(const std::string& term) const {
    const auto told = run_words.meaning(term);
    return told == term ? term : "“" + told + "”";
  }

  std::string operator()(const log::Utterance& said) const {
    return fmt::format("the avatar {} {}", said.text.ends_with('?') ? "asks" : "says", quoted(said.text));
  }
  std::string operator()(const log::AvatarGesture& made) const {
    return "the avatar " + deed(made.gesture, "gestures ");
  }
  std::string operator()(const log::Observed& observed) const {
    return "the observed avatar " +
           (observed.channel == "speech" ? "says " + quoted(observed.content) : deed(observed.content, "does "));
  }
  std::string operator()(const log::Act& act) const {
    const auto told = "“" + run_words.term(act.program) + "”";
    if (act.step) return fmt::format("step {} of act {}, {}, is {}", *act.step, act.act, told, act.status);
    if (act.status == "asked") return "the avatar " + deed(act.program, "does ");
    return fmt::format("act {}, {}, is {}", act.act, told, act.status);
  }
  std::string operator()(const log::Transition& fired) const {
    return fmt::format("{} goes to {} by the transition ‘{}’, step {}", fired.from, fired.to, fired.id, fired.step);
  }
  std::string operator()(const log::Correction& corrected) const {
    return fmt::format("what was observed takes the dialogue from {} to {}", corrected.from, corrected.to);
  }
  std::string operator()(const log::Rewrite& rewrite) const {
    return fmt::format("entering {} changes the stack", rewrite.state);
  }
  std::string operator()(const log::Refusal& refusal) const {
    const auto reason = text_of(record, "reason");
    return "the machine refuses an input: " +
           (reason.empty() ? fmt::format("‘{}’ in {}", text_of(record, "input"), refusal.state) : reason);
  }
  std::string operator()(const log::Reading& reading) const {
    const auto words = reading.words.value_or("");
    const auto what = words.empty() ? "what was shown" : quoted(words);
    if (!reading.move || reading.move->empty()) return what + " is not understood";
    auto meaning = reading.meaning.value_or("");
    if (meaning.empty() && reading.referents && !reading.referents->empty())
      meaning = alternatives_text(run_words.each(Json(*reading.referents)));
    return meaning.empty() ? fmt::format("{} is taken as {}", what, *reading.move)
                           : fmt::format("{} is taken to mean {}, as {}", what, in_words(meaning), *reading.move);
  }
  std::string operator()(const log::Input& input) const {
    const bool speech = text_of(input.event, "kind") == "speech";
    return (speech ? "the human says " : "there is the input ") + input_text(run_words, record);
  }
  std::string operator()(const log::Application& made) const {
    return fmt::format("{} is applied to {} and gives {}", made.function, made.argument, made.result);
  }
  std::string operator()(const log::Learned& learned) const {
    const auto name = learned.of == "gesture" ? run_words.gesture(learned.name, "") : learned.name;
    return fmt::format("the avatar learns that the {} “{}” means {}", learned.of, name, in_words(learned.value));
  }
  std::string operator()(const log::Forgotten& forgotten) const {
    const auto name = forgotten.of == "gesture" ? run_words.gesture(forgotten.name, "") : forgotten.name;
    return fmt::format("the avatar forgets the {} “{}”", forgotten.of, name);
  }
  std::string operator()(const log::Memory& memory) const {
    return fmt::format("the register {} becomes {}", memory.register_name, in_words(memory.value));
  }
  std::string operator()(const log::Percept&) const {
    return "an input is attended to: " + brief_in_words(run_words, record);
  }
  std::string operator()(const log::Belief& belief) const {
    return fmt::format("{} is certain to {}, before {}", belief.concept_name, text_of(record, "value"),
                       text_of(record, "was"));
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return fmt::format("there is a record of kind {}: {}", text_of(record, "kind"), brief(record));
  }
};

// In a foreign log, a record may have members of other types than declared.
Happened happened_of(ExplainScope& scope, const Json& record) { return {record, scope.words()}; }
std::string happened(ExplainScope& scope, const Json& record) {
  const auto read = log::read_record(record);
  return std::visit(happened_of(scope, record), read ? *read : log::Record(log::Unknown()));
}

// The consequences of an input, in the order of its turn.
std::string led_to(ExplainScope& scope, std::size_t input) {
  std::vector<std::string> told;
  const auto& run = scope.run();
  std::vector<bool> of_turn(run.size() - input, false);
  of_turn[0] = true;
  for (auto n = input + 1; n < run.size() && told.size() <= most_named; ++n) {
    const auto cause = run.cause(n);
    if (!cause || *cause < input || !of_turn[*cause - input] || log::is<log::Input>(run.kind(n))) continue;
    of_turn[n - input] = true;
    const Json& record = scope.record(n);
    const auto& kind = run.kind(n);
    if (log::is<log::Utterance>(kind)) told.push_back("the avatar says " + quoted(text_of(record, "text")));
    if (log::is<log::AvatarGesture>(kind))
      told.push_back("it " + happened_of(scope, record).deed(text_of(record, "gesture"), "gestures "));
    if (log::is<log::Act>(kind) && text_of(record, "status") == "asked")
      told.push_back("it " + happened_of(scope, record).deed(text_of(record, "program"), "does "));
    if (log::is<log::Refusal>(kind)) told.push_back(fmt::format("{} refuses it", text_of(record, "state")));
    if (log::is<log::Reading>(kind) && !text_of(record, "meaning").empty() && member_of(record, "taken") != false)
      told.push_back("it is taken to mean " + happened_of(scope, record).in_words(text_of(record, "meaning")));
  }
  // A pointing that only came along with another input is bound to that one's words.
  const auto percepts = run.of_kind(log::Percept::kind.name);
  for (auto n = std::upper_bound(percepts.begin(), percepts.end(), input); n != percepts.end() && told.empty(); ++n) {
    const auto drawn_on = record_numbers(scope.record(*n), "because", *n);
    const auto other = scope.input_of(*n);
    if (other && *other != input && std::find(drawn_on.begin(), drawn_on.end(), input) != drawn_on.end())
      told.push_back("it goes with " + told_input(scope, *other));
  }
  return fmt::format("{}", fmt::join(told, "; "));
}

std::string expectation(ExplainScope& scope, const Json& expect) {
  return fmt::format("At {} the expectation of line {} is {}: {}", time_text(scope.run().entry(scope.n()).t.seconds()),
                     text_of(expect, "line"), member_of(expect, "met") == false ? "not met" : "met",
                     differences_text(scope.words(), expect));
}

}  // namespace

std::string headline(ExplainScope& scope, const Json& act) {
  const auto n = scope.n();
  const auto& kind = scope.run().kind(n);
  if (log::is<log::Expect>(kind)) return expectation(scope, scope.record(n)) + ".";
  auto text = fmt::format("At {} {}", time_text(scope.run().entry(n).t.seconds()), happened(scope, scope.record(n)));
  const auto end = [](const std::string& told) {
    return told.ends_with('.') || told.ends_with(".”") || told.ends_with("?”") ? "" : ".";
  };
  if (log::is<log::Input>(kind)) {
    const auto consequences = led_to(scope, n);
    text += consequences.empty() ? "; nothing came of it" : ": " + consequences;
    return text + end(text);
  }
  const auto input = scope.input_of(n);
  if (!input) {
    text += scope.chain().size() > 1 || log::is<log::Transition>(kind) ? ", without any input" : "";
    return text + end(text);
  }
  text += (log::is<log::Refusal>(kind) ? "; " : ", because ") + due_to(scope, *input);
  if (log::is<log::Utterance>(kind) || log::is<log::Refusal>(kind))
    if (const auto open = left_open(scope, *input); !open.empty()) text += ": " + open;
  text += end(text);
  if (log::is<log::Act>(kind)) text += " " + text_of(act, "sentence");
  return text;
}

Json explained_act(ExplainScope& scope, std::size_t n) {
  const auto& run = scope.run();
  if (!log::is<log::Act>(run.kind(n))) return nullptr;
  const auto cause = run.cause(n);
  const auto asked = cause && log::is<log::Act>(run.kind(*cause)) ? *cause : n;
  const Json& first = scope.record(asked);
  Json records = Json::array(), outcome;
  std::size_t ended = asked;
  for (auto at = asked; at < run.size(); ++at) {
    if (at != asked && (run.cause(at) != asked || !log::is<log::Act>(run.kind(at)))) continue;
    const Json& record = scope.record(at);
    records.push_back({{"n", at}, {"t", run.entry(at).t.seconds()}});
    for (const char* part : {"status", "step", "program", "result"}) records.back()[part] = member_of(record, part);
    records.back()["told"] = scope.words().term(text_of(record, "program"));
    if (const auto reason = text_of(member_of(record, "result"), "reason"); !reason.empty())
      records.back()["why"] = scope.words().named(reason);
    const auto status = text_of(record, "status");
    if (record.contains("step") || status == "asked" || status == "started") continue;
    outcome = status;
    ended = at;
  }
  const Json& last = scope.record(ended);
  std::string sentence = "It had not ended when the log ends.";
  if (!outcome.is_null()) {
    const auto status = outcome.get<std::string>();
    const auto t = run.entry(ended).t.seconds();
    const auto& result = member_of(last, "result");
    sentence = status == "done"      ? fmt::format("It was done at {}", time_text(t))
               : status == "stopped" ? fmt::format("It was given up at {}", time_text(t))
                                     : fmt::format("It failed at {}: {}", time_text(t), status);
    if (const auto reason = text_of(result, "reason"); !reason.empty())
      sentence += (status == "done" ? ": " : ", ") + scope.words().named(reason);
    if (const auto& retries = member_of(result, "retries"); retries.is_array() && !retries.empty())
      sentence += fmt::format("; {} had failed before: {}",
                              retries.size() == 1 ? "one attempt" : fmt::format("{} attempts", retries.size()),
                              scope.words().named(alternatives_text(retries, "; ")));
    if (const auto& aside = member_of(result, "moved_aside"); aside.is_array() && !aside.empty())
      sentence += fmt::format("; {} had to make room", alternatives_text(scope.words().each(aside), " and "));
    sentence += ".";
  }
  return {
      {"act", member_of(first, "act")}, {"program", member_of(first, "program")}, {"asked", asked},
      {"records", std::move(records)},  {"outcome", std::move(outcome)},          {"sentence", std::move(sentence)}};
}

}  // namespace continua
