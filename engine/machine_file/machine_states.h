// The names of a machine's states, which are known before anything else refers to them.
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
  /// Nothing when no state has the name.
  std::optional<StateIndex> find(const std::string& name) const;
  /// The state that the item names; nothing, and a problem, if it names none. An absent item names none.
  std::optional<StateIndex> named(const Item& item);
  /// The entry of a state in `states` names the state too.
  void add_mention(const std::string& name, const Item& item) { mentions_[name].push_back(item); }

  /// Without a list of states, a name that stands in one place only and is a slip away from a name of several places
  /// is a problem.
  void report_misspelt() const;

 private:
  void add(const Item& name);

  std::vector<std::string> names_;
  std::map<std::string, StateIndex, std::less<>> index_;
  std::map<std::string, std::vector<Item>, std::less<>> mentions_;
};

}  // namespace continua
