#include "continua/automaton/symbol_set.h"

#include <algorithm>

namespace continua {

void SymbolSet::add(std::string_view symbol) {
  if (symbol.ends_with("\\*"))
    names.insert(std::string(symbol.substr(0, symbol.size() - 2)) + '*');
  else if (symbol.ends_with('*'))
    prefixes.emplace(symbol.substr(0, symbol.size() - 1));
  else
    names.emplace(symbol);
}

void SymbolSet::add(const SymbolSet& other) {
  names.insert(other.names.begin(), other.names.end());
  prefixes.insert(other.prefixes.begin(), other.prefixes.end());
}

bool SymbolSet::contains(std::string_view symbol) const {
  return names.contains(symbol) ||
         std::any_of(prefixes.begin(), prefixes.end(), [&](const auto& prefix) { return symbol.starts_with(prefix); });
}

}  // namespace continua
