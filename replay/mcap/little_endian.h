// Numbers and texts in bytes, least byte first, as MCAP and little-endian CDR have them.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace continua {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

/// Appends a number.
template <class Number>
requires std::is_arithmetic_v<Number>
void put_number(std::string& bytes, Number number) {
  char copy[sizeof number];
  std::memcpy(copy, &number, sizeof number);
  bytes.append(copy, sizeof number);
}

/// Appends a text after its length, 32 bits.
inline void put_text(std::string& bytes, std::string_view text) {
  put_number(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

/// Reads bytes from their beginning. Whoever reads behind their end gets zeros and empty texts, and is told by `ok`.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Number>
  Number number() {
    Number number{};
    if (const auto read = view(sizeof number); ok_) std::memcpy(&number, read.data(), sizeof number);
    return number;
  }

  /// The next so many bytes.
  std::string_view view(std::uint64_t size) {
    if (!ok_ || size > left()) {
      ok_ = false;
      return {};
    }
    const auto read = bytes_.substr(at_, size);
    at_ += size;
    return read;
  }

  /// A text after its length, 32 bits.
  std::string_view text() { return view(number<std::uint32_t>()); }

  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }
  bool ok() const { return ok_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace continua
