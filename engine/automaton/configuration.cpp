#include "automaton/configuration.h"

#include <algorithm>

namespace continua {
namespace {

bool same_top(const Stack& a, const Stack& b) {
  return a.empty() || b.empty() ? a.empty() == b.empty() : same_values(a.top(), b.top());
}

}  // namespace

History History::entered(std::size_t landmark, std::size_t count, Stack stack) const {
  auto entries = entries_ ? *entries_ : std::vector<Entries>(count);
  entries[landmark].earlier = std::move(entries[landmark].latest);
  entries[landmark].latest = std::move(stack);
  History grown;
  grown.entries_ = std::make_shared<const std::vector<Entries>>(std::move(entries));
  return grown;
}

const Stack* History::entry(std::size_t landmark, std::size_t skip) const {
  if (!entries_) return nullptr;
  const auto& found = skip == 0 ? (*entries_)[landmark].latest : (*entries_)[landmark].earlier;
  return found.empty() ? nullptr : &found;
}

bool History::operator==(const History& other) const {
  if (entries_ == other.entries_) return true;
  if (!entries_ || !other.entries_) return false;
  return std::equal(entries_->begin(), entries_->end(), other.entries_->begin(), other.entries_->end(),
                    [](const Entries& a, const Entries& b) {
                      return same_top(a.latest, b.latest) && same_top(a.earlier, b.earlier);
                    });
}

bool Configuration::same_as(const Configuration& other) const {
  return state == other.state && history == other.history && stack == other.stack &&
         same_values(*memory, *other.memory);
}

}  // namespace continua
