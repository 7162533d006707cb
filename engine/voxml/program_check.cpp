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
    if (each.kind == Kind::both) {
      for (const auto& part : each.arguments) event(part);
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
