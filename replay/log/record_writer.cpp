#include "continua/replay/log/record_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <utility>

#include "continua/core/characters.h"
#include "continua/replay/log/record_json.h"

namespace continua::log {
namespace {

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

bool stands_for_itself(unsigned char c) { return c >= 0x20 && c < 0x80 && c != '"' && c != '\\'; }

constexpr std::uint64_t each(std::uint64_t byte) { return byte * 0x0101010101010101; }

// A byte that is zero gets its highest bit.
constexpr std::uint64_t where_zero(std::uint64_t word) { return (word - each(0x01)) & ~word; }

// The same of eight characters at once: none is 0x80 or more, less than 0x20, a quote or a backslash.
bool all_stand_for_themselves(const char* eight) {
  std::uint64_t text = 0;
  std::memcpy(&text, eight, sizeof text);
  const auto escaped = text | (text - each(0x20)) | where_zero(text ^ each('"')) | where_zero(text ^ each('\\'));
  return (escaped & each(0x80)) == 0;
}

bool needs_no_escape(std::string_view text) {
  if (text.size() < 8) return std::all_of(text.begin(), text.end(), [](char c) { return stands_for_itself(c); });
  const auto last = text.size() - 8;
  for (std::size_t at = 0; at < last; at += 8)
    if (!all_stand_for_themselves(text.data() + at)) return false;
  return all_stand_for_themselves(text.data() + last);
}

// Where the copy ends. Most texts have eight to sixteen characters: two words, which may have some in common.
char* copied(std::string_view text, char* to) {
  const auto size = text.size();
  if (size < 8 || size > 16) return std::copy(text.begin(), text.end(), to);
  std::memcpy(to, text.data(), 8);
  std::memcpy(to + size - 8, text.data() + size - 8, 8);
  return to + size;
}

// Short texts are put together first: to append once is faster.
void add_quoted(std::string& out, std::string_view text) {
  char quoted[64];
  if (text.size() + 2 > sizeof quoted) {
    ((out += '"') += text) += '"';
    return;
  }
  quoted[0] = '"';
  *copied(text, quoted + 1) = '"';
  out.append(quoted, text.size() + 2);
}

void add(std::string& out, std::string_view text) {
  if (needs_no_escape(text)) return add_quoted(out, text);  // most texts of a log
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
  char digits[64];
  const char* end = nullptr;
  if constexpr (std::is_integral_v<Number>) {
    end = std::to_chars(std::begin(digits), std::end(digits), number).ptr;
  } else {
    if (!std::isfinite(number)) {
      out += "null";
      return;
    }
    // The digits that `compact` has: those of other libraries differ now and then.
    end = nlohmann::detail::to_chars(std::begin(digits), std::end(digits), number);
  }
  out.append(digits, static_cast<std::size_t>(end - digits));
}

void add_json(std::string& out, const Json& value) {
  bool first = true;
  const auto comma = [&] {
    if (!std::exchange(first, false)) out += ',';
  };
  switch (value.type()) {
    case Json::value_t::object:
      out += '{';
      for (const auto& [name, member] : value.get_ref<const Json::object_t&>()) {
        comma();
        add(out, name);
        out += ':';
        add_json(out, member);
      }
      out += '}';
      return;
    case Json::value_t::array:
      out += '[';
      for (const auto& element : value) {
        comma();
        add_json(out, element);
      }
      out += ']';
      return;
    case Json::value_t::string:
      return add(out, value.get_ref<const std::string&>());
    case Json::value_t::number_integer:
      return add_number(out, value.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return add_number(out, value.get<std::uint64_t>());
    case Json::value_t::number_float:
      return add_number(out, value.get<double>());
    default:
      out += compact(value);
  }
}

// The text of a value of which all parts count, or none.
template <class T>
void add_whole(std::string& out, const T& value) {
  if constexpr (is_or_null<T>) {
    if (value)
      add_whole(out, *value);
    else
      out += "null";
  } else if constexpr (is_named<T>) {
    out += '{';
    for (auto member = value.begin(); member != value.end(); ++member) {
      if (member != value.begin()) out += ',';
      add(out, member->first);
      out += ':';
      add_whole(out, member->second);
    }
    out += '}';
  } else if constexpr (is_list<T> || is_array<T>) {
    out += '[';
    for (auto element = value.begin(); element != value.end(); ++element) {
      if (element != value.begin()) out += ',';
      add_whole(out, *element);
    }
    out += ']';
  } else if constexpr (std::is_same_v<T, Json>) {
    add_json(out, value);
  } else if constexpr (std::is_same_v<T, JsonText>) {
    out += value.text;
  } else if constexpr (std::is_same_v<T, bool>) {
    out += value ? "true" : "false";
  } else if constexpr (std::is_arithmetic_v<T>) {
    add_number(out, value);
  } else {
    add(out, value);
  }
}

// A line and its decision, which lacks parts of the line and else has the same bytes.
struct Texts {
  std::string& line;
  std::string* decision = nullptr;  // null: nothing counts for it

  void append(std::string_view text) const {
    line += text;
    if (decision) *decision += text;
  }
};

// Members with commas between them, in braces.
class Members {
 public:
  explicit Members(Texts texts) : texts_(texts) { texts_.append("{"); }
  /// From now on members count for this decision, in which braces are open.
  void decide(std::string& decision) {
    texts_.decision = &decision;
    to_copy_from_ = to_copy_to_ = 0;
  }
  void end() {
    copy_to_decision();
    texts_.append("}");
  }

  /// The texts for the value of a member. `decides`: it counts for the decision.
  Texts member(std::string_view name, bool decides = true) {
    begin(name, decides);
    if (!decides) return {texts_.line};
    to_copy_to_ = texts_.line.size();
    copy_to_decision();
    return texts_;
  }
  /// A member of which all parts count, or none.
  template <class T>
  void whole(std::string_view name, const T& value, bool decides = true) {
    begin(name, decides);
    add_whole(texts_.line, value);
    if (decides) to_copy_to_ = texts_.line.size();
  }
  /// The same of a name from data, which may need escapes.
  template <class T>
  void named(std::string_view name, const T& value) {
    begin_copy(true);
    if (std::exchange(has_any_, true)) texts_.line += ',';
    add(texts_.line, name);
    texts_.line += ':';
    add_whole(texts_.line, value);
    to_copy_to_ = texts_.line.size();
  }

 private:
  static constexpr std::size_t longest_name = 60;

  // The comma and the name.
  void begin(std::string_view name, bool decides) {
    require(name.size() <= longest_name, "a field of a record has a short name");
    begin_copy(decides);
    char key[longest_name + 4];
    auto* end = key;
    if (std::exchange(has_any_, true)) *end++ = ',';
    *end++ = '"';
    end = copied(name, end);
    *end++ = '"';
    *end++ = ':';
    texts_.line.append(key, static_cast<std::size_t>(end - key));
  }

  // Members that count and follow one another are copied together.
  void begin_copy(bool decides) {
    if (decides && to_copy_to_ == texts_.line.size()) return;
    copy_to_decision();
    to_copy_from_ = to_copy_to_ = texts_.line.size();
  }
  // A comma that the line has, since other members are before it, may be none of the decision's.
  void copy_to_decision() {
    if (!texts_.decision || to_copy_from_ == to_copy_to_) return;
    const bool needs_comma = std::exchange(decides_any_, true);
    if (!needs_comma && texts_.line[to_copy_from_] == ',') ++to_copy_from_;
    texts_.decision->append(texts_.line, to_copy_from_, to_copy_to_ - to_copy_from_);
    to_copy_from_ = to_copy_to_;
  }

  Texts texts_;
  bool has_any_ = false, decides_any_ = false;
  std::size_t to_copy_from_ = 0, to_copy_to_ = 0;  // in the line
};

// The text of a value that declares which of its parts count, or that consists of such.
template <class T>
void add_parts(Texts texts, const T& value) {
  if constexpr (HasFields<T>) {
    Members members(texts);
    add_members(members, value);
    members.end();
  } else if constexpr (is_or_null<T>) {
    if (value)
      add_parts(texts, *value);
    else
      texts.append("null");
  } else {
    static_assert(is_list<T>, "parts that count are in a record's members, or in lists of such");
    texts.append("[");
    for (auto element = value.begin(); element != value.end(); ++element) {
      if (element != value.begin()) texts.append(",");
      add_parts(texts, *element);
    }
    texts.append("]");
  }
}

template <class T>
void add_member(Members& members, const Declaration& field, const T& value) {
  const bool decides = field.says != Says::aside && !field.follows;
  if constexpr (is_optional<T>) {
    if (value) add_member(members, field, *value);
  } else if constexpr (HasFields<Innermost<T>>) {
    add_parts(members.member(field.name, decides), value);
  } else {
    members.whole(field.name, value, decides);
  }
}

template <class T>
void add_members(Members& members, const T& value) {
  for_each_field<T>([&](const auto& field) { add_member(members, field, value.*(field.member)); });
}

void add_record(Members& members, const Record& record) {
  std::visit(
      [&]<class T>(const T& known) {
        if constexpr (std::is_same_v<T, Unknown>)
          for (const auto& [name, value] : known.members.items()) members.named(name, value);
        else
          add_members(members, known);
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

// {"kind":K,"n":N,"t":T,…} and {"kind":K,"fields":{…},"t":T}
void add_text(const Stamp& stamp, const Record& record, std::string& line, std::string& decision) {
  constexpr auto n = name_of(&Stamp::n), t = name_of(&Stamp::t_s), cause = name_of(&Stamp::cause),
                 measured = name_of(&Stamp::measured);
  Members members({line});
  members.whole("kind", kind_of(record));
  members.whole(n, stamp.n);
  const auto time_from = line.size();
  members.whole(t, stamp.t_s);
  const auto time_to = line.size();
  if (stamp.cause) members.whole(cause, *stamp.cause);
  const auto counts = decision_of(record);
  if (counts != Decision::no) {
    Members decided({decision});
    decided.whole("kind", kind_of(record));
    decided.member("fields").append("{");
    members.decide(decision);
  }
  add_record(members, record);
  if (stamp.measured) members.whole(measured, true);
  members.end();
  if (counts == Decision::no) return;
  if (counts == Decision::yes && !stamp.measured) decision.append(line, time_from, time_to - time_from);
  decision += '}';
}

}  // namespace continua::log
