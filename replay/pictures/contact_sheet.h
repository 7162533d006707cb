// Several pictures in one, each with its time and its caption below.
#pragma once

#include <vector>

#include "continua/replay/pictures/canvas.h"
#include "continua/replay/pictures/key_moments.h"

namespace continua {

/// The columns that so many pictures are laid out in.
int sheet_columns(std::size_t pictures);

/// `pictures[i]` shows `moments[i]`; all are of one size. REQUIRES as many of both, at least one.
Canvas contact_sheet(const std::vector<KeyMoment>& moments, const std::vector<Image>& pictures);

}  // namespace continua
