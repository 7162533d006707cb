#include "continua/language/prospects.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace continua {
namespace {

using Slash = Category::Slash;

constexpr auto nowhere = std::numeric_limits<std::size_t>::max();

// An argument of a category: the atom that remains of it, and the atoms that whoever takes it gives to it.
struct Need {
  std::size_t atom;
  bool to_the_right;
  std::vector<std::size_t> given;
};

struct Shape {
  std::size_t made;  // the atom that remains
  std::vector<Need> needs;
};

// Where phrases of an atom are made, and where they are taken. Positions are those between the words.
struct Trade {
  bool made = false, made_anywhere = false;
  std::size_t last_begin = 0, first_end = nowhere;  // of the words that make one
  bool taken_anywhere = false, taken_from_left = false;
  std::size_t first_taker_end = nowhere, last_taker_begin = 0;
};

class Market {
 public:
  Market(const std::vector<PlacedSense>& senses, const Lexicon& lexicon) : lexicon_(lexicon), kept_(senses.size()) {
    for (std::size_t i = 0; i < senses.size(); ++i) {
      alive_.push_back({i, senses[i].words, shape_of(senses[i].sense->category)});
      kept_[i] = true;
    }
    for (const auto& rule : lexicon.rules) rules_.push_back({shape_of(rule.from), shape_of(rule.to)});
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
    Shape shape;
  };
  struct Change {
    Shape from, to;
  };

  std::size_t number_of(const Category& category) {
    const auto name = target(category).name();
    const auto [found, is_new] = numbers_.emplace(name, atoms_.size());
    if (is_new) atoms_.push_back(&lexicon_.atoms.find(name.text())->second);
    return found->second;
  }

  Shape shape_of(const Category& category) {
    Shape shape{number_of(category), {}};
    for (const auto* part = &category; !part->is_atom(); part = &part->result()) {
      const auto& argument = part->argument();
      Need need{number_of(argument), part->slash() == Slash::forward, {}};
      for (const auto* inner = &argument; !inner->is_atom(); inner = &inner->result())
        need.given.push_back(number_of(inner->argument()));
      shape.needs.push_back(std::move(need));
    }
    return shape;
  }

  void note(const Offer& offer) {
    auto& made = trades_[offer.shape.made];
    made.made = true;
    made.last_begin = std::max(made.last_begin, offer.words.begin);
    made.first_end = std::min(made.first_end, offer.words.end);
    for (const auto& need : offer.shape.needs) {
      auto& taken = trades_[need.atom];
      if (need.to_the_right) {
        taken.first_taker_end = std::min(taken.first_taker_end, offer.words.end);
      } else {
        taken.taken_from_left = true;
        taken.last_taker_begin = std::max(taken.last_taker_begin, offer.words.begin);
      }
      note_given(need);
    }
  }

  void note_given(const Need& need) {
    for (const auto atom : need.given) trades_[atom].made_anywhere = true;
  }

  // A rule that has its phrase makes another one, wherever it stands.
  void note_rules() {
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& [from, to] : rules_) {
        auto& had = trades_[from.made];
        if (!had.made && !had.made_anywhere) continue;
        had.taken_anywhere = true;
        for (const auto& need : from.needs) trades_[need.atom].made_anywhere = true;
        grows = grows || !trades_[to.made].made_anywhere;
        trades_[to.made].made_anywhere = true;
        for (const auto& need : to.needs) {
          trades_[need.atom].taken_anywhere = true;
          note_given(need);
        }
      }
    }
  }

  bool is_taken(const Offer& offer) const {
    const auto& trade = trades_[offer.shape.made];
    return trade.taken_anywhere || trade.first_taker_end <= offer.words.begin ||
           (trade.taken_from_left && trade.last_taker_begin >= offer.words.end) ||
           !atoms_[offer.shape.made]->move.empty();
  }

  bool has_all(const Offer& offer) const {
    return std::all_of(offer.shape.needs.begin(), offer.shape.needs.end(), [&](const Need& need) {
      const auto& trade = trades_[need.atom];
      if (trade.made_anywhere || atoms_[need.atom]->open) return true;
      if (!trade.made) return false;
      return need.to_the_right ? trade.last_begin >= offer.words.end : trade.first_end <= offer.words.begin;
    });
  }

  const Lexicon& lexicon_;
  std::vector<bool> kept_;
  std::vector<Offer> alive_;
  std::vector<Change> rules_;
  std::unordered_map<Name, std::size_t, Name::Hash> numbers_;
  std::vector<const Atom*> atoms_;
  std::vector<Trade> trades_;
};

}  // namespace

std::vector<bool> with_prospects(const std::vector<PlacedSense>& senses, const Lexicon& lexicon) {
  return Market(senses, lexicon).settled();
}

}  // namespace continua
