// The objects that a noun phrase can mean (SEMANTICS.md §3; paper §2.1). Its conditions over the world, pointing and
// the focus give ranked referents, and for each other object the condition that ruled it out.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "continua/language/operators.h"
#include "continua/language/reading.h"
#include "continua/term/evaluate.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// A pointing that goes with some of the words.
struct Showing {
  WordSpan words;
  Vec3 place_W = Vec3::Zero();  ///< on the table
};

/// The circumstances in which an utterance or a gesture is understood. REQUIRES a world.
struct Context {
  Facts facts;                     ///< the world among them
  std::optional<Vec3> pointed_W;   ///< where the human points, on the table
  std::vector<Showing> showings;   ///< of an utterance: if not empty, each goes with its words, not pointed_W
  std::vector<std::string> focus;  ///< objects being talked about, the most salient first
  std::vector<std::string> among;  ///< if not empty: only these are asked about
  std::vector<Term> topics;        ///< what "one" can stand for, of type e -> t, the likeliest first
};

/// How words are evaluated: facts of the world as rules, definitions of the lexicon by lookup.
struct Meanings {
  const RuleTable* rules = nullptr;
  Evaluation::Lookup lookup;
  const Operators* operators = nullptr;
};

struct Referent {
  std::string object;
  double weight = 1;  ///< of all referents' weights, which sum to 1
};

struct RuledOut {
  std::string object;
  std::string reason;  ///< the condition that it does not meet: "not blue(plate)"
};

struct Reference {
  std::vector<Referent> referents;                          ///< the likeliest first; ties in the scene's order
  std::vector<RuledOut> ruled_out;                          ///< in the scene's order
  double margin = std::numeric_limits<double>::infinity();  ///< metres: how near the nearest decision was
  Sides sides = Sides::exact;                               ///< how "left of" and its like had to be taken
};

/// Referents of `condition`, a term of type e -> t such as \x. cup(x) and located(x, left(the(\y. plate(y)))). Every
/// object is a referent or ruled out. `determiner` tells whether pointing counts.
///
/// - Conditions are tried one by one, in their order; the first that fails is the reason. Null is not true.
/// - Pointing counts for a deictic determiner only. Words decide first; then an object less than `least_share`
///   (language/pointing.h) as likely as the likeliest is left out. Far from all objects that fit, pointing says
///   nothing. Where the phrase around is deictic too, the pointing is its own.
/// - Without pointing all referents weigh the same. Those in focus come first, but none is left out. A determiner of
///   number gives all objects that fit, whether their number is right or not.
/// - "other" and `another` leave out the thing in focus; inside a noun phrase, the subject of that phrase.
/// - Sides are exact; where nothing fits, rough; where still nothing does, loose.
/// - A nested noun phrase need not single out one thing by itself: one fitting referent of it is enough ("the block
///   right of the red block").
/// - The work is bounded; past the bound nothing is true. The margin is a length: moving everything by less than half
///   of it changes no referent.
Reference refer(const Term& condition, const Determiner& determiner, const Context& context, const Meanings& meanings);

/// Referents of pointing alone.
Reference refer_to_pointed(const Context& context);

}  // namespace continua
