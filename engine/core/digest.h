// Digests: short names for content, equal on every machine. XXH3-128, printed as 32 hexadecimal digits.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace continua {

std::string digest(std::string_view bytes);

/// A number for content, equal on every machine: XXH3-64. For comparisons in memory; files have digests.
std::uint64_t hash_of(std::string_view bytes);

/// A digest of bytes that arrive piece by piece; equal to `digest` of their concatenation.
class RunningDigest {
 public:
  RunningDigest();
  ~RunningDigest();
  RunningDigest(RunningDigest&&) noexcept;
  RunningDigest& operator=(RunningDigest&&) noexcept;

  void add(std::string_view bytes);
  std::string text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace continua
