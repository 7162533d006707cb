#include "continua/core/local_time.h"

namespace continua {

bool is_local_time(std::string_view text) {
  constexpr std::string_view shape = "dddd-dd-ddTdd:dd:dd";
  if (text.size() != 10 && text.size() != 16 && text.size() != 19) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (shape[i] == 'd' ? text[i] < '0' || text[i] > '9' : text[i] != shape[i]) return false;
  const auto number = [&](std::size_t at) { return (text[at] - '0') * 10 + (text[at + 1] - '0'); };
  const int month = number(5), day = number(8);
  if (month < 1 || month > 12 || day < 1 || day > 31) return false;
  if (text.size() > 10 && (number(11) > 23 || number(14) > 59)) return false;
  return text.size() < 19 || number(17) <= 60;
}

}  // namespace continua
