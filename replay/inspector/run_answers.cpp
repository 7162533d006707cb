#include "continua/replay/inspector/run_answers.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/inspector/page_parts.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_stops.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

constexpr std::size_t at_once = 500;  // labels asked for

class Answers {
 public:
  Answers(InspectorApi& api, const std::string& id, const RunIndex& run) : api_(api), id_(id), run_(run) {}

  Outcome collect(const std::function<void(double)>& progress) {
    const auto summary = ask(""), columns = ask("columns");
    if (summary.status != 200 || columns.status != 200)
      return Error{run_.path(), "cannot be shown: its header or its columns cannot be worked out"};
    add("run", summary.body);
    add("schema", compact(log::schema_json()));
    for (const char* name : {"graph", "scene", "notes", "account"}) view(name, name);
    add("columns", compact(Json(base64(columns.body))));
    add_poses();
    add_labels();
    if (const auto problem = add_stacks()) return problem;
    for (std::size_t n = 0; n < run_.size(); ++n) {
      const auto line = run_.line(n);
      if (!line) return line.error();
      add(fmt::format("record {}", n), *line);
    }
    const auto stops = records_worth_stopping_at(run_);
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (progress) progress(static_cast<double>(i) / static_cast<double>(stops.size()));
      view(fmt::format("explain {}", stops[i]), fmt::format("explain?n={}", stops[i]));
    }
    return std::nullopt;
  }

  std::string take() { return std::move(text_); }

 private:
  ApiResponse ask(const std::string& view) { return api_.get("/api/runs/" + id_ + (view.empty() ? "" : "/" + view)); }

  void add(const std::string& question, const std::string& json) { text_ += answer_line(question, json); }

  // A view for which the log has nothing is left out.
  void view(const std::string& question, const std::string& view) {
    const auto answer = ask(view);
    if (answer.status == 200) add(question, answer.body);
  }

  // All that moved, in one window.
  void add_poses() {
    Json all;
    const auto end = run_.entry(run_.size() - 1).t.seconds();
    for (double from = 0;;) {
      const auto answer = ask(fmt::format("poses?from={}&to={}", from, end));
      if (answer.status != 200) return;
      auto window = Json::parse(answer.body);
      const auto next = window.value("next", Json());
      if (all.is_null()) {
        all = std::move(window);
      } else {
        for (auto& change : window["changes"]) all["changes"].push_back(std::move(change));
        for (const char* part : {"pointing", "acts"})
          for (auto& one : window[part])
            if (std::find(all[part].begin(), all[part].end(), one) == all[part].end())
              all[part].push_back(std::move(one));
      }
      if (!next.is_number() || next.get<double>() <= from) break;
      from = next.get<double>();
    }
    all.erase("next");
    all["to"] = end;
    add("poses", compact(all));
  }

  void add_labels() {
    Json labels = Json::array();
    for (std::size_t from = 0; from < run_.size(); from += at_once) {
      const auto part = Json::parse(ask(fmt::format("labels?from={}&limit={}", from, at_once)).body);
      for (std::size_t n = from; n < std::min(run_.size(), from + at_once); ++n)
        labels.push_back(part.at("labels").value(std::to_string(n), Json::array({"", ""})));
    }
    add("labels", compact(labels));
  }

  Outcome add_stacks() {
    if (run_.stack_marks().empty()) view("stack 0", "stack?n=0");
    for (const auto& mark : run_.stack_marks())
      view(fmt::format("stack {}", mark.n), fmt::format("stack?n={}", mark.n));
    for (const auto n : run_.of_kind(log::Branches::kind.name)) {
      const auto record = run_.record(n);
      if (!record) return record.error();
      for (const auto& one : member_of(*record, "branches"))
        if (const auto& id = member_of(one, "id"); id.is_number_integer())
          view(fmt::format("branch {} {}", n, id.get<std::int64_t>()),
               fmt::format("stack?n={}&branch={}", n, id.get<std::int64_t>()));
    }
    return std::nullopt;
  }

  InspectorApi& api_;
  const std::string& id_;
  const RunIndex& run_;
  std::string text_;
};

}  // namespace

std::string answer_line(const std::string& question, const std::string& json) { return question + '\t' + json + '\n'; }

Result<std::string> run_answers(InspectorApi& api, const std::string& id, const RunIndex& run,
                                const std::function<void(double done)>& progress) {
  if (run.bytes() > most_page_log)
    return Error{run.path(), fmt::format("has {} MB; expected at most {} MB for one file. `continua serve` shows it",
                                         run.bytes() >> 20, most_page_log >> 20)};
  Answers answers(api, id, run);
  if (const auto problem = answers.collect(progress)) return *problem;
  return answers.take();
}

}  // namespace continua
