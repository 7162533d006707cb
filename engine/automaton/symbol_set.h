// Sets of input symbols, matched by name or by prefix.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace continua {

struct SymbolSet {
  std::set<std::string, std::less<>> names, prefixes;

  /// Adds a symbol. A symbol that ends in `*` adds all with that prefix; one that ends in `\*` stands for itself
  /// without the backslash.
  void add(std::string_view symbol);
  void add(const SymbolSet& other);
  bool contains(std::string_view symbol) const;
};

}  // namespace continua
