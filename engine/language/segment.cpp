#include "continua/language/segment.h"

#include <algorithm>
#include <limits>

#include "continua/language/reduction.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

// Costs of an utterance besides the costs of its readings.
constexpr double cost_of_fragment = 2, cost_of_missing = 1, cost_of_unused = 4;

// Readings that cost more than the cheapest by a larger difference are left out.
constexpr double largest_difference = 0.5;

// The atom of an entry that can stand alone, and the arguments that the entry still lacks.
struct Root {
  const Atom* atom = nullptr;
  std::vector<Type> missing;  // in the order in which its term takes them
};

std::optional<Root> root_of(const Chart::Entry& entry, const Atoms& atoms) {
  if (entry.unary > 0) return std::nullopt;
  Root root;
  const Category* category = &entry.category;
  for (; !category->is_atom(); category = &category->result()) {
    const auto& argument = category->argument();
    if (category->slash() != Category::Slash::forward || !category->composes() || !argument.is_atom())
      return std::nullopt;
    const auto& atom = atoms.find(argument.name().text())->second;
    if (!atom.open) return std::nullopt;
    root.missing.push_back(atom.types.front());
  }
  root.atom = &atoms.find(category->name().text())->second;
  return root.atom->move.empty() ? std::nullopt : std::optional(root);
}

// The term with a lambda for each missing argument.
Term opened(Term term, const std::vector<Type>& missing) {
  const auto count = static_cast<int>(missing.size());
  for (int i = 0; i < count; ++i) {
    const bool is_lambda = term.kind() == Term::Kind::lambda;
    const auto variable = Term::bound(count - 1 - i, missing[static_cast<std::size_t>(i)]);
    term = is_lambda ? instantiate(term.body(), variable) : Term::apply(term, variable);
  }
  term = normal(term);
  for (auto type = missing.rbegin(); type != missing.rend(); ++type) term = Term::lambda("x", *type, term);
  return term;
}

class Segment {
 public:
  Segment(const std::vector<Chart::Word>& words, const std::vector<std::size_t>& positions,
          const Vocabulary& vocabulary)
      : words_(words), positions_(positions), vocabulary_(vocabulary), chart_(words, vocabulary) {}

  void read_into(Utterance& utterance) {
    cover();
    for (std::size_t at = 0; at < words_.size();) {
      const auto& step = best_[at];
      if (step.fragment)
        utterance.fragments.push_back(fragment(at, step.end, utterance.unused));
      else if (step.unused)
        utterance.unused.push_back(positions_[at]);
      else if (step.aside)
        know_all(at, step.end, utterance.unknown);
      at = step.end;
    }
  }

 private:
  struct Step {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t end = 0;
    bool fragment = false, unused = false, aside = false;
  };

  // Finds, from the last word to the first, the cheapest way to cover the words from there on.
  void cover() {
    best_.assign(words_.size() + 1, Step());
    best_.back().cost = 0;
    const auto offer = [&](std::size_t begin, Step step) {
      step.cost += best_[step.end].cost;
      if (step.cost < best_[begin].cost) best_[begin] = step;
    };
    for (std::size_t begin = words_.size(); begin-- > 0;) {
      for (auto end = chart_.last_end(begin); end > begin; --end)
        if (const auto cost = cost_of(begin, end)) offer(begin, {*cost + cost_of_fragment, end, true, false, false});
      for (const auto& [count, cost, known, aside] : chart_.skippable(begin))
        offer(begin, {cost, begin + count, false, !known, aside});
      offer(begin, {is_comma(begin) ? 0 : cost_of_unused, begin + 1, false, !is_comma(begin), false});
    }
  }

  // Unknown words of an aside are not missed.
  void know_all(std::size_t begin, std::size_t end, std::vector<std::size_t>& unknown) const {
    std::erase_if(unknown, [&](std::size_t place) {
      return place >= positions_[begin] && (end == positions_.size() || place <= positions_[end]);
    });
  }

  std::optional<double> cost_of(std::size_t begin, std::size_t end) const {
    std::optional<double> least;
    for (const auto number : chart_.at(begin, end)) {
      const auto& entry = chart_.entry(number);
      const auto root = root_of(entry, vocabulary_.lexicon().atoms);
      if (!root) continue;
      const double cost = entry.cost + cost_of_missing * static_cast<double>(root->missing.size());
      if (!least || cost < *least) least = cost;
    }
    return least;
  }

  // The cheapest readings, all of which lack equally many arguments. Words that the cheapest leaves out go to `unused`.
  Fragment fragment(std::size_t begin, std::size_t end, std::vector<std::size_t>& unused) const {
    struct Found {
      std::size_t number;
      Root root;
    };
    std::vector<Found> found;
    for (const auto number : chart_.at(begin, end))
      if (auto root = root_of(chart_.entry(number), vocabulary_.lexicon().atoms)) found.push_back({number, *root});
    const auto cost_of = [&](const Found& each) {
      return chart_.entry(each.number).cost + cost_of_missing * static_cast<double>(each.root.missing.size());
    };
    const auto cheapest = std::min_element(found.begin(), found.end(),
                                           [&](const Found& a, const Found& b) { return cost_of(a) < cost_of(b); });
    const auto lacking = cheapest->root.missing.size();
    std::erase_if(found, [&](const Found& each) { return each.root.missing.size() != lacking; });
    std::stable_sort(found.begin(), found.end(), [&](const Found& a, const Found& b) {
      return chart_.entry(a.number).cost < chart_.entry(b.number).cost;
    });
    collect_unused(found.front().number, unused);
    Fragment result{span(begin, end), {}};
    for (const auto& each : found) {
      const bool likely =
          chart_.entry(each.number).cost <= chart_.entry(found.front().number).cost + largest_difference;
      if (likely && result.readings.size() < most_readings) add_reading(result.readings, each.number, each.root);
    }
    return result;
  }

  void add_reading(std::vector<Reading>& readings, std::size_t number, const Root& root) const {
    const auto& entry = chart_.entry(number);
    Reading reading;
    reading.term = with_nice_variables(opened(entry.term, root.missing));
    reading.category = entry.category.text();
    reading.move = root.atom->move;
    reading.cost = entry.cost + cost_of_missing * static_cast<double>(root.missing.size());
    const bool known = std::any_of(readings.begin(), readings.end(), [&](const Reading& other) {
      return other.term == reading.term && other.move == reading.move;
    });
    if (known) return;
    collect_phrases(number, reading);
    collect_senses(number, reading);
    std::stable_sort(reading.phrases.begin(), reading.phrases.end(), comes_before);
    std::stable_sort(reading.taken_back.begin(), reading.taken_back.end(), comes_before);
    keep_innermost(reading.phrases);
    readings.push_back(std::move(reading));
  }

  static bool comes_before(const Phrase& a, const Phrase& b) {
    return a.words.begin != b.words.begin ? a.words.begin < b.words.begin : a.words.size() > b.words.size();
  }

  // Of "this, no, that" and "that", which mean the same, the words that say so are kept.
  static void keep_innermost(std::vector<Phrase>& phrases) {
    const auto all = phrases;
    std::erase_if(phrases, [&](const Phrase& outer) {
      return outer.term.type() == Type::entity() && std::any_of(all.begin(), all.end(), [&](const Phrase& inner) {
               return inner.term == outer.term && inner.words.size() < outer.words.size() &&
                      inner.words.begin >= outer.words.begin && inner.words.end <= outer.words.end;
             });
    });
  }

  void collect_phrases(std::size_t number, Reading& reading) const {
    const auto& entry = chart_.entry(number);
    if (entry.rule != Chart::Rule::skip && entry.category.is_atom() &&
        vocabulary_.lexicon().atoms.find(entry.category.name().text())->second.phrase) {
      const auto words = span(entry.words.begin, entry.words.end);
      const bool known = std::any_of(reading.phrases.begin(), reading.phrases.end(), [&](const Phrase& other) {
        return other.words.begin == words.begin && other.words.end == words.end && other.term == entry.term;
      });
      const bool meant = occurs(entry.term, reading.term);
      if (!meant && entry.term.type() == Type::entity()) return collect_taken_back(number, reading);
      if (!known && meant) reading.phrases.push_back({with_nice_variables(entry.term), words});
    }
    if (entry.rule == Chart::Rule::word) return;
    const auto dropped = dropped_argument(entry);
    for (const auto part : {entry.left, entry.right}) {
      if (part == dropped)
        collect_taken_back(part, reading);
      else
        collect_phrases(part, reading);
      if (entry.left == entry.right) break;
    }
  }

  // The argument that its function drops, as that of "no, I mean the plate" drops "the cup"; none if there is none.
  std::optional<std::size_t> dropped_argument(const Chart::Entry& entry) const {
    const bool forward = entry.rule == Chart::Rule::apply_forward;
    if (!forward && entry.rule != Chart::Rule::apply_backward) return std::nullopt;
    const auto& function = chart_.entry(forward ? entry.left : entry.right).term;
    if (function.kind() != Term::Kind::lambda || !function.body().closed()) return std::nullopt;
    return forward ? entry.right : entry.left;
  }

  // Things such as "this cup" in "this cup, I mean that plate", and their nouns: a pointing may be theirs, and a "one"
  // that follows may mean the noun.
  void collect_taken_back(std::size_t number, Reading& reading) const {
    const auto& entry = chart_.entry(number);
    const bool is_noun = entry.category.is_atom() && entry.term.type() == property();
    const bool is_thing = entry.category.is_atom() && entry.term.type() == Type::entity();
    if (entry.rule != Chart::Rule::skip && (is_noun || is_thing))
      reading.taken_back.push_back({with_nice_variables(entry.term), span(entry.words.begin, entry.words.end)});
    if (is_noun) return;
    if (entry.rule == Chart::Rule::word) return;
    collect_taken_back(entry.left, reading);
    if (entry.right != entry.left) collect_taken_back(entry.right, reading);
  }

  void collect_senses(std::size_t number, Reading& reading) const {
    const auto& entry = chart_.entry(number);
    if (entry.rule == Chart::Rule::word) {
      const auto words = text_of(entry.words);
      return reading.senses.push_back({words, entry.category.text(), with_nice_variables(entry.term), entry.cost});
    }
    collect_senses(entry.left, reading);
    if (entry.right != entry.left) collect_senses(entry.right, reading);
    if (entry.rule == Chart::Rule::unary) reading.rules.push_back(entry.changed_by->name);
    if (entry.rule != Chart::Rule::skip) return;
    const auto& passed_by = chart_.entry(entry.left);
    const WordSpan passed{passed_by.words.end, entry.words.end};
    for (const auto& skippable : chart_.skippable(passed.begin))
      if (skippable.known && skippable.count == passed.size())
        return reading.senses.push_back({text_of(passed), "", Term::null(), skippable.cost});
  }

  std::string text_of(const WordSpan& span) const {
    std::string words;
    for (auto at = span.begin; at < span.end; ++at) words += (words.empty() ? "" : " ") + words_[at].text;
    return words;
  }

  void collect_unused(std::size_t number, std::vector<std::size_t>& unused) const {
    const auto& entry = chart_.entry(number);
    if (entry.rule == Chart::Rule::word) return;
    collect_unused(entry.left, unused);
    if (entry.right != entry.left) collect_unused(entry.right, unused);
    if (entry.rule != Chart::Rule::skip) return;
    const auto passed = chart_.entry(entry.left).words.end;
    for (const auto& skippable : chart_.skippable(passed))
      if (passed + skippable.count == entry.words.end) {
        if (!skippable.known) unused.push_back(positions_[passed]);
        return;
      }
  }

  bool is_comma(std::size_t at) const { return words_[at].text == ","; }

  // The span of the utterance's words for words [begin, end) of the segment, without commas at its ends.
  WordSpan span(std::size_t begin, std::size_t end) const {
    while (end > begin + 1 && is_comma(end - 1)) --end;
    while (end > begin + 1 && is_comma(begin)) ++begin;  // its position is that of the word before it
    return {positions_[begin], positions_[end - 1] + 1};
  }

  const std::vector<Chart::Word>& words_;
  const std::vector<std::size_t>& positions_;
  const Vocabulary& vocabulary_;
  Chart chart_;
  std::vector<Step> best_;
};

}  // namespace

void read_segment(const std::vector<Chart::Word>& words, const std::vector<std::size_t>& positions,
                  const Vocabulary& vocabulary, Utterance& utterance) {
  Segment(words, positions, vocabulary).read_into(utterance);
}

}  // namespace continua
