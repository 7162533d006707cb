// The labels of a picture's arrows: text where it is short, else a number whose text stands in a legend.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/export/state_graph.h"

namespace continua {

/// The text, in lines of at most `most` columns: broken at blanks, a longer word between its characters. Lines after
/// the first begin with `indent`.
std::vector<std::string> broken(std::string_view text, std::size_t most, std::string_view indent = "");

/// A state's name, broken at blanks, '_', '-' and before capital letters, in lines of about `most` columns.
std::vector<std::string> broken_name(const std::string& name, std::size_t most);

/// The most that a label beside its arrow may have; nothing: all arrows have numbers.
struct LabelRoom {
  std::size_t lines = 0, columns = 0;
};

struct ArrowLabel {
  std::vector<std::string> lines;  ///< beside the arrow; a number's digits where there is no room
  std::size_t number = 0;          ///< 0: none
};

/// Those of the arrows, in their order; numbers count from 1, state by state.
std::vector<ArrowLabel> labels_of(const std::vector<Arrow>& arrows, const LabelRoom& room);

}  // namespace continua
