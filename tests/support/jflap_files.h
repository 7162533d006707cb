// JFLAP files for tests, written from the textbook's automata.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "reference/classical_pda.h"

namespace continua {

/// States and transitions in the layout of JFLAP 7, a line for each state and transition; the first line is 1.
inline std::string jff(std::string_view type, std::string_view elements) {
  return fmt::format("<structure><type>{}</type><automaton>\n{}</automaton></structure>\n", type, elements);
}

inline std::string escaped(std::string_view symbols) {
  std::string text;
  for (const char c : symbols) text += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return text;
}

/// A pda; or an fa, for which only the letters read count.
inline std::string jff_of(const classical::Pda& pda, bool pushdown = true) {
  std::string elements;
  for (int state = 0; state < pda.states; ++state)
    elements += fmt::format("<state id=\"{0}\" name=\"q{0}\">{1}{2}</state>\n", state,
                            state == pda.start ? "<initial/>" : "", pda.accepting.contains(state) ? "<final/>" : "");
  const auto element = [](const char* name, const std::string& symbols) {
    return symbols.empty() ? fmt::format("<{}/>", name) : fmt::format("<{0}>{1}</{0}>", name, escaped(symbols));
  };
  for (const auto& move : pda.moves)
    elements += fmt::format("<transition><from>{}</from><to>{}</to>{}{}{}</transition>\n", move.from, move.to,
                            element("read", move.read), element("pop", move.pop), element("push", move.push));
  return jff(pushdown ? "pda" : "fa", elements);
}

}  // namespace continua
