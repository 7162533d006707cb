// Words that a recogniser hears in place of others, and how sure it is of them: a table that was learned
// (learn_confusions.py).
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

struct Confusions {
  using Row = std::vector<std::pair<std::string, double>>;  ///< heard words, and how often

  std::map<std::string, Row> rows;             ///< by the word that was said, in small letters
  Row anything;                                ///< words heard in place of a word without a row
  std::vector<double> sure_right, sure_wrong;  ///< quantiles of the confidences of right and of wrong words, ascending
  double share_wrong = 0.5;                    ///< of the words that were heard, in 0 … 1

  /// The word that is heard in place of `said`; `chance` in [0, 1) chooses among those of its row.
  const std::string& heard(const std::string& said, double chance) const;
};

/// The table of a file. Errors name what was expected.
Result<Confusions> read_confusions(const std::string& path);

/// The value that a share of `at` in [0, 1] is below, between the quantiles.
double quantile(const std::vector<double>& quantiles, double at);

}  // namespace continua
