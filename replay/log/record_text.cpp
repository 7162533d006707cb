#include "continua/replay/log/record_text.h"

#include <charconv>
#include <cmath>
#include <iterator>

#include "continua/core/characters.h"
#include "continua/replay/log/record_json.h"

namespace continua::log {
namespace {

enum class Part : bool { all, decision };

// Neither control characters nor bytes that are not UTF-8.
bool is_plain(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const auto length = byte < 0x80 ? 1 : character_length(text.substr(at));
    if (byte < 0x20 || length == 0) return false;
    at += length;
  }
  return true;
}

void add(std::string& out, std::string_view text) {
  if (!is_plain(text)) {
    out += compact(Json(text));
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  out += '"';
}

template <class Number>
void add_number(std::string& out, Number number) {
  if constexpr (std::is_integral_v<Number>) {
    char digits[24];
    out.append(digits, std::to_chars(std::begin(digits), std::end(digits), number).ptr);
  } else {
    if (!std::isfinite(number)) {
      out += "null";
      return;
    }
    // The digits that `compact` has: those of other libraries differ now and then.
    char digits[64];
    out.append(digits, nlohmann::detail::to_chars(std::begin(digits), std::end(digits), number));
  }
}

// Members with commas between them, in braces.
class Members {
 public:
  explicit Members(std::string& out) : out_(out) { out_ += '{'; }
  void name(std::string_view name) {
    if (!first_) out_ += ',';
    first_ = false;
    add(out_, name);
    out_ += ':';
  }
  void end() { out_ += '}'; }

 private:
  std::string& out_;
  bool first_ = true;
};

template <class T>
void add_value(std::string& out, const T& value, Part part);

template <class T>
void add_members(std::string& out, Members& members, const T& value, Part part) {
  for_each_field<T>([&](const auto& field) {
    const auto& member = value.*(field.member);
    if (part == Part::decision && (field.says == Says::aside || field.follows)) return;
    if constexpr (is_optional<std::decay_t<decltype(member)>>) {
      if (!member) return;
      members.name(field.name);
      add_value(out, *member, part);
    } else {
      members.name(field.name);
      add_value(out, member, part);
    }
  });
}

template <class T>
void add_list(std::string& out, const T& list, Part part) {
  out += '[';
  for (auto element = list.begin(); element != list.end(); ++element) {
    if (element != list.begin()) out += ',';
    add_value(out, *element, part);
  }
  out += ']';
}

template <class T>
void add_value(std::string& out, const T& value, Part part) {
  if constexpr (HasFields<T>) {
    Members members(out);
    add_members(out, members, value, part);
    members.end();
  } else if constexpr (is_or_null<T>) {
    if (value)
      add_value(out, *value, part);
    else
      out += "null";
  } else if constexpr (is_named<T>) {
    Members members(out);
    for (const auto& [name, member] : value) {
      members.name(name);
      add_value(out, member, part);
    }
    members.end();
  } else if constexpr (is_list<T> || is_array<T>) {
    add_list(out, value, part);
  } else if constexpr (std::is_same_v<T, Json>) {
    out += compact(value);
  } else if constexpr (std::is_same_v<T, bool>) {
    out += value ? "true" : "false";
  } else if constexpr (std::is_arithmetic_v<T>) {
    add_number(out, value);
  } else {
    add(out, value);
  }
}

void add_fields(std::string& out, Members& members, const Record& record, Part part) {
  std::visit(
      [&]<class T>(const T& known) {
        if constexpr (std::is_same_v<T, Unknown>) {
          for (const auto& [name, value] : known.members.items()) {
            members.name(name);
            out += compact(value);
          }
        } else {
          add_members(out, members, known, part);
        }
      },
      record);
}

Decision decision_of(const Record& record) {
  return std::visit(
      []<class T>(const T&) {
        if constexpr (std::is_same_v<T, Unknown>)
          return Decision::no;
        else
          return T::kind.decision;
      },
      record);
}

}  // namespace

std::string text_of(const Stamp& stamp, const Record& record) {
  std::string text;
  Members members(text);
  members.name("kind");
  add(text, kind_of(record));
  members.name(name_of(&Stamp::n));
  add_number(text, stamp.n);
  members.name(name_of(&Stamp::t_s));
  add_number(text, stamp.t_s);
  if (stamp.cause) {
    members.name(name_of(&Stamp::cause));
    add_number(text, *stamp.cause);
  }
  add_fields(text, members, record, Part::all);
  if (stamp.measured) {
    members.name(name_of(&Stamp::measured));
    text += "true";
  }
  members.end();
  return text;
}

std::optional<std::string> decision_text_of(const Stamp& stamp, const Record& record) {
  const auto decision = decision_of(record);
  if (decision == Decision::no) return std::nullopt;
  std::string text;
  Members members(text);
  members.name("kind");
  add(text, kind_of(record));
  members.name("fields");
  Members fields(text);
  add_fields(text, fields, record, Part::decision);
  if (stamp.measured) {
    fields.name(name_of(&Stamp::measured));
    text += "true";
  }
  fields.end();
  if (decision == Decision::yes && !stamp.measured) {
    members.name(name_of(&Stamp::t_s));
    add_number(text, stamp.t_s);
  }
  members.end();
  return text;
}

}  // namespace continua::log
