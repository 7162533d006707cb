#include "continua/replay/diff/run_diff_words.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/expectation_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/time_text.h"

namespace continua {
namespace {

// Of a run's record the event is a member, of a trace's line it is the line.
Json event_of(const Json& record) {
  const auto& event = member_of(record, "event");
  return event.is_object() ? event : record;
}

double time_of(const Json& record) {
  const auto& t = member_of(record, "t");
  return t.is_number() ? t.get<double>() : 0;
}

std::string place_of(const Json& record) { return time_text(time_of(record)); }

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

// " (plate → cup)" of texts that share words around their difference.
std::string changed_words(const std::string& a, const std::string& b) {
  auto one = words_of(a), other = words_of(b);
  const auto before =
      static_cast<std::size_t>(std::mismatch(one.begin(), one.end(), other.begin(), other.end()).first - one.begin());
  std::size_t after = 0;
  while (before + after < std::min(one.size(), other.size()) &&
         one[one.size() - 1 - after] == other[other.size() - 1 - after])
    ++after;
  if (before + after == 0) return {};
  const auto part = [&](const std::vector<std::string>& words) {
    const std::vector<std::string> changed(words.begin() + static_cast<std::ptrdiff_t>(before),
                                           words.end() - static_cast<std::ptrdiff_t>(after));
    auto text = fmt::format("{}", fmt::join(changed, " "));
    while (!text.empty() && std::string_view(".,!?;:").find(text.back()) != std::string_view::npos) text.pop_back();
    return text.empty() ? "nothing" : text;
  };
  return fmt::format(" ({} → {})", part(one), part(other));
}

std::string value_text(const Json& value) {
  if (value.is_null()) return "none";
  return value.is_string() ? value.get<std::string>() : compact(value);
}

// Of a member of an event: a place and the name of a gesture or a thing in words.
std::string value_text(const RunWords& words, const std::string& of, const Json& value) {
  if (of == "name") return words.gesture(value_text(value), "");
  if (of != "target") return value_text(value);
  if (!value.is_array()) return words.thing(value_text(value));
  std::vector<std::string> numbers;
  for (const auto& number : value) numbers.push_back(compact(number));
  return words.term(fmt::format("<{}>", fmt::join(numbers, ", ")));
}

RootCause changed_in_words(const RunWords& words, const Json& a, const Json& b) {
  const auto one = event_of(a), other = event_of(b);
  RootCause cause{"input", event_words(words, a), one, other, ""};
  const auto text_a = text_of(one, "text"), text_b = text_of(other, "text");
  if (text_a != text_b) {
    cause.sentence = fmt::format("at {} A has {}, B {}{}", place_of(a), event_words(words, a), event_words(words, b),
                                 changed_words(text_a, text_b));
    return cause;
  }
  std::vector<std::string> fields;
  for (const auto& difference : document_differences("input", one, other))
    if (difference.what != "t" && difference.what != "row" && difference.what != "n" && difference.what != "line")
      fields.push_back(fmt::format("{} {} in A, {} in B", difference.what,
                                   value_text(words, difference.what, difference.a),
                                   value_text(words, difference.what, difference.b)));
  cause.sentence = fmt::format("{} at {}: {}", event_words(words, a), place_of(a), fmt::join(fields, "; "));
  return cause;
}

// "A goes from Ask to Compose by 'thing told', B to Done by 'act'".
std::string transitions_in_words(const Json& a, const Json& b) {
  const auto step = [](const Json& one) {
    return fmt::format("takes '{}' to {}", text_of(one, "id"), text_of(one, "to"));
  };
  if (text_of(a, "from") == text_of(b, "from"))
    return fmt::format("in state {} A {}, B {}", text_of(a, "from"), step(a), step(b));
  return fmt::format("A in state {} {}, B in state {} {}", text_of(a, "from"), step(a), text_of(b, "from"), step(b));
}

bool same_step(const Json& a, const Json& b) {
  for (const char* key : {"id", "from", "to"})
    if (text_of(a, key) != text_of(b, key)) return false;
  return true;
}

// The words of the two runs, whose scenes may differ.
struct BothWords {
  RunWords a, b;
};

std::string brief_of(const RunWords& words, const Json& record) {
  return fmt::format("{} {}", text_of(record, "kind"), brief_in_words(words, record));
}

// Which numbers decided the same step otherwise.
std::string decided_in_words(const BothWords& words, const Json& a, const Json& b) {
  for (const char* key : {"weight", "forced", "draw", "operation", "gates", "refused", "candidates", "probability",
                          "depth", "parses", "unknown", "unused", "found", "reason", "confidence", "types", "rule"})
    if (const auto& one = member_of(a, key), &other = member_of(b, key); one != other) {
      const auto subject = log::is<log::Transition>(text_of(a, "kind"))
                               ? fmt::format("transition '{}'", text_of(a, "id"))
                               : brief_of(words.a, a);
      const auto was = value_text(one), is = value_text(other);
      if (was.size() + is.size() > 120) return fmt::format("{} is the same, with other {}", subject, key);
      return fmt::format("{} is the same, with {} {} in A, {} in B", subject, key, was, is);
    }
  return fmt::format("{} is decided otherwise", text_of(a, "kind"));
}

std::string happened_in_words(const BothWords& words, const Json& a, const Json& b) {
  if (a.is_null()) return fmt::format("only B has: {}", brief_of(words.b, b));
  if (b.is_null()) return fmt::format("only A has: {}", brief_of(words.a, a));
  const auto kind = text_of(a, "kind");
  if (kind != text_of(b, "kind")) return fmt::format("A has {}, B {}", brief_of(words.a, a), brief_of(words.b, b));
  const auto one = brief_in_words(words.a, a), other = brief_in_words(words.b, b);
  if (log::is<log::Reading>(kind)) return fmt::format("“{}” means {} in A, {} in B", text_of(a, "words"), one, other);
  if (log::is<log::Utterance>(kind)) return fmt::format("A says {}, B {}", one, other);
  return fmt::format("{} {} in A, {} in B", kind, one, other);
}

std::string how(const RunIndex& run_a, const RunIndex& run_b, const RunDiff& diff, const Json& a, const Json& b,
                const Json& transition_a, const Json& transition_b) {
  const auto& first = diff.differences[diff.first];
  const BothWords words{RunWords(run_a), RunWords(run_b)};
  switch (first.kind) {
    case RunDifference::Kind::input:
      return input_cause(run_a, run_b, first).sentence;
    case RunDifference::Kind::decided:
      return decided_in_words(words, a, b);
    case RunDifference::Kind::timing:
      return fmt::format("{} comes at {} in A, at {} in B", brief_of(words.a, a), place_of(a), place_of(b));
    case RunDifference::Kind::outcome:
      return fmt::format("“{}” is {} in A, {} in B", words.a.term(text_of(a, "program")), text_of(a, "status"),
                         text_of(b, "status"));
    case RunDifference::Kind::poses:
      return fmt::format("{} is elsewhere, up to {:.1f} mm from where it is in the other run",
                         words.a.thing(diff.farthest), 1000 * diff.largest_distance_m);
    case RunDifference::Kind::happened:
      break;
  }
  const bool stepped = !transition_a.is_null() && !transition_b.is_null();
  if (stepped && !same_step(transition_a, transition_b) && !log::is<log::Reading>(text_of(a, "kind")))
    return transitions_in_words(transition_a, transition_b);
  return happened_in_words(words, a, b);
}

std::string effect(const RunIndex& a, const RunIndex& b, const RunDiff& diff) {
  const auto more = diff.count - 1;
  if (more == 0 && diff.differences[diff.first].kind != RunDifference::Kind::happened) return "Nothing else differs.";
  if (more > 0 && diff.count <= diff.differences.size()) {
    const bool timing = std::all_of(diff.differences.begin(), diff.differences.end(), [](const RunDifference& one) {
      return one.kind == RunDifference::Kind::timing || (one.input && (one.input->kind == EventChange::Kind::moved));
    });
    if (timing) return "Only times differ.";
  }
  std::string text =
      more == 0 ? "Nothing else differs." : fmt::format("{} more difference{}.", more, more == 1 ? "" : "s");
  if (!diff.meet) return text + " They do not meet again.";
  const auto [in_a, in_b] = *diff.meet;
  const auto t_a = time_text(a.entry(in_a).t.seconds()), t_b = time_text(b.entry(in_b).t.seconds());
  if (t_a == t_b) return fmt::format("{} They meet again at {} (A #{}, B #{}).", text, t_a, in_a, in_b);
  return fmt::format("{} They meet again at {} in A (#{}), at {} in B (#{}).", text, t_a, in_a, t_b, in_b);
}

std::string numbers(const RunDifference& first) {
  std::string text;
  for (const auto& [name, records] : {std::pair("A", &first.a), std::pair("B", &first.b)})
    if (!records->empty()) text += fmt::format("{}{} #{}", text.empty() ? "" : ", ", name, records->front());
  return text.empty() ? text : " (" + text + ")";
}

}  // namespace

std::string event_words(const RunWords& words, const Json& record) {
  const auto event = event_of(record);
  const auto kind = text_of(event, "kind");
  if (kind == "expect") {
    Json fields = event;
    for (const char* key : {"kind", "n", "t", "line", "met", "found", "expected"}) fields.erase(key);
    return fmt::format("the expectation ({})",
                       wanted_text(words, event.contains("expected") ? event["expected"] : fields));
  }
  if (kind == "observed") return "observed " + brief_in_words(words, event);
  return input_text(words, {{"kind", "input"}, {"event", event}});
}

RootCause change_in_words(const RunWords& words, EventChange::Kind kind, const Json& a, const Json& b,
                          const Json& other_a) {
  using Kind = EventChange::Kind;
  if (kind == Kind::changed) return changed_in_words(words, a, b);
  RootCause cause{"input", event_words(words, a.is_null() ? b : a), a.is_null() ? Json() : event_of(a),
                  b.is_null() ? Json() : event_of(b), ""};
  const auto kind_of = [](const Json& record) { return text_of(event_of(record), "kind"); };
  if (kind == Kind::dropped)
    cause.sentence = fmt::format("{} ({} at {}) is left out in B", cause.what, kind_of(a), place_of(a));
  if (kind == Kind::added)
    cause.sentence = fmt::format("{} ({} at {}) is only in B", cause.what, kind_of(b), place_of(b));
  if (kind == Kind::moved)
    cause.sentence =
        time_of(a) == time_of(b)
            ? fmt::format("{} ({} at {}) comes in another order", cause.what, kind_of(a), place_of(a))
            : fmt::format("{} ({}) comes at {} in A, at {} in B", cause.what, kind_of(a), place_of(a), place_of(b));
  if (kind == Kind::swapped)
    cause.sentence = fmt::format("{} (at {} in A) and {} (at {}) change places", cause.what, place_of(a),
                                 event_words(words, other_a), place_of(other_a));
  return cause;
}

RootCause input_cause(const RunIndex& a, const RunIndex& b, const RunDifference& difference) {
  const auto& input = *difference.input;
  const auto record = [](const RunIndex& run, const std::optional<std::size_t>& n) {
    const auto read = n ? run.record(*n) : Result<Json>(Json());
    return read ? *read : Json();
  };
  const auto other = input.other ? std::optional(input.other->first) : std::nullopt;
  return change_in_words(RunWords(a), input.kind, record(a, input.a), record(b, input.b), record(a, other));
}

std::string sentence_of(const RunIndex& a, const RunIndex& b, const RunDiff& diff, const Json& transition_a,
                        const Json& transition_b) {
  const auto& first = diff.differences[diff.first];
  const auto record = [](const RunIndex& run, const std::vector<std::size_t>& records) {
    const auto read = records.empty() ? Result<Json>(Json()) : run.record(records.front());
    return read ? *read : Json();
  };
  const auto one = record(a, first.a), other = record(b, first.b);
  std::string text =
      diff.sameness == RunDiff::Sameness::unrelated
          ? fmt::format("The runs are unrelated: {} of {} and {} inputs are common. They part at {}{}: {}.",
                        diff.inputs_common, diff.inputs_a, diff.inputs_b, time_text(first.t.seconds()), numbers(first),
                        how(a, b, diff, one, other, transition_a, transition_b))
          : fmt::format("They part at {}{}: {}.", time_text(first.t.seconds()), numbers(first),
                        how(a, b, diff, one, other, transition_a, transition_b));
  if (!first.input || diff.cause.kind == "cut short") {
    const auto& cause = diff.cause;
    const bool tells_kind = cause.sentence.starts_with(cause.kind + ":");
    text += fmt::format(" Cause{}: {}.", tells_kind ? "" : fmt::format(" ({})", cause.kind), cause.sentence);
  }
  return diff.sameness == RunDiff::Sameness::unrelated ? text : text + " " + effect(a, b, diff);
}

}  // namespace continua
