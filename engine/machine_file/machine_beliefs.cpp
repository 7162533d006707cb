// The belief table of a machine file (FORMAT.md, Beliefs).
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "machine_file/machine_reader.h"

namespace continua {

void MachineReader::read_beliefs(const Item& beliefs) {
  if (!expect_object(beliefs, "beliefs")) return;
  auto& table = machine_.beliefs;
  const auto concepts = required(beliefs, "concepts", "names and what they are, an object");
  if (!expect_object(concepts, "the concepts")) return;
  for (const auto& [name, value] : concepts.json->items()) table.concepts.push_back({name, {}, "", std::nullopt});
  for (auto& entry : table.concepts) read_concept(member(concepts, entry.name), entry);
  if (const auto evidence = member(beliefs, "evidence"); expect_array(evidence, "the evidence"))
    for (std::size_t i = 0; i < evidence.json->size(); ++i) read_evidence(element(evidence, i));
  if (const auto answers = member(beliefs, "answers"); expect_array(answers, "the answers"))
    for (std::size_t i = 0; i < answers.json->size(); ++i) read_answer(element(answers, i));
  table.overheard = number_of(member(beliefs, "overheard"), "a certainty", 0, 0, 1);
}

void MachineReader::read_concept(const Item& item, Concept& entry) {
  if (!expect_object(item, "a concept")) return;
  entry.related = concepts_named(member(item, "related"), "related concepts");
  if (const auto word = member(item, "word"); word.json) {
    entry.word = name_of(word, "a word");
    std::transform(entry.word.begin(), entry.word.end(), entry.word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  }
  if (const auto fixed = member(item, "fixed"); fixed.json) entry.fixed = number_of(fixed, "a certainty", 0, -1, 1);
}

void MachineReader::read_evidence(const Item& item) {
  if (!expect_object(item, "a piece of evidence")) return;
  Evidence entry{read_symbols(required(item, "inputs", "input symbols or sets")), {}, {}};
  entry.concepts = concepts_named(required(item, "concepts", "the concepts that it raises"), "concepts");
  const auto levels = required(item, "levels", "certainties, ascending");
  if (!expect_array(levels, "levels of certainty")) return;
  for (std::size_t i = 0; i < levels.json->size(); ++i)
    entry.levels.push_back(number_of(element(levels, i), "a level", 1, 0, 1));
  if (entry.levels.empty() || !std::is_sorted(entry.levels.begin(), entry.levels.end()))
    problem(levels, "expected one or more levels of certainty, ascending");
  machine_.beliefs.evidence.push_back(std::move(entry));
}

void MachineReader::read_answer(const Item& item) {
  if (!expect_object(item, "an answer")) return;
  Answer entry{std::nullopt, read_symbols(required(item, "inputs", "input symbols or sets")), Term::null(),
               std::nullopt};
  if (const auto when = member(item, "when"); when.json) entry.when = parse(when, Type::truth());
  const auto about = required(item, "about", "a term, the symbol that was asked about");
  if (const auto term = parse(about, Type::text_type())) entry.about = *term;
  const auto set = member(item, "set"), raise = member(item, "raise");
  if (set.json) entry.set = number_of(set, "a certainty", 0, 0, 1);
  if (raise.json && *raise.json != true) mismatch(raise, "true");
  if (!set.json == !raise.json)
    problem(item, fmt::format("found {}, expected one of set, raise", set.json ? "both" : "none"));
  machine_.beliefs.answers.push_back(std::move(entry));
}

std::vector<std::size_t> MachineReader::concepts_named(const Item& list, const char* what) {
  std::vector<std::size_t> concepts;
  if (!expect_array(list, what)) return concepts;
  for (std::size_t i = 0; i < list.json->size(); ++i) concepts.push_back(concept_named(element(list, i)));
  return concepts;
}

std::size_t MachineReader::concept_named(const Item& item) {
  const auto name = name_of(item, "a concept");
  std::vector<std::string> known;
  for (std::size_t i = 0; i < machine_.beliefs.concepts.size(); ++i) {
    if (machine_.beliefs.concepts[i].name == name) return i;
    known.push_back(machine_.beliefs.concepts[i].name);
  }
  if (!name.empty()) problem(item, fmt::format("unknown concept {}{}", in_quotes(name), nearest(name, known)));
  return 0;
}

}  // namespace continua
