// Reads input symbols of a machine file and the names of their sets.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "continua/automaton/symbol_set.h"
#include "continua/core/document_reader.h"

namespace continua {

class SymbolReader {
 public:
  /// The machine's `inputs`: sets by name. A set may name other sets.
  void read_sets(const Item& inputs);
  /// A symbol, the name of a set, or a list of both.
  SymbolSet symbols(const Item& item);
  /// A key that is a symbol or the name of a set; `value` is its value.
  SymbolSet symbols_of_key(const std::string& key, const Item& value);
  /// Symbols of examples count as spelt correctly.
  void add_known(const std::vector<std::string>& symbols) { known_.insert(symbols.begin(), symbols.end()); }

  /// Reports symbols that are probably misspelt names of sets: a symbol in one place only that is a slip away from the
  /// name of a set, or resembles the name of an unused set.
  void report_misspelt() const;
  /// Reports keys that no symbol of the machine matches.
  void report_unmatched_keys() const;

 private:
  const SymbolSet& named_set(const Item& inputs, const std::string& name);
  void add(SymbolSet& set, const Item& item);

  std::map<std::string, SymbolSet, std::less<>> sets_;
  std::vector<std::string> path_;  ///< the sets under reading, each named by the one before
  std::set<std::string, std::less<>> used_sets_;
  std::map<std::string, std::vector<Item>, std::less<>> places_;  ///< of each symbol that is not the name of a set
  std::set<std::string, std::less<>> known_;
  std::vector<NamedItem> keys_;  ///< keys that are symbols
};

}  // namespace continua
