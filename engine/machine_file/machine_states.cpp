#include "continua/machine_file/machine_states.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/machine_file/misspelling.h"

namespace continua {

StateNames::StateNames(const Item& root) {
  const auto states = root.member("states");
  if (states.is_object() && !states.json().empty()) {
    for (const auto& [name, value] : states.json().items())
      if (name != "*" && !name.empty() && index_.emplace(name, names_.size()).second) names_.push_back(name);
    return;
  }
  const auto transitions = root.member("transitions");
  if (!transitions.is_list()) return;
  for (const auto& transition : transitions.elements("transitions")) {
    const auto from = transition.member("from");
    if (from.is_list())
      for (const auto& name : from.elements("states")) add(name);
    else
      add(from);
    add(transition.member("to"));
  }
}

void StateNames::add(const Item& name) {
  if (!name.is_text() || name.json() == "*" || name.json() == "") return;
  const auto text = name.json().get<std::string>();
  if (index_.emplace(text, names_.size()).second) names_.push_back(text);
}

std::optional<StateIndex> StateNames::find(const std::string& name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<StateIndex> StateNames::named(const Item& item) {
  const auto name = item.name("a state");
  const auto state = find(name);
  if (state)
    add_mention(name, item);
  else if (!name.empty())
    item.problem(item.unknown("state", name, names_));
  return state;
}

void StateNames::report_misspelt() const {
  std::vector<std::string> known;
  for (const auto& [name, places] : mentions_)
    if (places.size() > 1) known.push_back(name);
  for (const auto& [name, places] : mentions_) {
    const bool is_entry = !places[0].is_text();  // the key in `states`: declared, so not misspelt
    if (places.size() > 1 || is_entry || places[0].reader_is_full()) continue;
    const auto meant = std::find_if(known.begin(), known.end(), [spelt = std::string_view(name)](const auto& other) {
      return is_slip(spelt, other);
    });
    if (meant != known.end())
      places[0].problem(
          fmt::format("nothing else names the state {} (did you mean {}?)", in_quotes(name), in_quotes(*meant)));
  }
}

}  // namespace continua
