#include "continua/voxml/program_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "continua/core/located_json.h"

namespace continua {
namespace {

using Kind = Expression::Kind;

class ProgramCheck {
 public:
  explicit ProgramCheck(const Catalogue& catalogue) : catalogue_(catalogue) {}

  std::vector<Error> problems() && {
    for (const auto& [key, voxeme] : catalogue_.voxemes())
      if (voxeme.entity == Voxeme::Entity::program) {
        program_ = &voxeme;
        for (const auto& step : voxeme.body) check(step);
      }
    return std::move(problems_);
  }

 private:
  void problem(const Expression& in, const std::string& sentence) {
    problems_.push_back({program_->path, fmt::format("{}: {}", in_quotes(print(in)), sentence)});
  }

  void check(const Subevent& step) {
    if (step.when != Subevent::When::always) condition(step.condition);
    if (step.event != Expression{}) event(step.event);
  }

  // Checks the number of arguments. An agent, declared first, may be left out; a list at the end, a:T[], is any number
  // of arguments. `fewer`: arguments that this use leaves out.
  void count(const Expression& call, const Voxeme& voxeme, std::size_t fewer) {
    const auto& declared = voxeme.arguments;
    const bool agent = !declared.empty() && declared.front().type == "agent";
    const bool list = !declared.empty() && declared.back().type.ends_with("[]");
    const auto used = call.arguments.size() + fewer;
    const auto fits = [&](std::size_t given) { return list ? given + 1 >= declared.size() : given == declared.size(); };
    if (!fits(used) && !(agent && fits(used + 1)))
      problem(call,
              fmt::format("the {} {} has {} arguments", name_of(voxeme.entity), in_quotes(call.name), declared.size()));
  }

  void event(const Expression& each) {
    const bool assigns = program_->head.name == "assignment";
    if (each.kind == Kind::both) {
      for (const auto& part : each.arguments) event(part);
    } else if (assigns && each.kind == Kind::call && each.name == "extend") {
      if (each.arguments.size() != 2) problem(each, "expected extend(x,y): the agent and the finger");
      arguments_of(each);
    } else if (assigns && each.kind == Kind::call && each.name == "def" && !each.arguments.empty() &&
               is_vector(each.arguments[0])) {
      assignment(each);
    } else if (each.kind == Kind::call && (each.name == "def" || each.name == "repeat")) {
      builtin(each);
    } else if (const auto* voxeme =
                   each.kind == Kind::call ? catalogue_.find(Voxeme::Entity::program, each.name) : nullptr) {
      count(each, *voxeme, 0);
      for (const auto& argument : each.arguments) place(argument);
    } else {
      problem(each, fmt::format("there is no program {}", in_quotes(each.name)));
    }
  }

  // The declared argument that the name means; nullptr if there is none, which is a problem.
  const VoxemeArgument* argument(const Expression& name, const Expression& in) {
    for (const auto& each : program_->arguments)
      if (name.kind == Kind::name && each.name == name.name) return &each;
    problem(in, fmt::format("{} is no argument of the program", in_quotes(print(name))));
    return nullptr;
  }
  void arguments_of(const Expression& call) {
    for (const auto& each : call.arguments) argument(each, call);
  }

  // def(vec(x -> y × z), as(w)): the things that the vector meets, and the place, become w.
  void assignment(const Expression& def) {
    const auto& vector = def.arguments[0];
    const auto& label = def.arguments.back();
    if (def.arguments.size() != 2 || label.kind != Kind::call || label.name != "as" || label.arguments.size() != 1)
      return problem(def, "expected def(vec(x -> y × z),as(w))");
    arguments_of(vector);
    const auto extended = std::any_of(program_->body.begin(), program_->body.end(), [&](const Subevent& step) {
      return step.event.name == "extend" && step.event.arguments.size() == 2 &&
             step.event.arguments[1] == vector.arguments[1];
    });
    if (!extended) problem(def, fmt::format("no step extends {}", in_quotes(print(vector.arguments[1]))));
    const auto* assigned = argument({label.arguments[0].kind == Kind::text ? Kind::name : label.arguments[0].kind,
                                     label.arguments[0].name, label.arguments[0].arguments},
                                    def);
    if (assigned && halves_of(assigned->type).size() != 2)
      problem(def, fmt::format("{} has the type {}, expected a compound such as physobj[]•location",
                               in_quotes(assigned->name), in_quotes(assigned->type)));
  }

  void builtin(const Expression& call) {
    const auto is = [](const Expression& each, std::string_view name) {
      return each.kind == Kind::call && each.name == name && each.arguments.size() == 1;
    };
    const auto& arguments = call.arguments;
    if (call.name == "def") {
      if (arguments.size() != 2 || !is(arguments[0], "loc") || !is(arguments[1], "as"))
        problem(call, "expected def(loc(y),as('l1'))");
      return;
    }
    const bool right = arguments.size() == 2 && arguments[1].kind == Kind::text;
    const auto steps = right ? parse_subevents(arguments[1].name) : Error{};
    if (!steps) return problem(call, "expected repeat(2,'swap(y,z)')");
    // No document nests repetitions.
    for (const auto& step : *steps)
      if (step.event.name == "repeat")
        problem(step.event, "repeats within what is repeated");
      else
        check(step);
  }

  void condition(const Expression& each) {
    if (each.kind == Kind::negation || each.kind == Kind::both || each.kind == Kind::either) {
      for (const auto& part : each.arguments) condition(part);
      return;
    }
    const auto* voxeme = each.kind == Kind::call ? catalogue_.find(Voxeme::Entity::relation, each.name) : nullptr;
    if (!voxeme) return problem(each, fmt::format("there is no relation {}", in_quotes(each.name)));
    count(each, *voxeme, 0);
    for (const auto& argument : each.arguments) place(argument);
  }

  // Checks a place such as near(z), which leaves out the thing that is there.
  void place(const Expression& each) {
    if (each.kind != Kind::call) return;
    if (each.name == "loc" && each.arguments.size() == 1) return;
    const auto* voxeme = catalogue_.find(Voxeme::Entity::relation, each.name);
    if (!voxeme) return problem(each, fmt::format("there is no relation {}", in_quotes(each.name)));
    count(each, *voxeme, 1);
    for (const auto& argument : each.arguments) place(argument);
  }

  const Catalogue& catalogue_;
  const Voxeme* program_ = nullptr;
  std::vector<Error> problems_;
};

}  // namespace

std::vector<Error> check_programs(const Catalogue& catalogue) { return ProgramCheck(catalogue).problems(); }

}  // namespace continua
