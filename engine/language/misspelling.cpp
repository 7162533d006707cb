#include "continua/language/misspelling.h"

#include <algorithm>

namespace continua {

Slip slip(std::string_view written, std::string_view meant) {
  const auto shared_front = static_cast<std::size_t>(
      std::mismatch(written.begin(), written.end(), meant.begin(), meant.end()).first - written.begin());
  auto rest = written.substr(shared_front), other = meant.substr(shared_front);
  while (!rest.empty() && !other.empty() && rest.back() == other.back()) {
    rest.remove_suffix(1);
    other.remove_suffix(1);
  }
  if (rest.size() == 2 && other.size() == 2)
    return rest[0] == other[1] && rest[1] == other[0] ? Slip::exchanged : Slip::none;
  if (rest.size() == 1 && other.size() == 1) return Slip::replaced;
  if (rest.size() + other.size() != 1) return Slip::none;
  if (shared_front == 0) return Slip::first;
  return rest.empty() ? Slip::missing : Slip::added;
}

bool is_of_the_fingers(Slip slip) { return slip == Slip::exchanged || slip == Slip::missing || slip == Slip::added; }

}  // namespace continua
