#include "continua/term/name.h"

#include <mutex>
#include <unordered_set>

namespace continua {
namespace {

struct Texts {
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  std::mutex mutex;
  std::unordered_set<std::string, Hash, std::equal_to<>> known;  // its elements stay where they are
};

Texts& texts() {
  static auto* const all = new Texts();  // never destroyed: names outlive everything
  return *all;
}

}  // namespace

Name::Name(std::string_view text) {
  auto& all = texts();
  const std::lock_guard lock(all.mutex);
  const auto found = all.known.find(text);
  text_ = found == all.known.end() ? &*all.known.emplace(text).first : &*found;
}

}  // namespace continua
