#include "continua/pipeline/lessons.h"

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
Outcome learn(Taught& taught, const Machine& machine, Learned& learned) {
  if (taught.name.empty()) return Error{"", "nothing is learned without a name"};
  if (taught.of == Lesson::gesture) {
    learned.gestures.insert_or_assign(taught.name, taught.value);
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

std::vector<StepEvent> taught(Taught event, const Machine& machine, Learned& learned) {
  const auto word = event.name;
  if (const auto problem = learn(event, machine, learned))
    return {Trouble{fmt::format("{} is not learned: {}", in_quotes(word), problem->sentence)}};
  if (event.of == Lesson::word) event.value = learned.programs.find(event.name)->second.acts;
  return {std::move(event)};
}

std::vector<StepEvent> forgotten(const Forgotten& event, Learned& learned) {
  std::vector<StepEvent> events;
  const auto forget = [&](Lesson of, auto& known, const auto& value_of, const auto& is_called) {
    if (event.of && *event.of != of) return;
    for (auto one = known.begin(); one != known.end();) {
      if (event.of && one->first != event.name && !is_called(one->second)) {
        ++one;
        continue;
      }
      events.push_back(Forgotten{of, one->first, value_of(one->second), event.because});
      one = known.erase(one);
    }
  };
  const auto itself = [](const Term& term) { return term; };
  const auto by_name_alone = [](const Term&) { return false; };
  forget(Lesson::gesture, learned.gestures, itself, by_name_alone);
  forget(Lesson::noun, learned.nouns, itself, by_name_alone);
  forget(
      Lesson::word, learned.programs, [](const Program& program) { return program.acts; },
      [&](const Program& program) { return !program.word.empty() && program.word == event.name; });
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

std::vector<StepEvent> with_lessons(std::vector<StepEvent> events, const Machine& machine, Learned& learned) {
  std::vector<StepEvent> all;
  const auto add = [&](std::vector<StepEvent> some) {
    all.insert(all.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  };
  for (auto& event : events) {
    if (auto* lesson = std::get_if<Taught>(&event))
      add(taught(std::move(*lesson), machine, learned));
    else if (const auto* lost = std::get_if<Forgotten>(&event))
      add(forgotten(*lost, learned));
    else if (auto* act = std::get_if<Acted>(&event))
      add(acted(std::move(*act), learned));
    else
      all.push_back(std::move(event));
  }
  return all;
}

}  // namespace continua
