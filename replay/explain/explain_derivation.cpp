#include "continua/replay/explain/explain_derivation.h"

#include <algorithm>
#include <optional>
#include <set>

#include "continua/replay/explain/explain_origin.h"
#include "continua/replay/explain/explain_term.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/term/term_structure.h"

namespace continua {
namespace {

// Whether `name` was taught before, so that a program can be one step of it.
bool was_taught(ExplainScope& scope, const std::string& name, std::size_t before) {
  for (const auto n : scope.run().of_kind(log::Learned::kind.name))
    if (n < before && text_of(scope.record(n), "name") == name) return true;
  return false;
}

class Derivation {
 public:
  explicit Derivation(ExplainScope& scope) : scope_(scope), applications_(scope.latest(log::Application::kind.name)) {}

  // The tree of `term` as record `at` has it.
  Json of(const std::string& term, const std::string& type, std::size_t at, const std::set<std::string>& open) {
    Json node{{"term", term}, {"structure", term_structure(term)}, {"type", type.empty() ? Json() : Json(type)}};
    const bool room = ++nodes_ < most_nodes && deep_ < deepest;
    const Deeper deeper(deep_);
    if (const auto made = application(term, at); made && room) return applied(std::move(node), *made, open);
    if (open.count(term) != 0) return leaf(std::move(node), open_origin(term, at));
    const auto parts = term_parts(term);
    if (room && !parts.body.empty()) return abstraction(std::move(node), parts, at, open);
    if (room && !parts.elements.empty()) {
      auto origin = origin_of(scope_, term, at);
      if (is_whole(origin)) return leaf(std::move(node), std::move(origin));
      node["how"] = "parts";
      if (const auto kind = text_of(origin, "kind"); kind == "slot" || kind == "memory") node["origin"] = origin;
      auto& children = node["children"] = Json::array();
      if (!parts.head.empty()) children.push_back(of(parts.head, "", at, open));
      for (const auto& element : parts.elements) children.push_back(of(element, "", at, open));
      return of_machine(children) ? of_machine_alone(std::move(node)) : node;
    }
    return leaf(std::move(node), settled(origin_of(scope_, term, at), at));
  }

  // The latest application before `at` that made the term.
  std::optional<std::size_t> application(const std::string& term, std::size_t at) {
    for (const auto n : applications_)
      if (n < at && text_of(scope_.record(n), "result") == term) return n;
    return std::nullopt;
  }

  // The application that nothing later in the turn of `at` built upon, or none.
  std::optional<std::size_t> last_of_turn(std::size_t at) {
    for (const auto n : applications_)
      if (n <= at && scope_.input_of(n) == scope_.input_of(at)) return n;
    return std::nullopt;
  }

  // The result of the latest application of the turn of `at` that names a taught program; empty if there is none.
  std::string taught_of_turn(std::size_t at) {
    for (const auto n : applications_) {
      if (n > at || scope_.input_of(n) != scope_.input_of(at)) continue;
      if (auto result = text_of(scope_.record(n), "result"); was_taught(scope_, term_parts(result).head, at))
        return result;
    }
    return {};
  }

 private:
  static constexpr int most_nodes = 300, deepest = 60;

  struct Deeper {
    explicit Deeper(int& depth) : depth_(depth) { ++depth_; }
    ~Deeper() { --depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    int& depth_;
  };

  // Whether the origin accounts for the whole term, and not only for having it somewhere.
  static bool is_whole(const Json& origin) {
    const auto kind = text_of(origin, "kind");
    return kind == "words" || kind == "gesture" || kind == "pointing" || kind == "choice";
  }

  // A variable that a lambda above binds.
  Json open_origin(const std::string& name, std::size_t at) {
    auto origin = origin_of(scope_, name, at);
    if (text_of(origin, "kind") == "open") return origin;
    origin["kind"] = "open";
    origin["by"] = "machine";
    origin["text"] = "left open by the machine";
    return origin;
  }

  // Whether nobody said or showed any of the parts.
  static bool of_machine(const Json& parts) {
    return std::all_of(parts.begin(), parts.end(), [](const Json& part) {
      const auto& origin = member_of(part, "origin");
      return text_of(part, "how") == "leaf" && (text_of(origin, "kind") == "machine" || !text_of(origin, "by").empty());
    });
  }

  // A term of the machine itself is one leaf: its parts would say the same again.
  static Json of_machine_alone(Json node) {
    const auto parts = node["children"];
    node.erase("children");
    const auto told = std::find_if(parts.begin(), parts.end(), [](const Json& part) {
      return text_of(member_of(part, "origin"), "kind") == "machine";
    });
    return leaf(std::move(node), (told == parts.end() ? parts.front() : *told)["origin"]);
  }

  // A choice among several is settled by the words or gestures since.
  Json settled(Json origin, std::size_t at) {
    const auto input = scope_.input_of(at);
    if (text_of(origin, "kind") != "choice" || !input || origin["input"] == *input) return origin;
    origin["settled_by"] = *input;
    origin["text"] = origin["text"].get<std::string>() + "; settled by " + told_input(scope_, *input);
    return origin;
  }

  static Json leaf(Json node, Json origin) {
    node["how"] = "leaf";
    node["origin"] = std::move(origin);
    return node;
  }

  Json applied(Json node, std::size_t n, const std::set<std::string>& open) {
    const Json& record = scope_.record(n);
    const auto& types = member_of(record, "types");
    if (node["type"].is_null() && !text_of(types, "result").empty()) node["type"] = text_of(types, "result");
    node["how"] = "application";
    node["n"] = n;
    node["rule"] = member_of(record, "rule");
    node["children"] = Json::array();
    for (const char* part : {"function", "argument"})
      node["children"].push_back(of(text_of(record, part), text_of(types, part), n, open));
    return node;
  }

  Json abstraction(Json node, const TermParts& parts, std::size_t at, std::set<std::string> open) {
    node["how"] = "abstraction";
    open.insert(parts.binders.begin(), parts.binders.end());
    node["children"] = Json::array({of(parts.body, "", at, open)});
    return of_machine(node["children"]) ? of_machine_alone(std::move(node)) : node;
  }

  ExplainScope& scope_;
  const std::vector<std::size_t> applications_;
  int nodes_ = 0, deep_ = 0;
};

// A term of the stack at n that the log has an application for.
std::string composed_on_stack(ExplainScope& scope, Derivation& derivation, std::size_t n) {
  const auto mark = scope.run().mark_at(n);
  if (!mark) return {};
  const auto* top = scope.run().symbol(scope.run().stack_marks()[*mark].top);
  if (!top) return {};
  const auto& slots = member_of(scope.record(top->n), "slots");
  if (!slots.is_object()) return {};
  for (const auto& [slot, value] : slots.items()) {
    if (!value.is_string()) continue;
    const auto term = value.get<std::string>();
    const auto parts = term_parts(term);
    if (derivation.application(term, n) || (!parts.body.empty() && derivation.application(parts.body, n))) return term;
  }
  return {};
}

}  // namespace

Json derivation_of(ExplainScope& scope, const std::string& term) {
  return Derivation(scope).of(term, "", scope.n() + 1, {});
}

Json derivation_of(ExplainScope& scope) {
  const auto n = scope.n();
  const Json& record = scope.record(n);
  const auto& kind = scope.run().kind(n);
  Derivation derivation(scope);
  const auto made_last = derivation.last_of_turn(n);
  const auto last_result = made_last ? text_of(scope.record(*made_last), "result") : std::string();

  std::string term;
  if (log::is<log::Act>(kind)) term = text_of(record, "program");
  if (log::is<log::AvatarGesture>(kind)) term = text_of(record, "gesture");
  if (log::is<log::Learned>(kind) || log::is<log::Memory>(kind)) term = text_of(record, "value");
  if (log::is<log::Application>(kind)) term = text_of(record, "result");
  if (log::is<log::Reading>(kind)) term = text_of(record, "meaning");
  if (const auto taught = derivation.taught_of_turn(n);
      log::is<log::Act>(kind) && !derivation.application(term, n) && !taught.empty())
    return {{"term", term},
            {"structure", term_structure(term)},
            {"type", nullptr},
            {"how", "taught"},
            {"children", Json::array({derivation.of(taught, "", n, {})})}};
  if (term.empty()) term = composed_on_stack(scope, derivation, n);
  if (term.empty()) term = last_result;
  if (term.empty())
    for (const auto at : scope.chain())
      if (term.empty() && log::is<log::Reading>(scope.run().kind(at))) term = text_of(scope.record(at), "meaning");
  if (term.empty()) return nullptr;
  return derivation.of(term, "", n + (log::is<log::Application>(kind) ? 1 : 0), {});
}

}  // namespace continua
