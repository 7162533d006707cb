#include "continua/replay/log/record_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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

constexpr auto in_no_need_of_escape = [] {
  std::array<bool, 256> told{};
  for (unsigned byte = 0x20; byte < 0x80; ++byte) told[byte] = byte != '"' && byte != '\\';
  return told;
}();

bool stands_for_itself(char c) { return in_no_need_of_escape[static_cast<unsigned char>(c)]; }

void add(std::string& out, std::string_view text) {
  if (std::all_of(text.begin(), text.end(), stands_for_itself)) {  // as most texts of a log
    out += '"';
    out += text;
    out += '"';
    return;
  }
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

// A line and its decision, which lacks parts of the line and else has the same bytes.
struct Texts {
  std::string& line;
  std::string* decision = nullptr;  // null: nothing counts for it

  /// Appends to both what `one(out)` appends to its argument.
  template <class Write>
  void write(const Write& one) const {
    const auto from = line.size();
    one(line);
    if (decision) decision->append(line, from);
  }
  void append(std::string_view text) const {
    write([text](std::string& out) { out += text; });
  }
};

// Members with commas between them, in braces.
class Members {
 public:
  explicit Members(Texts texts) : texts_(texts) { texts_.append("{"); }
  /// From now on members count for this decision, in which braces are open.
  void decide(std::string& decision) { texts_.decision = &decision; }
  void end() const { texts_.append("}"); }

  /// The texts for the value of a member. `decides`: it counts for the decision.
  Texts member(std::string_view name, bool decides = true) {
    // Put together first: a log has more names than anything else.
    std::array<char, longest_name + 4> key = {',', '"'};
    require(name.size() <= longest_name, "a field of a record has a short name");
    auto* end = std::copy(name.begin(), name.end(), key.begin() + 2);
    *end++ = '"';
    *end++ = ':';
    const std::string_view with_comma(key.begin(), end);
    const auto append = [&](std::string& out, bool& has_any) {
      out += std::exchange(has_any, true) ? with_comma : with_comma.substr(1);
    };
    const Texts texts{texts_.line, decides ? texts_.decision : nullptr};
    append(texts.line, has_any_);
    if (texts.decision) append(*texts.decision, decides_any_);
    return texts;
  }
  /// The same of a name from data, which may need escapes.
  Texts named(std::string_view name) {
    if (std::exchange(has_any_, true)) texts_.line += ',';
    if (texts_.decision && std::exchange(decides_any_, true)) *texts_.decision += ',';
    texts_.write([name](std::string& out) {
      add(out, name);
      out += ':';
    });
    return texts_;
  }

 private:
  static constexpr std::size_t longest_name = 60;

  Texts texts_;
  bool has_any_ = false, decides_any_ = false;
};

template <class T>
void add_value(Texts texts, const T& value);

template <class T>
void add_members(Members& members, const T& value) {
  for_each_field<T>([&](const auto& field) {
    const auto& member = value.*(field.member);
    const bool decides = field.says != Says::aside && !field.follows;
    if constexpr (is_optional<std::decay_t<decltype(member)>>) {
      if (member) add_value(members.member(field.name, decides), *member);
    } else {
      add_value(members.member(field.name, decides), member);
    }
  });
}

template <class T>
void add_list(Texts texts, const T& list) {
  texts.append("[");
  for (auto element = list.begin(); element != list.end(); ++element) {
    if (element != list.begin()) texts.append(",");
    add_value(texts, *element);
  }
  texts.append("]");
}

template <class T>
void add_value(Texts texts, const T& value) {
  if constexpr (HasFields<T>) {
    Members members(texts);
    add_members(members, value);
    members.end();
  } else if constexpr (is_or_null<T>) {
    if (value)
      add_value(texts, *value);
    else
      texts.append("null");
  } else if constexpr (is_named<T>) {
    Members members(texts);
    for (const auto& [name, member] : value) add_value(members.named(name), member);
    members.end();
  } else if constexpr (is_list<T> || is_array<T>) {
    add_list(texts, value);
  } else {
    texts.write([&](std::string& out) {
      if constexpr (std::is_same_v<T, Json>)
        add_json(out, value);
      else if constexpr (std::is_same_v<T, JsonText>)
        out += value.text;
      else if constexpr (std::is_same_v<T, bool>)
        out += value ? "true" : "false";
      else if constexpr (std::is_arithmetic_v<T>)
        add_number(out, value);
      else
        add(out, value);
    });
  }
}

void add_record(Members& members, const Record& record) {
  std::visit(
      [&]<class T>(const T& known) {
        if constexpr (std::is_same_v<T, Unknown>)
          for (const auto& [name, value] : known.members.items()) add_value(members.named(name), value);
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
  add_value(members.member("kind"), kind_of(record));
  add_value(members.member(n), stamp.n);
  add_value(members.member(t), stamp.t_s);
  if (stamp.cause) add_value(members.member(cause), *stamp.cause);
  const auto counts = decision_of(record);
  if (counts != Decision::no) {
    Members decided({decision});
    add_value(decided.member("kind"), kind_of(record));
    decided.member("fields").append("{");
    members.decide(decision);
  }
  add_record(members, record);
  if (stamp.measured) add_value(members.member(measured), true);
  members.end();
  if (counts == Decision::no) return;
  if (counts == Decision::yes && !stamp.measured) {
    ((decision += ",\"") += t) += "\":";
    add_number(decision, stamp.t_s);
  }
  decision += '}';
}

}  // namespace continua::log
