// All kinds of records of a run log (RECORDS.md). A new kind is a struct with a `kind`, `fields()` and `brief()` in one
// of the headers below, and a place in the list at its end; nothing else lists the kinds or their members.
#pragma once

#include <variant>

#include "continua/core/result.h"
#include "continua/replay/log/records_of_automaton.h"
#include "continua/replay/log/records_of_avatar.h"
#include "continua/replay/log/records_of_input.h"
#include "continua/replay/log/records_of_log.h"

namespace continua::log {

/// A record of a kind that this program does not know, from a log of a later version.
struct Unknown {
  std::string name;
  Json members = Json::object();  ///< without `kind`, `n`, `t`, `cause`

  std::string brief() const;
};

template <class... Lists>
struct RecordOf;
template <class... Some, class... More, class... Lists>
struct RecordOf<Kinds<Some...>, Kinds<More...>, Lists...> : RecordOf<Kinds<Some..., More...>, Lists...> {};
template <class... All>
struct RecordOf<Kinds<All...>> {
  using type = std::variant<Unknown, All...>;
};

using Record = RecordOf<RecordsOfLog, RecordsOfInput, RecordsOfAutomaton, RecordsOfAvatar>::type;

/// Calls `use.template operator()<T>()` for each kind of record, in the order of RECORDS.md.
template <class Use>
constexpr void for_each_kind(Use&& use) {
  [&use]<class... Kinds>(std::variant<Unknown, Kinds...>*) {
    (use.template operator()<Kinds>(), ...);
  }(static_cast<Record*>(nullptr));
}

/// Members that records of every kind have.
struct Stamp {
  std::int64_t n = 0;
  double t_s = 0;
  std::optional<std::int64_t> cause;
  bool measured = false;  ///< written, as the last member, only if true

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("n", &Stamp::n, Says::where, "Running number from 0, also the line's index.", {.form = "record"});
    use("t", &Stamp::t_s, Says::where, "Simulated time, at most six decimals.", {.form = "seconds"});
    use("cause", &Stamp::cause, Says::where, "The record that brought this one about; left out where none did.",
        {.form = "record"});
    use("measured", &Stamp::measured, Says::where,
        "True: the record follows from the end of an act, so its `t` is measured and no decision.");
  }
};

/// The record in a line of a log. Members that are missing keep their defaults, unknown ones are ignored, and an
/// unknown kind becomes Unknown: logs of earlier and later versions can be read. A member of another type than declared
/// is an error, placed at `where` and the member's path.
Result<Record> read_record(const Json& line, const std::string& where = {});

/// The same of a line that may be anything: a member of another type than declared keeps its default, or is its JSON
/// where text is declared.
Record readable_part(const Json& line);

/// The members of `line` that records of every kind have; a member that is missing or of another type keeps its
/// default.
Stamp stamp_of(const Json& line);

/// The members of the record, in their order, without those of its stamp.
Json members_of(const Record& record);

/// The name of its kind.
std::string_view kind_of(const Record& record);

/// The record in a few words, without its kind, number and time.
std::string brief(const Record& record);

/// The smallest margin in the record, infinity where it has none.
double margin_of(const Record& record);

}  // namespace continua::log
