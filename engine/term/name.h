// Names of constants. They are interned, so that they are compared and looked up by address.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace continua {

/// A value as small as a pointer. The text of each name is kept once, for the life of the program.
class Name {
 public:
  /// May be called from any thread.
  explicit Name(std::string_view text);

  const std::string& text() const { return *text_; }
  /// Equal texts. Names have no order, because addresses differ from run to run.
  bool operator==(const Name&) const = default;

  struct Hash {
    std::size_t operator()(Name name) const { return std::hash<const void*>()(name.text_); }
  };

 private:
  const std::string* text_;
};

}  // namespace continua
