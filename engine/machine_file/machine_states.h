// The names of a machine's states. They are collected first, because all other parts refer to them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"

namespace continua {

class StateNames {
 public:
  /// The states of the document: those of `states` or, without that member, those that transitions lead from or to.
  explicit StateNames(const Item& root);

  /// In the order of the file; the position is the StateIndex.
  const std::vector<std::string>& names() const { return names_; }
  /// The state with the name; nothing if there is none.
  std::optional<StateIndex> find(const std::string& name) const;
  /// The state that the item names. An unknown name is a problem and gives nothing; so does an absent item, without a
  /// problem.
  std::optional<StateIndex> named(const Item& item);
  /// Adds a place that names the state, such as its entry in `states`.
  void add_mention(const std::string& name, const Item& item) { mentions_[name].push_back(item); }

  /// Without a list of states: reports names in one place only that are a slip away from a name in several places.
  void report_misspelt() const;

 private:
  void add(const Item& name);

  std::vector<std::string> names_;
  std::map<std::string, StateIndex, std::less<>> index_;
  std::map<std::string, std::vector<Item>, std::less<>> mentions_;
};

}  // namespace continua
