// How far an avatar's deeds agree with those observed of another: words with words, terms with terms.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/world/world_snapshot.h"

namespace continua {

/// One thing that an avatar did.
struct AvatarMove {
  std::string channel;  ///< "speech", "gesture" or "action"
  std::string content;  ///< words, or a term as it is printed
  int n = 0;            ///< its record in the run log; 0: it has none
};

/// How far two lists of moves agree; each level includes those before it.
enum class AgreementLevel {
  none,
  same_template,  ///< words and acts, in order; gestures, names, attributes and places left out
  lax,            ///< the same moves in order; a place that is described, as a part of the table is, may be any place
  exact,          ///< the same moves in order, coordinates within the tolerance
};

std::string name_of(AgreementLevel level);

/// Things in which two avatars may differ and still follow the same template.
struct Blanks {
  std::set<std::string, std::less<>> names;  ///< of objects, and values of their attributes, lower case
};

/// Of the objects in a world.
Blanks blanks_of(const WorldSnapshot& world);

/// Coordinates of one place may differ by so much, metres.
inline constexpr double place_tolerance_m = 0.002;

/// Two empty lists agree exactly.
AgreementLevel agreement(const std::vector<AvatarMove>& observed, const std::vector<AvatarMove>& produced,
                         const Blanks& blanks);

/// A move with the parts blanked that the template leaves out: "The _ block?", "put(_, on(_))". REQUIRES that it is no
/// gesture.
std::string template_of(const AvatarMove& move, const Blanks& blanks);

/// The moves' templates, told apart by "say " before words. Gestures are left out.
std::vector<std::string> template_of(const std::vector<AvatarMove>& moves, const Blanks& blanks);

}  // namespace continua
