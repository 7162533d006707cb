// The least set of facts "from place p with A on top, all above what lies below A can be taken off, A included, ending
// in place q", found by applying every rule until none adds anything. A place is a state and how much of the word has
// been read; a move that pops several symbols leads through places of its own.
#include "reference/classical_pda.h"

#include <map>
#include <tuple>

namespace classical {
namespace {

constexpr char floor_symbol = '\0';  // lies below the stack and is never popped

struct Place {
  int read = 0, state = 0;
  int move = -1, popped = 0;  ///< in the middle of a move
  auto operator<=>(const Place&) const = default;
};

// With `top` on top: it is replaced by `push`.
struct Rule {
  Place from, to;
  char top = 0;
  std::string push;
};

using Head = std::pair<Place, char>;
using Places = std::set<Place>;

class Decision {
 public:
  Decision(const Pda& pda, const std::string& word) : pda_(pda), word_(word) {
    symbols_ = {floor_symbol};
    symbols_.insert(pda.stack.begin(), pda.stack.end());
    for (const auto& move : pda.moves) {
      symbols_.insert(move.pop.begin(), move.pop.end());
      symbols_.insert(move.push.begin(), move.push.end());
    }
    for (int i = 0; i < static_cast<int>(pda.moves.size()); ++i)
      for (int at = 0; at <= static_cast<int>(word.size()); ++at) add_rules(i, at);
    find_exits();
    find_heads();
  }

  Verdict verdict() const {
    Verdict verdict;
    for (const auto& [place, top] : heads_) {
      const bool ended = place.move < 0 && place.read == static_cast<int>(word_.size());
      if (ended && pda_.accepting.contains(place.state)) verdict.final_state = true;
      if (ended && top == floor_symbol) verdict.empty_stack = true;
    }
    return verdict;
  }

 private:
  void add_rules(int index, int at) {
    const auto& move = pda_.moves[index];
    if (word_.compare(at, move.read.size(), move.read) != 0) return;
    const Place to = {at + static_cast<int>(move.read.size()), move.to};
    Place from = {at, move.from};
    if (move.pop.empty()) {
      for (const char top : symbols_) rules_.push_back({from, to, top, move.push + top});
      return;
    }
    for (std::size_t i = 0; i + 1 < move.pop.size(); ++i) {
      const Place between = {at, move.from, index, static_cast<int>(i) + 1};
      rules_.push_back({from, between, move.pop[i], ""});
      from = between;
    }
    rules_.push_back({from, to, move.pop.back(), move.push});
  }

  // Where one may be once all of `symbols` are gone.
  Places through(const Place& from, const std::string& symbols) const {
    Places places = {from};
    for (const char symbol : symbols) {
      Places next;
      for (const auto& place : places)
        if (const auto exits = exits_.find({place, symbol}); exits != exits_.end())
          next.insert(exits->second.begin(), exits->second.end());
      places = next;
    }
    return places;
  }

  void find_exits() {
    for (bool added = true; added;) {
      added = false;
      for (const auto& rule : rules_) {
        if (rule.top == floor_symbol) continue;
        for (const auto& place : through(rule.to, rule.push))
          added |= exits_[{rule.from, rule.top}].insert(place).second;
      }
    }
  }

  // Every place and topmost symbol that can be reached: those of each part of a push, once the symbols above are gone.
  void find_heads() {
    reach({0, pda_.start}, pda_.stack + floor_symbol);
    for (bool added = true; added;) {
      const auto before = heads_.size();
      for (const auto& rule : rules_)
        if (heads_.contains({rule.from, rule.top})) reach(rule.to, rule.push);
      added = heads_.size() > before;
    }
  }

  void reach(const Place& from, const std::string& symbols) {
    for (std::size_t i = 0; i < symbols.size(); ++i)
      for (const auto& place : through(from, symbols.substr(0, i))) heads_.insert({place, symbols[i]});
  }

  const Pda& pda_;
  const std::string& word_;
  std::set<char> symbols_;
  std::vector<Rule> rules_;
  std::map<Head, Places> exits_;
  std::set<Head> heads_;
};

}  // namespace

Verdict decide(const Pda& pda, const std::string& word) { return Decision(pda, word).verdict(); }

}  // namespace classical
