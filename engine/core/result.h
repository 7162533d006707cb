// A value, or the reason why there is none. Bad input is an expected result with a place and a sentence; a broken
// invariant stops the program (see `require`).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace continua {

/// The reason of a failure, for people.
struct Error {
  std::string where;     ///< "file", "file:line" or "file:line:column"; empty if there is no place
  std::string sentence;  ///< the found and the expected thing

  /// "where: sentence", one line.
  std::string text() const { return where.empty() ? sentence : where + ": " + sentence; }
};

/// Stops the program with `sentence` if an invariant of the program is broken. Never used for bad input.
void require(bool holds, const char* sentence);

/// Holds a T or an Error, never both.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : held_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : held_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return held_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// REQUIRES ok().
  const T& value() const& {
    require(ok(), "value() of a Result that holds an error");
    return std::get<0>(held_);
  }
  T& value() & {
    require(ok(), "value() of a Result that holds an error");
    return std::get<0>(held_);
  }
  T&& value() && {
    require(ok(), "value() of a Result that holds an error");
    return std::get<0>(std::move(held_));
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  /// REQUIRES !ok().
  const Error& error() const {
    require(!ok(), "error() of a Result that holds a value");
    return std::get<1>(held_);
  }

 private:
  std::variant<T, Error> held_;
};

/// The outcome of an operation without a value: nothing, or its error.
using Outcome = std::optional<Error>;

}  // namespace continua
