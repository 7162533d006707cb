// The content of a term as 128 bits, by which terms are compared, hashed and kept in tables.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <string_view>

namespace continua {

/// Equal for equal terms, in every thread and process and on every machine. Two different terms have equal digests with
/// the probability of a random collision, 2^-128 for each pair. The order means nothing, but is the same everywhere.
struct TermDigest {
  std::uint64_t high = 0, low = 0;
  auto operator<=>(const TermDigest&) const = default;
};

/// Computes a digest of words, two at a time, and of digests of parts; the order counts. The steps are those of
/// MurmurHash3_x64_128 (Appleby, public domain), on words instead of bytes, so that the machine's byte order does not
/// matter.
class TermDigester {
 public:
  /// `kind` makes terms of different kinds with the same parts differ.
  explicit TermDigester(std::uint64_t kind) { add(kind, 0); }

  void add(const TermDigest& part) { add(part.high, part.low); }

  void add(std::uint64_t a, std::uint64_t b) {
    high_ ^= std::rotl(a * first_, 31) * second_;
    high_ = (std::rotl(high_, 27) + low_) * 5 + 0x52dce729;
    low_ ^= std::rotl(b * second_, 33) * first_;
    low_ = (std::rotl(low_, 31) + high_) * 5 + 0x38495ab5;
  }

  void add(std::string_view bytes) {
    add(bytes.size(), 0);
    for (; !bytes.empty(); bytes.remove_prefix(bytes.size() < 16 ? bytes.size() : 16))
      add(word(bytes), bytes.size() > 8 ? word(bytes.substr(8)) : 0);
  }

  TermDigest digest() const {
    std::uint64_t high = high_ + low_, low = low_ + high;
    high = mixed(high);
    low = mixed(low);
    high += low;
    return {high, low + high};
  }

 private:
  // The first eight bytes as a word; the first byte is the lowest.
  static std::uint64_t word(std::string_view bytes) {
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < bytes.size() && i < 8; ++i)
      result |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return result;
  }

  static std::uint64_t mixed(std::uint64_t word) {
    word = (word ^ (word >> 33)) * 0xff51afd7ed558ccd;
    word = (word ^ (word >> 33)) * 0xc4ceb9fe1a85ec53;
    return word ^ (word >> 33);
  }

  static constexpr std::uint64_t first_ = 0x87c37b91114253d5, second_ = 0x4cf5ad432745937f;
  std::uint64_t high_ = 0, low_ = 0;
};

}  // namespace continua
