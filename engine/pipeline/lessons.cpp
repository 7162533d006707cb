#include "continua/pipeline/lessons.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/facts/world_facts.h"

namespace continua {
namespace {

// "lift" as a word of the human's must not be taken for the machine's program of that name.
std::string name_in_terms(const std::string& word, const Machine& machine) {
  std::string name = word;
  while (is_taken(name, machine)) name += "_taught";
  return name;
}

// Learns the lesson; the name of a taught word becomes its name in terms.
Outcome learn(Taught& taught, const Machine& machine, const Seen& seen, Learned& learned) {
  if (taught.name.empty()) return Error{"", "nothing is learned without a name"};
  if (taught.of == Lesson::gesture) {
    learned.gestures.insert_or_assign(taught.name, taught.value);
    if (const auto shape = seen.shapes.find(taught.name); !shape.empty()) learned.learn_shape(taught.name, shape);
    return std::nullopt;
  }
  if (taught.of == Lesson::noun) {
    if (!consistent(taught.value.type(), Type::function(Type::entity(), Type::truth())) || taught.value.is_null())
      return Error{"", fmt::format("{} is no condition on things", print(taught.value))};
    learned.nouns.insert_or_assign(taught.name, taught.value);
    return std::nullopt;
  }
  if (taught.value.kind() != Term::Kind::list) return Error{"", fmt::format("{} is no list", print(taught.value))};
  auto program = taught.fixed ? Result<Program>(Program{taught.value, {}}) : composed(taught.value.elements());
  if (!program) return program.error();
  auto name = name_in_terms(taught.name, machine);
  if (name != taught.name) program->word = std::exchange(taught.name, name);
  return learned.learn_program(name, *std::move(program));
}

std::vector<StepEvent> taught(Taught event, const Machine& machine, const Seen& seen, Learned& learned) {
  const auto word = event.name;
  if (const auto problem = learn(event, machine, seen, learned))
    return {Trouble{fmt::format("{} is not learned: {}", in_quotes(word), problem->sentence)}};
  if (event.of == Lesson::word) event.value = learned.programs.find(event.name)->second.acts;
  return {std::move(event)};
}

// The names of what is to be forgotten: those of a gesture of one shape, and that of a word in terms.
std::vector<std::string> names_of(const Forgotten& event, const Seen& seen, const Learned& learned) {
  if (event.of == Lesson::gesture) return of_one_shape(event.name, learned, seen.limits);
  std::vector<std::string> names = {event.name};
  for (const auto& [name, program] : learned.programs)
    if (event.of == Lesson::word && !program.word.empty() && program.word == event.name) names.push_back(name);
  return names;
}

std::vector<StepEvent> forgotten(const Forgotten& event, const Seen& seen, Learned& learned) {
  std::vector<StepEvent> events;
  const auto names = names_of(event, seen, learned);
  const auto forget = [&](Lesson of, auto& known, const auto& value_of) {
    if (event.of && *event.of != of) return;
    for (auto one = known.begin(); one != known.end();) {
      if (event.of && std::find(names.begin(), names.end(), one->first) == names.end()) {
        ++one;
        continue;
      }
      events.push_back(Forgotten{of, one->first, value_of(one->second), event.because});
      one = known.erase(one);
    }
  };
  forget(Lesson::gesture, learned.gestures, [](const Term& meaning) { return meaning; });
  std::erase_if(learned.shapes, [&](const auto& one) { return !learned.gestures.contains(one.first); });
  forget(Lesson::noun, learned.nouns, [](const Term& condition) { return condition; });
  forget(Lesson::word, learned.programs, [](const Program& program) { return program.acts; });
  return events;
}

std::vector<StepEvent> acted(Acted event, const Learned& learned) {
  std::vector<Application> made;
  const auto acts = learned.acts_of(event.term, made);
  if (!acts) return {Trouble{acts.error().sentence}};
  std::vector<StepEvent> events;
  for (auto& application : made) events.push_back(Applied{std::move(application), event.because});
  for (const auto& act : *acts) events.push_back(Acted{act, event.because});
  return events;
}

}  // namespace

bool is_taken(const std::string& name, const Machine& machine) {
  return term_signature().contains(name) || WorldFacts::signature().contains(name) || machine.programs.contains(name) ||
         machine.bindings.contains(Name(name)) || machine.tables.contains(name);
}

std::vector<StepEvent> with_lessons(std::vector<StepEvent> events, const Machine& machine, const Seen& seen,
                                    Learned& learned) {
  std::vector<StepEvent> all;
  const auto add = [&](std::vector<StepEvent> some) {
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  };
  for (auto& event : events) {
    if (auto* lesson = std::get_if<Taught>(&event))
      add(taught(std::move(*lesson), machine, seen, learned));
    else if (const auto* lost = std::get_if<Forgotten>(&event))
      add(forgotten(*lost, seen, learned));
    else if (auto* act = std::get_if<Acted>(&event))
      add(acted(std::move(*act), learned));
    else
      all.push_back(std::move(event));
  }
  return all;
}

}  // namespace continua
