// Sets of input symbols of a machine file, and names that are probably misspelt.
#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "machine_file/machine_reader.h"

namespace continua {
namespace {

constexpr std::size_t deepest_set = 100;

bool same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

// Whether the one is the other but for a slip of the hand: a letter too many, too few, wrong, two exchanged, or the
// case. Names that differ in a digit, or only at their ends, are meant to, and of short names nothing is known.
bool is_slip(std::string_view a, std::string_view b) {
  const auto [shorter, longer] = std::minmax({a.size(), b.size()});
  if (shorter < 3 || longer - shorter > 1 || a == b) return false;
  std::size_t front = 0, back = 0;
  while (front < shorter && a[front] == b[front]) ++front;
  while (back < shorter - front && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  const auto x = a.substr(front, a.size() - front - back), y = b.substr(front, b.size() - front - back);
  const auto letters = [](std::string_view part) {
    return std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isalpha(c); });
  };
  if (!letters(x) || !letters(y)) return false;
  const bool exchanged = x.size() == 2 && y.size() == 2 && x[0] == y[1] && x[1] == y[0];
  const bool one_letter = x.size() <= 1 && y.size() <= 1 && front > 0 && back > 0;
  return one_letter || exchanged || same_but_for_case(x, y);
}

const std::string* resembling(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& other) { return is_slip(name, other); });
  return found == names.end() ? nullptr : &*found;
}

std::string suggestion(const std::string& name) { return fmt::format(" (did you mean {}?)", in_quotes(name)); }

// Of the places that name a state, the key of its entry in `states`.
bool is_entry(const Item& mention) { return !mention.json->is_string(); }

}  // namespace

void MachineReader::read_inputs(const Item& inputs) {
  if (!expect_object(inputs, "sets of input symbols")) return;
  for (const auto& [name, value] : inputs.json->items()) {
    std::vector<std::string> path;
    named_set(inputs, name, path);
    if (name.empty()) problem_at_key(member(inputs, name), "found '', expected the name of a set");
  }
  for (const auto& [symbol, places] : symbols_) known_symbols_.insert(symbol);
}

// A set may name other sets; `path` holds the names that are being read, to find one that contains itself.
const SymbolSet& MachineReader::named_set(const Item& inputs, const std::string& name, std::vector<std::string>& path) {
  if (const auto known = sets_.find(name); known != sets_.end()) return known->second;
  const auto item = member(inputs, name);
  SymbolSet set;
  if (std::find(path.begin(), path.end(), name) != path.end()) {
    problem_at_key(item, fmt::format("the set {} contains itself", in_quotes(name)));
  } else if (path.size() > deepest_set) {
    problem_at_key(item, fmt::format("sets nested deeper than {}; expected fewer", deepest_set));
  } else if (expect_array(item, "a set of input symbols")) {
    path.push_back(name);
    for (std::size_t i = 0; i < item.json->size(); ++i) {
      const auto one = element(item, i);
      if (one.json->is_string() && inputs.json->contains(one.json->get<std::string>()))
        named_set(inputs, one.json->get<std::string>(), path);
      add_symbol(set, one);
    }
    path.pop_back();
  }
  return sets_.emplace(name, std::move(set)).first->second;
}

SymbolSet MachineReader::read_symbols(const Item& item) {
  SymbolSet set;
  if (!item.json || !item.json->is_array()) {
    add_symbol(set, item);
    return set;
  }
  if (item.json->empty()) problem(item, "found an empty list, expected an input symbol or the name of a set");
  for (std::size_t i = 0; i < item.json->size(); ++i) add_symbol(set, element(item, i));
  return set;
}

void MachineReader::add_symbol(SymbolSet& set, const Item& item) {
  const auto symbol = name_of(item, "an input symbol or the name of a set");
  if (symbol.empty()) return;
  if (const auto named = sets_.find(symbol); named != sets_.end()) {
    used_sets_.insert(symbol);
    set.add(named->second);
  } else {
    symbols_[symbol].push_back(item);
    set.add(symbol);
  }
}

// A symbol that one place only names may be any input; but where it is only a slip away from a set, or resembles one
// that nothing uses, it is taken for that set's misspelt name.
void MachineReader::find_misspelt_sets() {
  std::vector<std::string> unused;
  for (const auto& [name, set] : sets_)
    if (!used_sets_.contains(name)) unused.push_back(name);
  for (const auto& [symbol, places] : symbols_) {
    if (places.size() > 1 || known_symbols_.contains(symbol) || full()) continue;
    const auto slip =
        std::find_if(sets_.begin(), sets_.end(), [&](const auto& set) { return is_slip(symbol, set.first); });
    const auto meant = slip == sets_.end() ? nearest(symbol, unused) : suggestion(slip->first);
    if (meant.empty()) continue;
    problem(places[0], fmt::format("{} is no set, and nothing else names such a symbol{}", in_quotes(symbol), meant));
  }
}

// Where there is no list of states, a name that a single place has, and that is only a slip away from one that others
// have, is taken for its misspelt name.
void MachineReader::find_misspelt_states() {
  std::vector<std::string> known;
  for (const auto& [name, places] : mentions_)
    if (places.size() > 1) known.push_back(name);
  for (const auto& [name, places] : mentions_) {
    if (places.size() > 1 || is_entry(places[0]) || full()) continue;
    if (const auto* meant = resembling(name, known))
      problem(places[0], fmt::format("nothing else names the state {}{}", in_quotes(name), suggestion(*meant)));
  }
}

}  // namespace continua
