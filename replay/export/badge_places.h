// Places for numbers on the lines of a picture.
#pragma once

#include <vector>

#include "continua/replay/export/curve.h"

namespace continua {

/// A box that nothing may cover.
struct PageBox {
  PagePoint centre;
  double width = 0, height = 0;

  bool meets(const PageBox& other) const;
};

struct Badge {
  std::vector<PagePoint> line;  ///< points along its arrow; not empty
  double width = 0, height = 0;
};

struct BadgePlaces {
  std::vector<PagePoint> centres;  ///< one for each badge
  bool apart = true;               ///< no badge covers a box or another badge
};

/// On its own line each, as near to the middle as can be, where no other line passes if there is such a place; beside
/// the line where there is no place on it. `others`: points along lines without badges.
BadgePlaces badge_places(const std::vector<Badge>& badges, const std::vector<PageBox>& boxes,
                         const std::vector<std::vector<PagePoint>>& others);

}  // namespace continua
