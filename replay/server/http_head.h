// The head of a request: read strictly and within limits, so that two readers of it cannot disagree.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace continua {

/// The most that a request may have, in bytes but for `header_lines`. A longer one is refused with 414, 431 or 413.
struct HttpLimits {
  static constexpr std::size_t line = 8192;
  static constexpr std::size_t head = 32768;
  static constexpr std::size_t header_lines = 100;
  static constexpr std::size_t body = std::size_t{1} << 20;
};

/// An answer that needs nothing but the head.
struct HttpAnswer {
  int status = 400;
  std::string sentence;                                      ///< for people; empty: no body
  std::vector<std::pair<std::string, std::string>> headers;  ///< besides those of every answer
};

/// The header by which answers learn what Range asked for: the library would cut every answer by that itself.
inline constexpr const char* passed_range = "Continua-Range";

struct HttpHead {
  std::string method, target;  ///< the target with its query, as it was sent
  std::vector<std::pair<std::string, std::string>> headers;
  std::size_t body = 0;      ///< bytes that follow
  bool keeps_alive = false;  ///< whether another request may follow

  /// The first of that name, in any case; null if there is none.
  const std::string* header(std::string_view name) const;
  /// The same; empty if there is none.
  std::string_view value(std::string_view name) const;

  /// As the library is to read it, without what is done already: expectations, transfer. A range is
  /// passed on as `passed_range`, unless it depends on a state (If-Range) that answers do not tell.
  std::string text() const;
};

/// Finds the end of a head that comes in pieces.
class HeadScan {
 public:
  /// `text`: all that came. Bytes of the head once it is whole; none: more is needed; or a refusal.
  std::variant<std::optional<std::size_t>, HttpAnswer> look(std::string_view text);

 private:
  std::size_t line_ = 0, looked_ = 0, lines_ = 0;
};

/// `text`: with the empty line at its end. Refused: anything but HTTP/1.x as it should be, more than one of a header
/// that must be one, and bodies that are packed, or of no known length.
std::variant<HttpHead, HttpAnswer> read_head(std::string_view text);

}  // namespace continua
