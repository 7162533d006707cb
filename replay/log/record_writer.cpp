#include "continua/replay/log/record_writer.h"

#include <utility>

#include "continua/replay/log/record_json.h"

namespace continua::log {
namespace {

// The text of a value of which all parts count, or none.
template <class T>
void add_whole(RecordText& out, const T& value) {
  if constexpr (is_or_null<T>) {
    if (value)
      add_whole(out, *value);
    else
      out.put("null");
  } else if constexpr (is_named<T>) {
    out.put('{');
    for (auto member = value.begin(); member != value.end(); ++member) {
      if (member != value.begin()) out.put(',');
      out.put_text(member->first);
      out.put(':');
      add_whole(out, member->second);
    }
    out.put('}');
  } else if constexpr (is_list<T> || is_array<T>) {
    out.put('[');
    for (auto element = value.begin(); element != value.end(); ++element) {
      if (element != value.begin()) out.put(',');
      add_whole(out, *element);
    }
    out.put(']');
  } else if constexpr (std::is_same_v<T, Json>) {
    out.put_json(value);
  } else if constexpr (std::is_same_v<T, JsonText>) {
    out.put(value.text);
  } else if constexpr (std::is_same_v<T, bool>) {
    out.put(value ? "true" : "false");
  } else if constexpr (std::is_arithmetic_v<T>) {
    out.put_number(value);
  } else {
    out.put_text(value);
  }
}

// A line, and its decision: the same bytes without some of the members.
struct Texts {
  RecordText& line;
  RecordText* decision = nullptr;  // null: nothing counts for it

  void append(std::string_view text) const {
    line.put(text);
    if (decision) decision->put(text);
  }
};

// Members with commas between them, in braces.
class Members {
 public:
  explicit Members(Texts texts) : texts_(texts) { texts_.append("{"); }
  /// From now on members count for this decision, in which braces are open.
  void decide(RecordText& decision) {
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
    if (std::exchange(has_any_, true)) texts_.line.put(',');
    texts_.line.put_text(name);
    texts_.line.put(':');
    add_whole(texts_.line, value);
    to_copy_to_ = texts_.line.size();
  }

 private:
  // The comma and the name.
  void begin(std::string_view name, bool decides) {
    begin_copy(decides);
    texts_.line.put_name(name, !std::exchange(has_any_, true));
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
    if (!needs_comma && texts_.line.view()[to_copy_from_] == ',') ++to_copy_from_;
    texts_.decision->put(texts_.line.view().substr(to_copy_from_, to_copy_to_ - to_copy_from_));
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
void RecordWriter::add(const Stamp& stamp, const Record& record, RecordText& line, RecordText& decision) {
  if (t_s_ != stamp.t_s) {
    t_s_ = stamp.t_s;
    t_.clear();
    t_.put_number(t_s_);
  }
  constexpr auto n = name_of(&Stamp::n), t = name_of(&Stamp::t_s), cause = name_of(&Stamp::cause),
                 measured = name_of(&Stamp::measured);
  Members members({line});
  members.whole("kind", kind_of(record));
  members.whole(n, stamp.n);
  const auto time_from = line.size();
  members.member(t).line.put(t_.view());
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
  if (counts == Decision::yes && !stamp.measured) decision.put(line.view().substr(time_from, time_to - time_from));
  decision.put('}');
}

}  // namespace continua::log
