#include "continua/replay/sweep/sweep_result.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "continua/replay/export/csv_cell.h"
#include "continua/replay/score/score_report.h"
#include "continua/replay/terminal/text_table.h"

namespace continua {
namespace {

constexpr std::pair<const char*, int SweptTrace::*> counts_of_runs[] = {
    {"inputs", &SweptTrace::inputs},
    {"refusals", &SweptTrace::refusals},
    {"utterances", &SweptTrace::utterances},
    {"acts", &SweptTrace::acts},
    {"acts_done", &SweptTrace::acts_done},
    {"expectations", &SweptTrace::expectations},
    {"expectations_met", &SweptTrace::expectations_met},
    {"problems", &SweptTrace::problems},
};

// Head and rows of a table, from the text of a value and of a figure.
template <class OfFigure>
TextTable table_of(const std::vector<SweptPoint>& points, OfFigure of_figure) {
  const auto names = names_of_values(points), figures = names_of_figures(points);
  const bool seeds = std::any_of(points.begin(), points.end(), [](const auto& point) { return !point.seed.empty(); });
  TextTable table{{"point"}};
  for (const auto& name : names) table.front().push_back(name);
  if (seeds) table.front().push_back("seed");
  for (const auto& name : figures) table.front().push_back(name);
  for (const auto& point : points) {
    TextRow row{fmt::to_string(point.number)};
    const auto values = point.values();
    for (const auto& name : names) {
      const auto found = values.find(name);
      row.push_back(found == values.end() ? "" : text_of_value(found->second));
    }
    if (seeds) row.push_back(point.seed);
    for (const auto& name : figures) {
      const auto found = point.figures.find(name);
      row.push_back(found == point.figures.end() ? "" : of_figure(found->second));
    }
    table.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Json SweptTrace::json() const {
  Json json{{"trace", trace}};
  for (const auto& [name, count] : counts_of_runs)
    if (this->*count != 0) json[name] = this->*count;
  if (score.speaking + score.answered > 0) json["score"] = json_of(score);
  return json;
}

const std::vector<SweepFigure>& sweep_figures() {
  static const std::vector<SweepFigure> all = {
      {"f1", "balance of missing and surplus answers"},
      {"exact", "share of observed answers that agree exactly"},
      {"lax", "share of observed answers that agree but for described places"},
      {"template", "share of observed answers of the same template"},
      {"right", "share of scored inputs with the right answer, or rightly none"},
      {"spurious", "share of scored inputs with an answer where none was observed"},
      {"met", "share of expectations met"},
      {"refused", "share of inputs refused"},
      {"done", "share of acts done"},
      {"utterances", "utterances of the avatar"},
      {"acts", "acts begun"},
      {"problems", "problems"},
  };
  return all;
}

Json figures_of(const std::vector<SweptTrace>& traces) {
  SweptTrace sum;
  bool observed = false;
  for (const auto& trace : traces) {
    for (const auto& [name, count] : counts_of_runs) sum.*count += trace.*count;
    sum.score.add(trace.score);
    observed = observed || trace.score.speaking > 0;
  }
  Json figures = Json::object();
  const auto share = [&](const char* name, int part, int of) {
    if (of > 0) figures[name] = static_cast<double>(part) / of;
  };
  const auto& score = sum.score;
  if (observed) {
    figures["f1"] = score.f1();
    share("exact", score.exact, score.speaking);
    share("lax", score.lax, score.speaking);
    share("template", score.same_template, score.speaking);
    share("right", score.right, score.inputs);
    share("spurious", score.spurious, score.inputs);
  }
  share("met", sum.expectations_met, sum.expectations);
  share("refused", sum.refusals, sum.inputs);
  share("done", sum.acts_done, sum.acts);
  figures["utterances"] = sum.utterances;
  figures["acts"] = sum.acts;
  figures["problems"] = sum.problems;
  return figures;
}

std::map<std::string, Json> SweptPoint::values() const {
  std::map<std::string, Json> values;
  for (const auto& [name, value] : set.items()) values.emplace(name, value);
  if (!policy.empty()) values.emplace("policy", policy);
  return values;
}

Result<SweptPoint> read_swept_point(std::string_view text, const std::string& name, std::size_t line) {
  const auto json = parse_json_line(text, name, line);
  if (!json) return json.error();
  const auto number = json->value("point", Json()), set = json->value("set", Json()),
             figures = json->value("figures", Json()), policy = json->value("policy", Json("")),
             seed = json->value("seed", Json());
  const auto is_number = [](const Json& one) { return one.is_number(); };
  if (!number.is_number_unsigned() || !set.is_object() || !policy.is_string() || !figures.is_object() ||
      !std::all_of(figures.begin(), figures.end(), is_number))
    return Error{fmt::format("{}:{}", name, line),
                 "is no point of a sweep; expected \"point\", \"set\" and \"figures\""};
  SweptPoint point{number.get<std::size_t>(), set, policy.get<std::string>(), seed.is_null() ? "" : compact(seed), {}};
  for (const auto& [figure, value] : figures.items()) point.figures.emplace(figure, value.get<double>());
  return point;
}

std::vector<std::string> names_of_values(const std::vector<SweptPoint>& points) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const auto& point : points)
    for (const auto& [name, value] : point.set.items()) add(name);
  for (const auto& point : points)
    if (!point.policy.empty()) add("policy");
  return names;
}

std::vector<std::string> names_of_figures(const std::vector<SweptPoint>& points) {
  std::vector<std::string> names;
  for (const auto& figure : sweep_figures())
    if (std::any_of(points.begin(), points.end(),
                    [&](const auto& point) { return point.figures.contains(figure.name); }))
      names.emplace_back(figure.name);
  return names;
}

std::string text_of_value(const Json& value) { return value.is_string() ? value.get<std::string>() : compact(value); }

std::string sweep_csv(const std::vector<SweptPoint>& points) {
  std::ostringstream out;
  for (const auto& row : table_of(points, [](double value) { return fmt::format("{}", value); })) {
    for (std::size_t i = 0; i < row.size(); ++i) write_cell(row[i], i == 0 ? out : out << ',');
    out << '\n';
  }
  return std::move(out).str();
}

std::string sweep_text(const std::vector<SweptPoint>& points) {
  return aligned(table_of(points, [](double value) { return fmt::format("{:.4g}", value); }));
}

}  // namespace continua
