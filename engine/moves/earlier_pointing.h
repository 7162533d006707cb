// Pointings without words, and the words that take them later. A pointing is typed physobj[] • location (the paper's
// [[point]]): it has the things there and the place, and both are kept until a type selects one of them.
#pragma once

#include <vector>

#include "continua/language/demonstratives.h"
#include "continua/language/reference.h"

namespace continua {

/// Where was pointed, on the table, the latest first; one list for each half that was not used yet.
struct EarlierPointings {
  std::vector<Vec3> things, places;
};

/// The pointings that the demonstratives of an utterance take.
///
/// - "that one" takes the half of the things, "there" the half of the place. Each pointing goes with one of them.
/// - The last demonstrative takes the latest pointing, the one before it the pointing before: things and places come in
///   the order of their words.
/// - "these" takes all that are left.
/// - If there are fewer pointings than demonstratives, things go first, since a place can be asked for.
/// - The words for a thing that need no pointing, such as "the cup", share the latest pointing at things: it tells
/// which
///   is meant if several fit.
std::vector<Showing> taken_by(const std::vector<Demonstrative>& demonstratives, const EarlierPointings& earlier);

}  // namespace continua
