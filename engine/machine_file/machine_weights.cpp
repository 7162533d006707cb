#include "continua/machine_file/machine_weights.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/document_reader.h"

namespace continua {
namespace {

std::vector<std::string> concepts_of(const Evidence& evidence, const Machine& machine) {
  std::vector<std::string> names;
  for (const auto index : evidence.concepts) names.push_back(machine.beliefs.concepts[index].name);
  return names;
}

void read_transitions(const Item& item, const Machine& machine, MachineWeights& weights) {
  std::vector<std::string> known;
  for (const auto& transition : machine.transitions) known.push_back(transition.id);
  for (const auto& [id, value] : item.members("transitions and their weights")) {
    const auto found = std::find(known.begin(), known.end(), id);
    if (found == known.end()) {
      value.problem_at_key(value.unknown("transition", id, known));
      continue;
    }
    const double weight = value.number("a weight", 1, 0, heaviest_weight);
    if (weight == 0) value.mismatch("a weight, a number greater than 0");
    weights.transitions[static_cast<std::size_t>(found - known.begin())] = weight;
  }
}

void read_row(const Item& item, const Machine& machine, MachineWeights& weights) {
  if (!item.expect_object("a row of evidence", {"row", "concepts", "levels", "about"})) return;
  const auto& evidence = machine.beliefs.evidence;
  const auto row = item.required("row", "the number of a row of the machine's evidence, from 1");
  const int number = row.whole_number("the number of a row", 0, 1, static_cast<int>(evidence.size()));
  if (number == 0) return;
  const auto& own = evidence[static_cast<std::size_t>(number - 1)];
  const auto concepts = item.member("concepts");
  if (const auto names = concepts_of(own, machine); concepts.exists() && concepts.texts("a concept") != names)
    concepts.problem(
        fmt::format("row {} of the evidence raises {}; expected the same concepts", number, fmt::join(names, ", ")));
  const auto list = item.required("levels", "certainties, ascending");
  std::vector<double> levels;
  for (const auto& level : list.elements("levels of certainty")) levels.push_back(level.number("a level", 1, 0, 1));
  if (levels.size() != own.levels.size() || !std::is_sorted(levels.begin(), levels.end()))
    return list.problem(
        fmt::format("expected {} levels of certainty, ascending, as the machine has", own.levels.size()));
  weights.levels[static_cast<std::size_t>(number - 1)] = std::move(levels);
}

}  // namespace

MachineWeights weights_of(const Machine& machine) {
  MachineWeights weights;
  for (const auto& transition : machine.transitions) weights.transitions.push_back(transition.weight);
  for (const auto& evidence : machine.beliefs.evidence) weights.levels.push_back(evidence.levels);
  return weights;
}

Json weights_document(const Machine& machine, const MachineWeights& weights) {
  Json transitions = Json::object(), rows = Json::array();
  for (std::size_t i = 0; i < machine.transitions.size(); ++i)
    if (weights.transitions[i] != machine.transitions[i].weight)
      transitions[machine.transitions[i].id] = weights.transitions[i];
  const auto& evidence = machine.beliefs.evidence;
  for (std::size_t i = 0; i < evidence.size(); ++i)
    if (weights.levels[i] != evidence[i].levels)
      rows.push_back({{"row", i + 1}, {"concepts", concepts_of(evidence[i], machine)}, {"levels", weights.levels[i]}});
  Json document{{"weights", 1}, {"machine", machine.name}, {"transitions", std::move(transitions)}};
  document["evidence"] = std::move(rows);
  return document;
}

Result<MachineWeights> read_weights(const std::string& path, const Machine& machine) {
  const auto document = LocatedJson::read(path);
  if (!document) return document.error();
  DocumentReader reader;
  auto weights = weights_of(machine);
  const auto root = reader.root(*document);
  if (root.expect_object("a file of weights", {"weights", "machine", "transitions", "evidence", "learned", "about"})) {
    root.expect_version("weights", 1);
    const auto name = root.required("machine", "the name of the machine");
    if (const auto given = name.name("the name of the machine"); !given.empty() && given != machine.name)
      name.mismatch(machine.name);
    read_transitions(root.member("transitions"), machine, weights);
    for (const auto& row : root.member("evidence").elements("rows of evidence")) read_row(row, machine, weights);
  }
  if (!reader.sound()) return reader.problems().front();
  return weights;
}

Outcome set_weights(Machine& machine, const MachineWeights& weights) {
  auto document = Json::parse(machine.document, nullptr, false);
  const auto transitions = document.is_object() ? document.find("transitions") : document.end();
  if (transitions == document.end() || !transitions->is_array() || transitions->size() != machine.transitions.size())
    return Error{machine.name, "has no weights; expected a machine file of the project's own format"};
  for (std::size_t i = 0; i < machine.transitions.size(); ++i) {
    if (machine.transitions[i].weight == weights.transitions[i]) continue;
    machine.transitions[i].weight = weights.transitions[i];
    (*transitions)[i]["weight"] = weights.transitions[i];
  }
  for (std::size_t i = 0; i < machine.beliefs.evidence.size(); ++i) {
    if (machine.beliefs.evidence[i].levels == weights.levels[i]) continue;
    machine.beliefs.evidence[i].levels = weights.levels[i];
    document["beliefs"]["evidence"][i]["levels"] = weights.levels[i];
  }
  machine.document = compact(document);
  return std::nullopt;
}

}  // namespace continua
