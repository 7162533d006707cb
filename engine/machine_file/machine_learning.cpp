// What is learned and forgotten: the effects that say so.
#include <fmt/format.h>

#include "machine_file/machine_reader.h"

namespace continua {

std::optional<Lesson> MachineReader::read_lesson(const Item& lesson) {
  const bool gesture = member(lesson, "gesture").json, word = member(lesson, "word").json;
  if (gesture != word) return gesture ? Lesson::gesture : Lesson::word;
  problem(lesson, fmt::format("found {}, expected one of gesture, word", gesture ? "both" : "none"));
  return std::nullopt;
}

std::optional<Learn> MachineReader::read_learn(const Item& lesson) {
  if (!expect_object(lesson, "what is learned")) return std::nullopt;
  const auto of = read_lesson(lesson);
  if (!of) return std::nullopt;
  const bool word = *of == Lesson::word;
  if (const auto other = member(lesson, word ? "means" : "acts"); other.json)
    problem_at_key(other, word ? "a word stands for \"acts\"" : "a gesture has \"means\"");
  const auto name = parse(member(lesson, text(*of)), Type::text_type());
  const auto value = word ? parse(required(lesson, "acts", "a list of acts, a term"), Type::list(Type::term()))
                          : parse(required(lesson, "means", "what the gesture means, a term"), Type::term());
  if (!name || !value) return std::nullopt;
  return Learn{*of, *name, *value};
}

std::optional<Forget> MachineReader::read_forget(const Item& lesson) {
  if (*lesson.json == "all") return Forget{std::nullopt, Term::null()};
  if (!lesson.json->is_object()) return mismatch(lesson, "'all', or what is forgotten, an object"), std::nullopt;
  expect_object(lesson, "what is forgotten");
  const auto of = read_lesson(lesson);
  if (!of) return std::nullopt;
  const auto name = parse(member(lesson, text(*of)), Type::text_type());
  if (!name) return std::nullopt;
  return Forget{*of, *name};
}

}  // namespace continua
