// The pushdown automaton of the textbooks and of JFLAP, decided in the plainest way there is: the reference for our
// translation of JFLAP files and for our acceptance. It knows neither; symbols are bytes.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace classical {

/// In one step: reads all of `read`, takes all of `pop` off the stack (its first symbol is the topmost), puts `push` on
/// it (its first symbol ends on top). Each may be empty; the stack may be.
struct Move {
  int from = 0;
  std::string read, pop, push;
  int to = 0;
};

struct Pda {
  int states = 1, start = 0;
  std::set<int> accepting;
  std::vector<Move> moves;
  std::string stack = "Z";  ///< at first, topmost first
};

struct Verdict {
  bool final_state = false;  ///< the word can be read to an accepting state
  bool empty_stack = false;  ///< the word can be read so that the stack ends up empty
  bool operator==(const Verdict&) const = default;
};

Verdict decide(const Pda& pda, const std::string& word);

}  // namespace classical
