#include "continua/language/prospects.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace continua {
namespace {

using Slash = Category::Slash;

constexpr auto nowhere = std::numeric_limits<std::size_t>::max();

// Where phrases of an atom are made, and where they are taken. Positions are those between the words.
struct Trade {
  // of the words that make one
  bool made = false, made_anywhere = false;
  std::size_t last_begin = 0, first_end = nowhere;
  // of the words that take one: from their right, from their left
  bool taken_anywhere = false;
  std::size_t first_taker_end = nowhere, last_taker_begin = 0;
  bool taken_from_left = false;
};

class Market {
 public:
  Market(const std::vector<PlacedSense>& senses, const Lexicon& lexicon)
      : senses_(senses), lexicon_(lexicon), alive_(senses.size(), true) {}

  std::vector<bool> settled() {
    do {
      trades_.clear();
      for (std::size_t i = 0; i < senses_.size(); ++i)
        if (alive_[i]) note(*senses_[i].sense, senses_[i].words);
      note_rules();
    } while (leave_out());
    return std::move(alive_);
  }

 private:
  void note(const WordSense& sense, const WordSpan& words) {
    auto& made = trades_[target(sense.category).name()];
    made.made = true;
    made.last_begin = std::max(made.last_begin, words.begin);
    made.first_end = std::min(made.first_end, words.end);
    for (const auto* part = &sense.category; !part->is_atom(); part = &part->result()) {
      auto& taken = trades_[target(part->argument()).name()];
      if (part->slash() == Slash::forward) {
        taken.first_taker_end = std::min(taken.first_taker_end, words.end);
      } else {
        taken.taken_from_left = true;
        taken.last_taker_begin = std::max(taken.last_taker_begin, words.begin);
      }
      note_given(part->argument());
    }
  }

  // Whoever takes a function gives it the phrases that it needs.
  void note_given(const Category& argument) {
    for (const auto* part = &argument; !part->is_atom(); part = &part->result())
      trades_[target(part->argument()).name()].made_anywhere = true;
  }

  // A rule that has its phrase makes another one, wherever it stands.
  void note_rules() {
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& rule : lexicon_.rules) {
        const auto from = trades_.find(target(rule.from).name());
        if (from == trades_.end() || !(from->second.made || from->second.made_anywhere)) continue;
        from->second.taken_anywhere = true;
        note_given(rule.from);
        auto& made = trades_[target(rule.to).name()];
        grows = grows || !made.made_anywhere;
        made.made_anywhere = true;
        for (const auto* part = &rule.to; !part->is_atom(); part = &part->result()) {
          trades_[target(part->argument()).name()].taken_anywhere = true;
          note_given(part->argument());
        }
      }
    }
  }

  bool leave_out() {
    bool any = false;
    for (std::size_t i = 0; i < senses_.size(); ++i) {
      if (!alive_[i] || (is_taken(senses_[i]) && has_all(senses_[i]))) continue;
      alive_[i] = false;
      any = true;
    }
    return any;
  }

  bool is_taken(const PlacedSense& placed) const {
    const auto name = target(placed.sense->category).name();
    const auto& trade = trades_.find(name)->second;
    return trade.taken_anywhere || trade.first_taker_end <= placed.words.begin ||
           (trade.taken_from_left && trade.last_taker_begin >= placed.words.end) || !atom(name).move.empty();
  }

  bool has_all(const PlacedSense& placed) const {
    for (const auto* part = &placed.sense->category; !part->is_atom(); part = &part->result()) {
      const auto name = target(part->argument()).name();
      const auto& trade = trades_.find(name)->second;
      if (trade.made_anywhere || atom(name).open) continue;
      if (!trade.made) return false;
      const bool there = part->slash() == Slash::forward ? trade.last_begin >= placed.words.end
                                                         : trade.first_end <= placed.words.begin;
      if (!there) return false;
    }
    return true;
  }

  const Atom& atom(Name name) const { return lexicon_.atoms.find(name.text())->second; }

  const std::vector<PlacedSense>& senses_;
  const Lexicon& lexicon_;
  std::vector<bool> alive_;
  std::unordered_map<Name, Trade, Name::Hash> trades_;
};

}  // namespace

std::vector<bool> with_prospects(const std::vector<PlacedSense>& senses, const Lexicon& lexicon) {
  return Market(senses, lexicon).settled();
}

}  // namespace continua
