#include "continua/replay/log/records.h"

#include <cmath>
#include <limits>

#include "continua/replay/log/record_json.h"

namespace continua::log {
namespace {

// Where a kind is missing its sentence, the compiler says so here.
constexpr bool all_kinds_have_a_brief() {
  for_each_kind([]<class T>() {
    static_assert(IsRecord<T>, "a kind of record has a constant `kind` and a list `fields()`");
    static_assert(HasBrief<T>, "a kind of record has `std::string brief() const`, its sentence for people");
  });
  return true;
}
static_assert(all_kinds_have_a_brief());

Unknown unknown(std::string_view name, const Json& line) {
  Unknown record{std::string(name), line};
  if (!line.is_object()) return record;
  for (const char* member : {"kind", "n", "t", "cause"}) record.members.erase(member);
  return record;
}

template <class T>
void take(const Json& object, const char* name, T& value) {
  if (const auto* found = find_member(object, name)) (void)read_value(*found, value);
}

}  // namespace

Result<Record> read_record(const Json& line, const std::string& where) {
  if (!line.is_object()) return Error{where, unexpected("a record", line).sentence};
  const auto name = line.find("kind");
  if (name == line.end() || !name->is_string()) return Error{where, "a record without 'kind'"};
  const auto& kind = name->get_ref<const std::string&>();
  std::optional<Record> record;
  Outcome problem;
  for_each_kind([&]<class T>() {
    if (record || T::kind.name != kind) return;
    problem = read_members(line, std::get<T>(record.emplace(T{})));
  });
  if (!record) return Record(unknown(kind, line));
  if (problem) return Error{where, fmt::format("{}{}: {}", kind, problem->where, problem->sentence)};
  return *std::move(record);
}

Record readable_part(const Json& line) {
  const auto name = line.is_object() ? line.find("kind") : line.end();
  const auto kind = name != line.end() && name->is_string() ? name->get<std::string>() : std::string();
  std::optional<Record> record;
  for_each_kind([&]<class T>() {
    if (record || T::kind.name != kind) return;
    auto& known = std::get<T>(record.emplace(T{}));
    for_each_field<T>([&](const auto& field) {
      const auto* found = find_member(line, field.name);
      auto& member = known.*(field.member);
      if (!found || !read_value(*found, member)) return;
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, std::string>)
        member = compact(*found);
      else
        member = {};
    });
  });
  return record ? *std::move(record) : unknown(kind, line);
}

Stamp stamp_of(const Json& line) {
  Stamp stamp;
  if (!line.is_object()) return stamp;
  take(line, "n", stamp.n);
  take(line, "t", stamp.t_s);
  take(line, "cause", stamp.cause);
  take(line, "measured", stamp.measured);
  return stamp;
}

Json members_of(const Record& record) {
  return std::visit(
      []<class T>(const T& known) {
        if constexpr (std::is_same_v<T, Unknown>)
          return known.members;
        else
          return to_json(known);
      },
      record);
}

std::string_view kind_of(const Record& record) {
  return std::visit(
      []<class T>(const T& known) -> std::string_view {
        if constexpr (std::is_same_v<T, Unknown>)
          return known.name;
        else
          return T::kind.name;
      },
      record);
}

std::string brief(const Record& record) {
  return std::visit([](const auto& known) { return known.brief(); }, record);
}

double margin_of(const Record& record) {
  double least = std::numeric_limits<double>::infinity();
  std::visit(
      [&]<class T>(const T& known) {
        if constexpr (!std::is_same_v<T, Unknown>)
          for_each_margin(known, [&](const Margin& margin) {
            if (margin) least = std::min(least, std::abs(*margin));
          });
      },
      record);
  return least;
}

}  // namespace continua::log
