#include "continua/machine_file/machine_inputs.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/machine_file/misspelling.h"

namespace continua {
namespace {

// Sets that name sets are read recursively; the limit protects the call stack.
constexpr std::size_t deepest_set = 100;

constexpr const char* symbol_or_set = "an input symbol or the name of a set";

}  // namespace

void SymbolReader::read_sets(const Item& inputs) {
  for (const auto& [name, item] : inputs.members("sets of input symbols")) {
    named_set(inputs, name);
    if (name.empty()) item.problem_at_key("found '', expected the name of a set");
  }
  for (const auto& [symbol, places] : places_) known_.insert(symbol);
}

const SymbolSet& SymbolReader::named_set(const Item& inputs, const std::string& name) {
  if (const auto known = sets_.find(name); known != sets_.end()) return known->second;
  const auto item = inputs.member(name);
  SymbolSet set;
  if (std::find(path_.begin(), path_.end(), name) != path_.end()) {
    item.problem_at_key(fmt::format("the set {} contains itself", in_quotes(name)));
  } else if (path_.size() > deepest_set) {
    item.problem_at_key(fmt::format("sets nested deeper than {}; expected fewer", deepest_set));
  } else {
    path_.push_back(name);
    for (const auto& each : item.elements("a set of input symbols")) {
      if (each.is_text() && inputs.member(each.json().get<std::string>()).exists())
        named_set(inputs, each.json().get<std::string>());
      add(set, each);
    }
    path_.pop_back();
  }
  return sets_.emplace(name, std::move(set)).first->second;
}

SymbolSet SymbolReader::symbols(const Item& item) {
  SymbolSet set;
  if (!item.is_list()) {
    add(set, item);
    return set;
  }
  const auto elements = item.elements("input symbols");
  if (elements.empty()) item.problem(fmt::format("found an empty list, expected {}", symbol_or_set));
  for (const auto& each : elements) add(set, each);
  return set;
}

void SymbolReader::add(SymbolSet& set, const Item& item) {
  const auto symbol = item.name(symbol_or_set);
  if (symbol.empty()) return;
  if (const auto named = sets_.find(symbol); named != sets_.end()) {
    used_sets_.insert(symbol);
    set.add(named->second);
  } else {
    places_[symbol].push_back(item);
    set.add(symbol);
  }
}

SymbolSet SymbolReader::symbols_of_key(const std::string& key, const Item& value) {
  SymbolSet set;
  if (const auto named = sets_.find(key); named != sets_.end()) {
    used_sets_.insert(key);
    set.add(named->second);
  } else {
    keys_.push_back({key, value});
    set.add(key);
  }
  return set;
}

void SymbolReader::report_unmatched_keys() const {
  std::vector<std::string> known(known_.begin(), known_.end());
  for (const auto& [symbol, places] : places_) known.push_back(symbol);
  for (const auto& [key, value] : keys_) {
    SymbolSet pattern;
    pattern.add(key);
    if (std::any_of(known.begin(), known.end(), [&set = pattern](const auto& each) { return set.contains(each); }))
      continue;
    for (const auto& [name, set] : sets_) known.push_back(name);
    value.problem_at_key(fmt::format("no input of the machine is {}{}", in_quotes(key), value.nearest(key, known)));
  }
}

void SymbolReader::report_misspelt() const {
  std::vector<std::string> unused;
  for (const auto& [name, set] : sets_)
    if (!used_sets_.contains(name)) unused.push_back(name);
  for (const auto& [symbol, places] : places_) {
    if (places.size() > 1 || known_.contains(symbol) || places[0].reader_is_full()) continue;
    const auto slip = std::find_if(sets_.begin(), sets_.end(), [spelt = std::string_view(symbol)](const auto& set) {
      return is_slip(spelt, set.first);
    });
    const auto meant = slip == sets_.end() ? places[0].nearest(symbol, unused)
                                           : fmt::format(" (did you mean {}?)", in_quotes(slip->first));
    if (meant.empty()) continue;
    places[0].problem(fmt::format("{} is no set, and nothing else names such a symbol{}", in_quotes(symbol), meant));
  }
}

}  // namespace continua
