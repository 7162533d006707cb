#include "continua/language/prospects.h"

#include <algorithm>
#include <limits>

namespace continua {
namespace {

using Slash = Category::Slash;

constexpr auto nowhere = std::numeric_limits<std::size_t>::max();

// Calls `note(argument, to the right)` for each argument of a category.
void for_each_argument(const Category& category, const auto& note) {
  for (const auto* part = &category; !part->is_atom(); part = &part->result())
    note(part->argument(), part->slash() == Slash::forward);
}

// Where phrases of an atom are made, and where they are taken. Positions are those between the words.
struct Trade {
  bool made = false, made_anywhere = false;
  std::size_t last_begin = 0, first_end = nowhere;  // of the words that make one
  bool taken_anywhere = false, taken_from_left = false;
  std::size_t first_taker_end = nowhere, last_taker_begin = 0;
};

class Market {
 public:
  Market(const std::vector<PlacedSense>& senses, const Lexicon& lexicon)
      : lexicon_(lexicon), kept_(senses.size(), true) {
    for (std::size_t i = 0; i < senses.size(); ++i) alive_.push_back({i, senses[i].words, &senses[i].sense->category});
    for (const auto& [name, atom] : lexicon.atoms) atoms_.push_back(&atom);
  }

  std::vector<bool> settled() {
    for (std::size_t before = 0; before != alive_.size();) {
      before = alive_.size();
      trades_.assign(atoms_.size(), Trade());
      for (const auto& offer : alive_) note(offer);
      note_rules();
      std::erase_if(alive_, [&](const Offer& offer) {
        const bool out = !is_taken(offer) || !has_all(offer);
        if (out) kept_[offer.number] = false;
        return out;
      });
    }
    return std::move(kept_);
  }

 private:
  struct Offer {
    std::size_t number;
    WordSpan words;
    const Category* category;
  };

  Trade& trade_in(const Category& category) { return trades_[category.target_number()]; }
  const Trade& trade_in(const Category& category) const { return trades_[category.target_number()]; }

  void note(const Offer& offer) {
    auto& made = trade_in(*offer.category);
    made.made = true;
    made.last_begin = std::max(made.last_begin, offer.words.begin);
    made.first_end = std::min(made.first_end, offer.words.end);
    for_each_argument(*offer.category, [&](const Category& need, bool to_the_right) {
      auto& taken = trade_in(need);
      if (to_the_right) {
        taken.first_taker_end = std::min(taken.first_taker_end, offer.words.end);
      } else {
        taken.taken_from_left = true;
        taken.last_taker_begin = std::max(taken.last_taker_begin, offer.words.begin);
      }
      note_given(need);
    });
  }

  // Whoever takes a function gives its arguments to it.
  void note_given(const Category& need) {
    for_each_argument(need, [&](const Category& given, bool) { trade_in(given).made_anywhere = true; });
  }

  // A rule that has its phrase makes another one, wherever it stands.
  void note_rules() {
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& rule : lexicon_.rules) {
        auto& had = trade_in(rule.from);
        if (!had.made && !had.made_anywhere) continue;
        had.taken_anywhere = true;
        for_each_argument(rule.from, [&](const Category& need, bool) { trade_in(need).made_anywhere = true; });
        grows = grows || !trade_in(rule.to).made_anywhere;
        trade_in(rule.to).made_anywhere = true;
        for_each_argument(rule.to, [&](const Category& need, bool) {
          trade_in(need).taken_anywhere = true;
          note_given(need);
        });
      }
    }
  }

  bool is_taken(const Offer& offer) const {
    const auto& trade = trade_in(*offer.category);
    return trade.taken_anywhere || trade.first_taker_end <= offer.words.begin ||
           (trade.taken_from_left && trade.last_taker_begin >= offer.words.end) ||
           !atoms_[offer.category->target_number()]->move.empty();
  }

  bool has_all(const Offer& offer) const {
    bool has = true;
    for_each_argument(*offer.category, [&](const Category& need, bool to_the_right) {
      const auto& trade = trade_in(need);
      if (trade.made_anywhere || atoms_[need.target_number()]->open) return;
      has = has && trade.made &&
            (to_the_right ? trade.last_begin >= offer.words.end : trade.first_end <= offer.words.begin);
    });
    return has;
  }

  const Lexicon& lexicon_;
  std::vector<bool> kept_;
  std::vector<Offer> alive_;
  std::vector<const Atom*> atoms_;  // by number
  std::vector<Trade> trades_;       // by number of their atom
};

}  // namespace

std::vector<bool> with_prospects(const std::vector<PlacedSense>& senses, const Lexicon& lexicon) {
  return Market(senses, lexicon).settled();
}

}  // namespace continua
