#include "continua/automaton/beliefs.h"

#include <algorithm>
#include <cctype>

namespace continua {

Beliefs::Beliefs(const BeliefTable& table) : table_(&table) {
  for (const auto& entry : table.concepts) certainty_.push_back(entry.fixed.value_or(0));
}

double Beliefs::certainty(std::string_view symbol) const {
  double product = 1;
  for (const auto& evidence : table_->evidence) {
    if (!evidence.inputs.contains(symbol)) continue;
    for (const auto index : evidence.concepts) {
      double best = certainty_[index];
      for (const auto related : table_->concepts[index].related) best = std::max(best, certainty_[related]);
      product *= best;
    }
  }
  return product;
}

std::vector<BeliefChange> Beliefs::raise(std::string_view symbol) {
  std::vector<BeliefChange> changes;
  for (const auto& evidence : table_->evidence) {
    if (!evidence.inputs.contains(symbol)) continue;
    for (const auto index : evidence.concepts) {
      const auto& levels = evidence.levels;
      const auto above =
          std::find_if(levels.begin(), levels.end(), [&](double level) { return level > certainty_[index]; });
      change(index, above == levels.end() ? levels.back() : *above, changes);
    }
  }
  return changes;
}

std::vector<BeliefChange> Beliefs::set(std::string_view symbol, double value) {
  std::vector<BeliefChange> changes;
  for (const auto& evidence : table_->evidence)
    if (evidence.inputs.contains(symbol))
      for (const auto index : evidence.concepts) change(index, value, changes);
  return changes;
}

std::vector<BeliefChange> Beliefs::overhear(std::string_view utterance) {
  std::string lower(utterance);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::vector<BeliefChange> changes;
  for (std::size_t i = 0; i < table_->concepts.size(); ++i) {
    const auto& word = table_->concepts[i].word;
    if (!word.empty() && certainty_[i] >= 0 && certainty_[i] < table_->overheard &&
        lower.find(word) != std::string::npos)
      change(i, table_->overheard, changes);
  }
  return changes;
}

std::vector<BeliefChange> Beliefs::changes_since(const Beliefs& before) const {
  std::vector<BeliefChange> changes;
  for (std::size_t i = 0; i < certainty_.size(); ++i)
    if (certainty_[i] != before.certainty_[i])
      changes.push_back({table_->concepts[i].name, before.certainty_[i], certainty_[i]});
  return changes;
}

Beliefs Beliefs::carried_over(const BeliefTable& table) const {
  Beliefs carried(table);
  for (std::size_t i = 0; i < table.concepts.size(); ++i)
    for (std::size_t was = 0; was < table_->concepts.size(); ++was)
      if (table_->concepts[was].name == table.concepts[i].name && !table.concepts[i].fixed)
        carried.certainty_[i] = certainty_[was];
  return carried;
}

void Beliefs::change(std::size_t concept_index, double value, std::vector<BeliefChange>& changes) {
  const auto& entry = table_->concepts[concept_index];
  if (entry.fixed || certainty_[concept_index] == value) return;
  changes.push_back({entry.name, certainty_[concept_index], value});
  certainty_[concept_index] = value;
}

}  // namespace continua
