#include "continua/replay/session/outside_choice.h"

#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/replay/log/run_index.h"
#include "continua/replay/session/line_pipe.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr std::string_view by_pipe = "pipe:", by_run = "run:";

Json told(const Term& term) { return term.is_null() ? Json() : Json(print(term)); }

// The symbol of an input, its confidence and the terms that it carries.
Json told(const Input& input) {
  Json json{{"symbol", input.symbol}, {"confidence", input.confidence}};
  for (const auto& carried : carried_terms())
    if (const auto& term = input.*carried.term; !term.is_null()) json[carried.name] = print(term);
  return json;
}

// The candidate that an answer names: by its id, and by the input that it takes where an id is there twice.
std::optional<std::size_t> named(const std::string& id, std::optional<std::size_t> alternative, const OpenChoice& open,
                                 const Machine& machine) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < open.candidates.size(); ++i) {
    const auto& one = open.candidates[i];
    if (machine.transitions[one.transition].id != id || (alternative && *alternative != one.alternative)) continue;
    if (!best || open.candidates[*best].weight < one.weight) best = i;
  }
  return best;
}

std::string ids_of(const OpenChoice& open, const Machine& machine) {
  std::vector<std::string> ids;
  for (const auto& one : open.candidates) ids.push_back(in_quotes(machine.transitions[one.transition].id));
  return fmt::format("{}", fmt::join(ids, ", "));
}

// Asks a command.
class PipePolicy : public OutsidePolicy {
 public:
  PipePolicy(std::string text, std::shared_ptr<const Machine> machine)
      : text_(std::move(text)), machine_(std::move(machine)) {}

  void begin() override {
    trouble_.reset();
    pipe_.reset();
    auto opened = LinePipe::open(text_.substr(by_pipe.size()));
    if (opened)
      pipe_ = std::move(*opened);
    else
      trouble_ = Error{text_, opened.error().sentence};
  }

  std::optional<std::size_t> choose(const OpenChoice& open) override {
    if (trouble_) return std::nullopt;
    require(pipe_ != nullptr, "a run has begun");
    const auto answer = pipe_->ask(compact(question_of(open, *machine_)));
    if (!answer) return fail(open, answer.error().sentence);
    const auto json = Json::parse(*answer, nullptr, false);
    const auto choice = json.is_object() ? json.find("choice") : json.end();
    if (choice == json.end() || !choice->is_string()) return fail(open, fmt::format("found {}", in_quotes(*answer)));
    std::optional<std::size_t> alternative;
    if (const auto number = json.find("alternative"); number != json.end() && number->is_number_unsigned())
      alternative = number->get<std::size_t>();
    const auto found = named(choice->get<std::string>(), alternative, open, *machine_);
    return found ? found : fail(open, fmt::format("found {}, which is no candidate", in_quotes(*answer)));
  }

  Outcome trouble() const override { return trouble_; }

 private:
  std::nullopt_t fail(const OpenChoice& open, const std::string& found) {
    trouble_ = Error{text_, fmt::format("step {}: {}; expected {{\"choice\": …}} with one of {}", open.step, found,
                                        ids_of(open, *machine_))};
    return std::nullopt;
  }

  std::string text_;
  std::shared_ptr<const Machine> machine_;
  std::unique_ptr<LinePipe> pipe_;
  Outcome trouble_;
};

struct LoggedChoice {
  std::string id;
  std::optional<std::size_t> alternative;
};

// Chooses as an earlier run did.
class RunPolicy : public OutsidePolicy {
 public:
  RunPolicy(std::string path, std::map<int, LoggedChoice> choices, std::shared_ptr<const Machine> machine)
      : path_(std::move(path)), choices_(std::move(choices)), machine_(std::move(machine)) {}

  void begin() override { trouble_.reset(); }

  std::optional<std::size_t> choose(const OpenChoice& open) override {
    if (trouble_) return std::nullopt;
    const auto logged = choices_.find(open.step);
    const auto found =
        logged == choices_.end() ? std::nullopt : named(logged->second.id, logged->second.alternative, open, *machine_);
    if (!found)
      trouble_ = Error{
          path_, fmt::format("step {}: {}; expected one of {}, as the run goes now", open.step,
                             logged == choices_.end() ? "the run has no such step"
                                                      : fmt::format("the run took {}", in_quotes(logged->second.id)),
                             ids_of(open, *machine_))};
    return found;
  }

  Outcome trouble() const override { return trouble_; }

 private:
  std::string path_;
  std::map<int, LoggedChoice> choices_;
  std::shared_ptr<const Machine> machine_;
  Outcome trouble_;
};

Result<std::map<int, LoggedChoice>> choices_of(const RunIndex& run) {
  std::map<int, LoggedChoice> choices;
  for (const auto n : run.of_kind("transition")) {
    const auto record = run.record(n);
    if (!record) return record.error();
    const auto step = record->find("step"), id = record->find("id"), alternative = record->find("alternative");
    if (step == record->end() || !step->is_number_integer() || id == record->end() || !id->is_string())
      return Error{run.where(n), "expected a transition with its step and its id"};
    auto& choice = choices[step->get<int>()];
    choice.id = id->get<std::string>();
    if (alternative != record->end() && alternative->is_number_unsigned())
      choice.alternative = alternative->get<std::size_t>();
  }
  return choices;
}

Result<OutsideChoice> of_run(const std::string& path, std::shared_ptr<const Machine> machine) {
  const auto run = RunIndex::open(path);
  if (!run) return run.error();
  const auto& header = run->header();
  if (!header) return header.error();
  const auto name = header->value(Json::json_pointer("/machine/name"), std::string());
  if (name != machine->name)
    return Error{path, fmt::format("is a run of the machine {}; expected one of {}", in_quotes(name), machine->name)};
  auto choices = choices_of(*run);
  if (!choices) return choices.error();
  auto told = header->value("choice", std::string());
  if (!told.starts_with(by_pipe)) told = fmt::format("{}{}", by_run, std::filesystem::path(path).filename().string());
  return OutsideChoice{std::make_shared<RunPolicy>(path, std::move(*choices), std::move(machine)), std::move(told)};
}

}  // namespace

bool is_outside_choice(std::string_view text) {
  return (text.starts_with(by_pipe) && text.size() > by_pipe.size()) ||
         (text.starts_with(by_run) && text.size() > by_run.size());
}

Result<OutsideChoice> open_outside_choice(const std::string& text, std::shared_ptr<const Machine> machine) {
  require(is_outside_choice(text), "a policy from outside is named");
  if (text.starts_with(by_run)) return of_run(text.substr(by_run.size()), std::move(machine));
  return OutsideChoice{std::make_shared<PipePolicy>(text, std::move(machine)), text};
}

Json question_of(const OpenChoice& open, const Machine& machine) {
  const auto& configuration = *open.configuration;
  Json top = Json::object(), memory = Json::object(), inputs = Json::array(), candidates = Json::array();
  const auto& symbol = configuration.stack.top();
  for (std::size_t i = 0; i < machine.slots.size(); ++i) top[machine.slots[i].name] = told(symbol[i].value);
  for (std::size_t i = 0; i < machine.memory.size(); ++i)
    memory[machine.memory[i].name] = told((*configuration.memory)[i].value);
  for (const auto& input : open.inputs) inputs.push_back(told(input));
  double total = 0;
  for (const auto& one : open.candidates) total += one.weight;
  for (const auto& one : open.candidates) {
    const auto& transition = machine.transitions[one.transition];
    Json candidate{{"id", transition.id},
                   {"to", machine.states[transition.to].name},
                   {"weight", one.weight},
                   {"probability", one.weight / total}};
    if (open.inputs.size() > 1) candidate["alternative"] = one.alternative;
    candidates.push_back(std::move(candidate));
  }
  Json question{{"step", open.step},
                {"state", machine.states[configuration.state].name},
                {"top", std::move(top)},
                {"depth", configuration.stack.depth()},
                {"memory", std::move(memory)},
                {"inputs", std::move(inputs)},
                {"candidates", std::move(candidates)}};
  if (!open.inputs.empty()) question["t"] = open.inputs.front().now_s;
  return question;
}

}  // namespace continua
