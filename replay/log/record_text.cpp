#include "continua/replay/log/record_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "continua/core/characters.h"

namespace continua::log {
namespace {

bool stands_for_itself(unsigned char c) { return c >= 0x20 && c < 0x80 && c != '"' && c != '\\'; }

constexpr std::uint64_t each(std::uint64_t byte) { return byte * 0x0101010101010101; }

// A byte that is zero gets its highest bit.
constexpr std::uint64_t where_zero(std::uint64_t word) { return (word - each(0x01)) & ~word; }

// Eight characters at once: no highest bit is set if none of them is 0x80 or more, or less than 0x20.
constexpr std::uint64_t where_special(std::uint64_t eight) { return eight | (eight - each(0x20)); }

std::uint64_t eight_from(const char* text) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, text, sizeof eight);
  return eight;
}

// None is such, nor a quote or a backslash.
bool all_stand_for_themselves(std::uint64_t eight) {
  const auto escaped = where_special(eight) | where_zero(eight ^ each('"')) | where_zero(eight ^ each('\\'));
  return (escaped & each(0x80)) == 0;
}

bool needs_no_escape(std::string_view text) {
  if (text.size() < 8) return std::all_of(text.begin(), text.end(), [](char c) { return stands_for_itself(c); });
  const auto last = text.size() - 8;
  for (std::size_t at = 0; at < last; at += 8)
    if (!all_stand_for_themselves(eight_from(text.data() + at))) return false;
  return all_stand_for_themselves(eight_from(text.data() + last));
}

// All is UTF-8, and its only control characters are line breaks.
bool is_plain(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    if (at + 8 <= text.size() && (where_special(eight_from(text.data() + at)) & each(0x80)) == 0) {
      at += 8;
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[at]);
    const auto length = byte < 0x80 ? 1 : character_length(text.substr(at));
    if ((byte < 0x20 && byte != '\n') || length == 0) return false;
    at += length;
  }
  return true;
}

}  // namespace

void RecordText::put_text(std::string_view text) {
  if (needs_no_escape(text)) {  // most texts of a log
    auto* to = room(text.size() + 2);
    *to++ = '"';
    to = copied(text, to);
    *to++ = '"';
    return set_end(to);
  }
  if (!is_plain(text)) return put(compact(Json(text)));
  auto* to = room(2 * text.size() + 2);
  *to++ = '"';
  for (std::size_t at = 0; at < text.size();) {
    if (at + 8 <= text.size() && all_stand_for_themselves(eight_from(text.data() + at))) {
      std::memcpy(to, text.data() + at, 8);
      to += 8;
      at += 8;
      continue;
    }
    const char c = text[at++];
    if (c == '"' || c == '\\' || c == '\n') *to++ = '\\';
    *to++ = c == '\n' ? 'n' : c;
  }
  *to++ = '"';
  set_end(to);
}

void RecordText::put_number(double number) {
  if (number == 1) return put("1.0");  // most weights and probabilities
  if (!std::isfinite(number)) return put("null");
  constexpr std::size_t most_digits = 64;
  auto* to = room(most_digits);
  // The digits that `compact` has: those of other libraries differ now and then.
  set_end(nlohmann::detail::to_chars(to, to + most_digits, number));
}

void RecordText::put_json(const Json& value) {
  bool first = true;
  const auto comma = [&] {
    if (!std::exchange(first, false)) put(',');
  };
  switch (value.type()) {
    case Json::value_t::object:
      put('{');
      for (const auto& [name, member] : value.get_ref<const Json::object_t&>()) {
        comma();
        put_text(name);
        put(':');
        put_json(member);
      }
      put('}');
      return;
    case Json::value_t::array:
      put('[');
      for (const auto& element : value) {
        comma();
        put_json(element);
      }
      put(']');
      return;
    case Json::value_t::string:
      return put_text(value.get_ref<const std::string&>());
    case Json::value_t::number_integer:
      return put_number(value.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return put_number(value.get<std::uint64_t>());
    case Json::value_t::number_float:
      return put_number(value.get<double>());
    case Json::value_t::boolean:
      return put(value.get<bool>() ? "true" : "false");
    case Json::value_t::null:
      return put("null");
    default:
      put(compact(value));
  }
}

}  // namespace continua::log
