// How much goes wrong between a human and the recognisers of words, hands and fingers: NOISE.json (NOISE.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/noise/confusions.h"

namespace continua {

/// All members at 0: nothing goes wrong. Shares are 0 … 1; times in seconds, distances in metres.
struct Noise {
  struct Words {
    double dropped = 0, swapped = 0, misheard = 0;  ///< shares of the words; together at most 1
  } words;
  struct NBest {
    double share = 0;  ///< of the utterances, those that are heard as lists
    int size = 3;      ///< readings in a list
    int truth = 1;     ///< the place of what was said, from 1
  } n_best;
  struct Times {
    double sd_s = 0;  ///< of an event's time
  } times;
  struct Gestures {
    double missed = 0, doubled = 0;  ///< shares of the gestures
  } gestures;
  struct Pointing {
    double sd_m = 0;    ///< of the point, along each axis
    double late_s = 0;  ///< a stretch of pointing becomes known later, by up to so much
    double cut = 0;     ///< of a stretch's length, the most that is lost at its end
  } pointing;
  Confusions confusions;  ///< of words; needed by `words` and `n_best`
};

/// Names of the kinds of noise, as in the file.
const std::vector<std::string>& noise_kinds();

/// The noise of one kind alone, `strength` times as strong: shares, at most 1 together, times and distances are
/// multiplied. REQUIRES one of noise_kinds().
Noise only(const Noise& noise, std::string_view kind, double strength);

/// Whether the noise has something of this kind.
bool has_kind(const Noise& noise, std::string_view kind);

/// Reads NOISE.json, a file or a name in `knowledge`/noise; the tables of confusions are in `knowledge`/confusions.
/// Errors have file, line, the thing found and the thing expected.
Result<Noise> read_noise(const std::string& name, const std::filesystem::path& knowledge);

}  // namespace continua
