#include "continua/replay/export/run_dialogue.h"

#include <optional>

#include <fmt/format.h>

#include "continua/replay/log/brief_in_words.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

struct Told {
  std::string who, how, what;
};

std::optional<Told> of_input(const RunWords& words, const Json& record) {
  const auto kind = text_of(member_of(record, "event"), "kind");
  if (kind == "speech") return Told{"human", "says", brief(record)};
  if (kind == "gesture") return Told{"human", "shows", input_text(words, record).substr(kind.size() + 1)};
  return std::nullopt;
}

// "“takes the red block”", or the term where there are no words for it.
std::string deed(const RunWords& words, const std::string& program) {
  const auto told = words.term(program);
  return told == program ? told : "“" + told + "”";
}

std::optional<Told> of_act(const RunWords& words, const Json& record) {
  if (record.contains("step")) return std::nullopt;
  const auto status = text_of(record, "status"), program = deed(words, text_of(record, "program"));
  if (status == "asked") return Told{"avatar", "does", program};
  if (status == "started" || status == "done") return std::nullopt;
  const auto reason = text_of(member_of(record, "result"), "reason");
  return Told{"avatar", "did not", fmt::format("{}: {}{}{}", program, status, reason.empty() ? "" : ", ", reason)};
}

// Refusals of the human's events; pointing samples are refused by the hundred, and left out.
std::optional<Told> of_refusal(const RunIndex& run, const RunWords& words, std::size_t n, const Json& record) {
  const auto cause = run.cause(n);
  if (cause && log::is<log::Input>(run.kind(*cause))) {
    const auto input = run.record(*cause);
    if (input && !of_input(words, *input)) return std::nullopt;
  }
  return Told{"avatar", "did not take", brief(record)};
}

std::optional<Told> told(const RunIndex& run, const RunWords& words, std::size_t n, const Json& record) {
  const auto& kind = run.kind(n);
  if (log::is<log::Input>(kind)) return of_input(words, record);
  if (log::is<log::Utterance>(kind)) return Told{"avatar", "says", brief(record)};
  if (log::is<log::AvatarGesture>(kind)) return Told{"avatar", "shows", brief_in_words(words, record)};
  if (log::is<log::Act>(kind)) return of_act(words, record);
  if (log::is<log::Refusal>(kind)) return of_refusal(run, words, n, record);
  if (log::is<log::Expect>(kind) && member_of(record, "met") == false)
    return Told{"expectation", "is", brief_in_words(words, record)};
  return std::nullopt;
}

bool may_tell(const std::string& kind) {
  for (const char* telling : {"input", "utterance", "gesture", "act", "refusal", "expect"})
    if (kind == telling) return true;
  return false;
}

}  // namespace

std::vector<DialogueLine> dialogue_of(const RunIndex& run) {
  const RunWords words(run);
  std::vector<DialogueLine> lines;
  for (std::size_t n = 0; n < run.size(); ++n) {
    if (!may_tell(run.kind(n))) continue;
    const auto record = run.record(n);
    if (!record) continue;
    if (auto line = told(run, words, n, *record))
      lines.push_back({n, run.entry(n).t, std::move(line->who), std::move(line->how), std::move(line->what)});
  }
  return lines;
}

}  // namespace continua
