// A move of the human: a terminal of the paper's Table 1 with its content (paper §2.2).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/language/interpretation.h"
#include "continua/language/reading.h"
#include "continua/learning/shapes.h"

namespace continua {

/// Table 1's name of a deictic gesture. Machines and lexicons name the other kinds.
inline constexpr const char* deixis = "δ";
/// Table 1's names of iconic gestures: one that shows an action, and one that shows an object. A taught gesture gets
/// one of them by the type of its meaning.
inline constexpr const char* iconic = "α";
inline constexpr const char* static_iconic = "ω";

struct Move {
  std::string kind;                   ///< δ, ω, α, N, V, P, y, n or another of the lexicon's; empty: not understood
  std::vector<std::string> words;     ///< of speech: those of this move
  std::vector<Reading> readings;      ///< of speech: the likeliest first
  std::size_t chosen = 0;             ///< the reading that was interpreted
  Interpretation interpretation;      ///< of that reading
  Term meaning;                       ///< a term that a machine can evaluate; null if nothing was understood
  Reference reference;                ///< of a noun phrase, preferably an open one; or of pointing
  std::vector<Term> nouns;            ///< e -> t: its nouns in the order of the words, "red block" before "block"
  std::vector<std::string> unknown;   ///< words near it that the lexicon does not have
  std::vector<std::string> unused;    ///< known words near it that fit nowhere
  std::vector<std::string> repaired;  ///< unknown words near it that were read as words which resemble them
  std::optional<Recognition> shape;   ///< of a gesture that does not go by its name, if its form is known
  std::vector<std::string> left_out;  ///< words of its sentence that are unknown, not surely repaired, or fit nowhere
};

}  // namespace continua
