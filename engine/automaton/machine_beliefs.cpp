// The belief table of a machine file (FORMAT.md, Beliefs).
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "automaton/machine_reader.h"

namespace continua {

void MachineReader::read_beliefs(const Item& beliefs) {
  if (!beliefs.json || !expect_object(beliefs, "beliefs", {"concepts", "evidence", "answers", "overheard", "about"}))
    return;
  auto& table = machine_.beliefs;
  const auto concepts = member(beliefs, "concepts");
  if (!expect_object(concepts, "the concepts")) return;
  for (const auto& [name, value] : concepts.json->items()) table.concepts.push_back({name, {}, "", std::nullopt});
  for (auto& entry : table.concepts) {
    const auto item = member(concepts, entry.name);
    if (!expect_object(item, "a concept", {"related", "word", "fixed", "about"})) continue;
    if (const auto related = member(item, "related"); related.json && expect_array(related, "related concepts"))
      for (std::size_t i = 0; i < related.json->size(); ++i)
        entry.related.push_back(concept_named(element(related, i)));
    if (const auto word = member(item, "word"); word.json) {
      entry.word = text_of(word, "a word");
      std::transform(entry.word.begin(), entry.word.end(), entry.word.begin(),
                     [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    }
    if (const auto fixed = member(item, "fixed"); fixed.json) entry.fixed = number_of(fixed, "a certainty", 0);
  }
  if (const auto evidence = member(beliefs, "evidence"); evidence.json && expect_array(evidence, "the evidence")) {
    for (std::size_t i = 0; i < evidence.json->size(); ++i) {
      const auto item = element(evidence, i);
      if (!expect_object(item, "a piece of evidence", {"inputs", "concepts", "levels", "about"})) continue;
      Evidence entry{read_symbols(member(item, "inputs")), {}, {}};
      if (const auto names = member(item, "concepts"); expect_array(names, "the concepts that it raises"))
        for (std::size_t k = 0; k < names.json->size(); ++k) entry.concepts.push_back(concept_named(element(names, k)));
      if (const auto levels = member(item, "levels"); expect_array(levels, "levels of certainty"))
        for (std::size_t k = 0; k < levels.json->size(); ++k)
          entry.levels.push_back(number_of(element(levels, k), "a level", 1));
      if (entry.levels.empty() || !std::is_sorted(entry.levels.begin(), entry.levels.end()))
        problem(item, "expected one or more levels of certainty, ascending");
      else
        table.evidence.push_back(std::move(entry));
    }
  }
  if (const auto answers = member(beliefs, "answers"); answers.json && expect_array(answers, "the answers")) {
    for (std::size_t i = 0; i < answers.json->size(); ++i) {
      const auto item = element(answers, i);
      if (!expect_object(item, "an answer", {"when", "inputs", "about", "set", "raise"})) continue;
      Answer entry{std::nullopt, read_symbols(member(item, "inputs")), Term::null(), std::nullopt};
      if (const auto when = member(item, "when"); when.json) entry.when = parse(when, Type::truth());
      if (const auto about = parse(member(item, "about"), Type::text_type())) entry.about = *about;
      if (const auto set = member(item, "set"); set.json) entry.set = number_of(set, "a certainty", 0);
      table.answers.push_back(std::move(entry));
    }
  }
  table.overheard = number_of(member(beliefs, "overheard"), "a certainty", 0);
}

std::size_t MachineReader::concept_named(const Item& item) {
  const auto name = text_of(item, "a concept");
  std::vector<std::string> known;
  for (std::size_t i = 0; i < machine_.beliefs.concepts.size(); ++i) {
    if (machine_.beliefs.concepts[i].name == name) return i;
    known.push_back(machine_.beliefs.concepts[i].name);
  }
  problem(item, fmt::format("unknown concept '{}'{}", name, did_you_mean(name, known)));
  return 0;
}

}  // namespace continua
