// Which objects a noun phrase can mean (SEMANTICS.md §3; paper §2.1). Its conditions over the world, pointing and focus
// give ranked referents, and for each other object the condition that ruled it out.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "continua/language/operators.h"
#include "continua/language/pointing.h"
#include "continua/language/reading.h"
#include "continua/term/evaluate.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// A pointing that belongs to some of the words.
struct Showing {
  WordSpan words;
  Vec3 place_W = Vec3::Zero();  ///< on the table
  bool is_gesture = true;       ///< false: the hand only stayed there
  double sd_m = hand_sd_m;      ///< its spread
  std::string hand = {};        ///< "left", "right" or empty
};

/// The context in which an utterance or a gesture is understood. REQUIRES a world.
struct Context {
  Facts facts;                             ///< with the world
  std::optional<Vec3> pointed_W;           ///< where the human points, on the table
  double pointed_sd_m = hand_sd_m;         ///< the spread of that pointing
  std::vector<Showing> showings;           ///< pointings of an utterance; if there are any, they replace pointed_W
  std::vector<std::string> focus;          ///< objects being talked about, the most salient first
  std::vector<std::string> among;          ///< if not empty: the question was about these only
  std::vector<std::string> handled;        ///< objects that the avatar acted on, the latest first
  std::vector<Term> topics;                ///< possible meanings of "one", of type e -> t, the likeliest first
  const DeicticProgram* deixis = nullptr;  ///< how pointings come about; nullptr: it is not told
};

/// How the constants of words are evaluated: facts of the world are rules, definitions of the lexicon are looked up.
struct Meanings {
  const RuleTable* rules = nullptr;
  Evaluation::Lookup lookup;
  const Operators* operators = nullptr;
};

struct Referent {
  std::string object;
  double weight = 1;  ///< the weights of all referents sum to 1
};

struct RuledOut {
  std::string object;
  std::string reason;  ///< the condition that it fails, negated: "not blue(plate)"
};

struct Reference {
  std::vector<Referent> referents;                          ///< the likeliest first; ties in the scene's order
  std::vector<RuledOut> ruled_out;                          ///< in the scene's order
  double margin = std::numeric_limits<double>::infinity();  ///< smallest margin of its decisions, metres
  Sides sides = Sides::exact;                               ///< the sense of "left of" and its like that was needed
};

/// Referents of `condition`, a term of type e -> t such as \x. cup(x) and located(x, left(the(\y. plate(y)))). Every
/// object of the scene is a referent or ruled out.
///
/// - Conditions are tried in their order; the first that fails is the reason. Null is not true.
/// - Pointing counts if `determiner` is deictic. Words decide first; then an object is ruled out if its likelihood is
///   less than `least_share` (language/pointing.h) of the highest. Pointing far from all that fit rules out nothing.
///   In nested noun phrases pointing counts only if `determiner` is not deictic.
/// - Without pointing all referents weigh the same. Focus orders them, but rules out none. A determiner's count does
///   not limit the referents: all that fit are returned.
/// - "other" and `another` exclude the object in focus; in a nested noun phrase, the object of the outer one.
/// - Sides are exact. If nothing fits they are rough; if still nothing fits, loose.
/// - A nested noun phrase need not single out one thing: it is enough that one of its referents fits ("the block right
///   of the red block").
/// - The work is bounded; past the bound no condition is true.
/// - If everything moves by less than half of the margin, the referents stay the same.
Reference refer(const Term& condition, const Determiner& determiner, const Context& context, const Meanings& meanings);

/// The objects of the context that a pro-form of this source lists; nullptr if it means none.
const std::vector<std::string>* objects_of(Proform::Source source, const Context& context);

/// Referents of pointing alone: objects asked about, or any others if none of those is pointed at.
Reference refer_to_pointed(const Context& context);

}  // namespace continua
