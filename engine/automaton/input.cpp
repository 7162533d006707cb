#include "continua/automaton/input.h"

#include <array>

namespace continua {

std::span<const Carried> carried_terms() {
  static constexpr std::array terms = {
      Carried{"target", "loc", &Input::target},
      Carried{"said", "text", &Input::said},
      Carried{"act", "t", &Input::act},
      Carried{"reason", "text", &Input::reason},
      Carried{"why", "text", &Input::why},
      Carried{"concerned", "e*", &Input::concerned},
      Carried{"gesture", "text", &Input::gesture},
      Carried{"doubted", "num*", &Input::doubted},
      Carried{"doubted_words", "text*", &Input::doubted_words},
      Carried{"doubted_meanings", "term*", &Input::doubted_meanings},
      Carried{"sign", "text", &Input::sign, true},
      Carried{"sign_at", "num", &Input::sign_at, true},
      Carried{"observed_speech", "text", &Input::observed_speech},
      Carried{"observed_gestures", "term*", &Input::observed_gestures},
      Carried{"observed_acts", "term*", &Input::observed_acts},
      Carried{"pointed", "loc", &Input::pointed, true},
      Carried{"pointed_confidence", "num", &Input::pointed_confidence, true},
      Carried{"pointing", "e* • loc", &Input::pointing, true},
      Carried{"move", "text", &Input::move, true},
      Carried{"reading", "term", &Input::reading, true},
      Carried{"meaning", "term", &Input::meaning, true},
      Carried{"choices", "e**", &Input::choices, true},
      Carried{"wanted", "text*", &Input::wanted, true},
      Carried{"referents", "e*", &Input::referents, true},
      Carried{"named", "(e -> t)*", &Input::named, true},
      Carried{"next", "text", &Input::next, true},
      Carried{"previous", "text", &Input::previous, true},
      Carried{"joined", "text", &Input::joined, true},
      Carried{"quoted", "t", &Input::quoted, true},
      Carried{"following", "text*", &Input::following, true},
      Carried{"later", "text*", &Input::later, true},
      Carried{"unknown", "text*", &Input::unknown, true},
      Carried{"repaired", "text*", &Input::repaired, true},
      Carried{"left_out", "text*", &Input::left_out, true},
  };
  return terms;
}

}  // namespace continua
