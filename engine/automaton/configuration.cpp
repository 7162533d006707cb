#include "continua/automaton/configuration.h"

#include <algorithm>
#include <utility>

namespace continua {
namespace {

bool same_top(const Stack& a, const Stack& b) {
  return a.empty() || b.empty() ? a.empty() == b.empty() : same_values(a.top(), b.top());
}

}  // namespace

History History::entered(std::optional<std::size_t> landmark, std::size_t count, const Stack& stack) const {
  History after;
  after.latest_ = latest_;
  if (!landmark) return after;
  auto latest = latest_ ? *latest_ : std::vector<Stack>(count);
  after.before_ = std::exchange(latest[*landmark], stack);
  after.latest_ = std::make_shared<const std::vector<Stack>>(std::move(latest));
  return after;
}

const Stack* History::entry(std::size_t landmark, bool present) const {
  if (!latest_) return nullptr;
  const auto& found = present ? before_ : (*latest_)[landmark];
  return found.empty() ? nullptr : &found;
}

bool History::operator==(const History& other) const {
  if (!same_top(before_, other.before_)) return false;
  if (latest_ == other.latest_) return true;
  if (!latest_ || !other.latest_) return false;
  return std::equal(latest_->begin(), latest_->end(), other.latest_->begin(), other.latest_->end(), same_top);
}

bool Configuration::same_as(const Configuration& other) const {
  return state == other.state && history == other.history && stack == other.stack &&
         same_values(*memory, *other.memory);
}

}  // namespace continua
