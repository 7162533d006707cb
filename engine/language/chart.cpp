#include "continua/language/chart.h"

#include <algorithm>

#include "continua/language/reduction.h"

namespace continua {
namespace {

using Slash = Category::Slash;

// Costs per word of an argument: short arguments are likelier than long ones. A modifier before its argument costs
// nothing, because "leftmost" is said of all that follows. A modifier after an atom costs most, because "behind the
// cup" is said of the noun just before rather than of a longer phrase.
constexpr double cost_per_word = 0.01, cost_per_word_before = 0.001, cost_per_word_modified = 0.05;
// Costs of passing over words inside a phrase, and of leaving out a word that has lost the word it belonged to.
constexpr double cost_of_passing = 0.1, cost_of_lost = 1.5;
constexpr int most_unary = 2;

bool is_modifier(const Category& category) { return category.argument() == category.result(); }

double cost_of(const Category& function, std::size_t words) {
  if (function.slash() == Slash::backward)
    return (is_modifier(function) && function.argument().is_atom() ? cost_per_word_modified : cost_per_word_before) *
           static_cast<double>(words);
  return is_modifier(function) ? 0 : cost_per_word * static_cast<double>(words);
}

bool is_function(const Category& category, Slash slash) { return !category.is_atom() && category.slash() == slash; }

}  // namespace

Chart::Chart(const std::vector<Word>& words, const Vocabulary& vocabulary)
    : vocabulary_(vocabulary), lexicon_(vocabulary.lexicon()) {
  look_up(words);
  const auto count = words.size();
  cells_.resize(count);
  for (std::size_t begin = 0; begin < count; ++begin) cells_[begin].resize(std::min(longest_span, count - begin));
  for (std::size_t end = 1; end <= count; ++end)
    for (std::size_t size = 1; size <= std::min(longest_span, end); ++size) fill(end - size, end);
}

const std::vector<std::size_t>& Chart::at(std::size_t begin, std::size_t end) const {
  return cells_[begin][end - begin - 1];
}

void Chart::look_up(const std::vector<Word>& words) {
  std::vector<PlacedSense> senses;
  const auto add = [&](const WordEntry& entry, WordSpan span) {
    for (const auto& sense : entry.senses) senses.push_back({span, &sense});
  };
  words_.resize(words.size());
  skippable_.resize(words.size());
  for (std::size_t begin = 0; begin < words.size(); ++begin) {
    Vocabulary::Walk walk(vocabulary_);
    for (std::size_t count = 1; begin + count <= words.size() && !walk.is_over(); ++count) {
      words_[begin].push_back({});
      if (count == 1) add(words[begin].name, {begin, begin + 1});
      std::optional<double> skip, aside;
      for (const auto* entry : walk.step(words[begin + count - 1].text)) {
        add(*entry, {begin, begin + count});
        if (entry->skip) skip = entry->skip;
        if (entry->aside) aside = entry->aside;
      }
      if (skip) skippable_[begin].push_back({count, *skip});
      if (aside) add_aside(words, begin, count, *aside);
    }
    if (words[begin].before_unknown) skippable_[begin].push_back({1, cost_of_lost, false});
  }
  keep(senses);
}

void Chart::keep(const std::vector<PlacedSense>& senses) {
  const auto kept = with_prospects(senses, lexicon_);
  for (std::size_t i = 0; i < senses.size(); ++i)
    if (kept[i]) words_[senses[i].words.begin][senses[i].words.size() - 1].push_back(senses[i].sense);
}

// An aside goes on to the next comma, or to the end; nothing but an aside is no utterance.
void Chart::add_aside(const std::vector<Word>& words, std::size_t begin, std::size_t opening, double cost) {
  auto end = begin + opening;
  while (end < words.size() && words[end].text != ",") ++end;
  if (begin > 0 || end < words.size()) skippable_[begin].push_back({end - begin, cost, true, true});
}

void Chart::fill(std::size_t begin, std::size_t end) {
  span_ = {begin, end};
  cell_ = &cells_[begin][end - begin - 1];
  candidates_.clear();
  if (end - begin <= words_[begin].size())
    for (const auto* sense : words_[begin][end - begin - 1])
      candidates_.push_back({sense->category, sense->cost, Rule::word, 0, 0, &sense->term});
  for (std::size_t middle = begin + 1; middle < end; ++middle) {
    const auto &lefts = at(begin, middle), &rights = at(middle, end);
    for (const auto left : lefts)
      for (const auto right : rights) combine(left, right);
    for (const auto& [count, cost, known, aside] : skippable_[middle])
      if (middle + count == end && !aside && (cost == 0 || !known))
        for (const auto left : lefts)
          candidates_.push_back(
              {entries_[left].category, entries_[left].cost + cost + cost_of_passing, Rule::skip, left, left});
  }
  add_candidates();
  change_categories();
}

void Chart::combine(std::size_t left, std::size_t right) {
  const bool takes_right = signs_[left].wanted == signs_[right].made;
  const bool takes_left = signs_[right].wanted == signs_[left].made;
  if (!takes_right && !takes_left) return;
  const auto &a = entries_[left], &b = entries_[right];
  const auto &x = a.category, &y = b.category;
  const auto add = [&](Category category, Rule rule, const Entry& function) {
    const auto words = (&function == &a ? b : a).words.size();
    candidates_.push_back(
        {std::move(category), a.cost + b.cost + cost_of(function.category, words), rule, left, right});
  };
  if (takes_right && is_function(x, Slash::forward) && a.rule != Rule::compose_forward) {
    if (Agreement agreement; agreement.agree(x.argument(), y))
      add(agreement.settled_one(x.result()), Rule::apply_forward, a);
    if (x.composes() && is_function(y, Slash::forward) && y.composes())
      if (Agreement agreement; agreement.agree(x.argument(), y.result()))
        add(Category::function(agreement.settled_one(x.result()), Slash::forward,
                               agreement.settled_other(y.argument())),
            Rule::compose_forward, a);
  }
  if (takes_left && is_function(y, Slash::backward) && b.rule != Rule::compose_backward) {
    if (Agreement agreement; agreement.agree(y.argument(), x))
      add(agreement.settled_one(y.result()), Rule::apply_backward, b);
    if (y.composes() && is_function(x, Slash::backward) && x.composes())
      if (Agreement agreement; agreement.agree(y.argument(), x.result()))
        add(Category::function(agreement.settled_one(y.result()), Slash::backward,
                               agreement.settled_other(x.argument())),
            Rule::compose_backward, b);
  }
}

Term Chart::term_of(const Candidate& candidate) const {
  if (candidate.rule == Rule::word) return *candidate.word;
  const auto &left = entries_[candidate.left].term, &right = entries_[candidate.right].term;
  switch (candidate.rule) {
    case Rule::apply_forward:
      return applied(left, right);
    case Rule::apply_backward:
      return applied(right, left);
    case Rule::compose_forward:
      return composed(left, right, type_of(candidate.category.argument(), lexicon_.atoms));
    case Rule::compose_backward:
      return composed(right, left, type_of(candidate.category.argument(), lexicon_.atoms));
    default:
      return left;
  }
}

void Chart::add_candidates() {
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  for (const auto& candidate : candidates_) {
    if (cell_->size() >= most_entries) return;
    const auto of_category = std::count_if(cell_->begin(), cell_->end(), [&](std::size_t number) {
      return entries_[number].category == candidate.category;
    });
    if (static_cast<std::size_t>(of_category) >= most_of_category) continue;
    const int unary = candidate.rule == Rule::skip ? entries_[candidate.left].unary : 0;
    add({candidate.category, term_of(candidate), candidate.cost, span_, candidate.rule, candidate.left, candidate.right,
         unary});
  }
}

bool Chart::add(Entry entry) {
  if (entry.term.is_null()) return false;
  for (const auto number : *cell_)
    if (entries_[number].category == entry.category && entries_[number].term == entry.term) return false;
  cell_->push_back(entries_.size());
  const auto made = entry.category.target();
  signs_.push_back({made, entry.category.is_atom() ? made : entry.category.argument().target()});
  entries_.push_back(std::move(entry));
  return true;
}

void Chart::change_categories() {
  for (std::size_t i = 0; i < cell_->size() && cell_->size() < 2 * most_entries; ++i) {
    const auto number = (*cell_)[i];
    if (entries_[number].unary >= most_unary) continue;
    for (const auto& rule : lexicon_.rules) {
      if (rule.from.target() != signs_[number].made) continue;
      const auto& from = entries_[number];
      Agreement agreement;
      if (!agreement.agree(rule.from, from.category)) continue;
      add({agreement.settled_one(rule.to), applied(rule.term, from.term), from.cost + rule.cost, span_, Rule::unary,
           number, number, from.unary + 1, &rule});
    }
  }
}

}  // namespace continua
