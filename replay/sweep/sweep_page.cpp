#include "continua/replay/sweep/sweep_page.h"

#include <fmt/format.h>

#include "continua/core/markup.h"
#include "continua/replay/sweep/sweep_result.h"
#include "continua/replay/terminal/shell_word.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace {

// With more runs than this the page tells the points alone: it is read as a whole.
constexpr std::size_t most_runs = 100'000;

constexpr const char* head = R"html(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Sweep</title>
<style>
  :root { color-scheme: light dark; }
  body { margin: 0 auto; padding: 1rem; max-width: 76rem; font: 16px/1.5 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; }
  h1 { font-size: 1.4rem; } h2 { font-size: 1.1rem; }
  .wide { overflow-x: auto; max-height: 30rem; }
  table { border-collapse: collapse; font-size: .85rem; }
  th, td { padding: .2rem .6rem; border-bottom: 1px solid #8885; text-align: right; white-space: nowrap; }
  th:first-child, td:first-child { text-align: left; }
  pre { padding: .6rem .8rem; background: #8882; border-radius: 6px; white-space: pre-wrap; overflow-wrap: anywhere; }
  img { max-width: 100%; }
</style>
<body>
<h1>Sweep</h1>
)html";

constexpr const char* body = R"html(
<h2>Points</h2>
<p>Pick a point, and another one to compare it with.</p>
<div class="wide"><table id="points"></table></div>
<h2 id="compared"></h2>
<pre id="commands"></pre>
<div class="wide"><table id="runs"></table></div>
<script>
"use strict";
const sweep = JSON.parse(document.getElementById("sweep").textContent);
const points = sweep.points;
const picked = { A: points[0], B: points[points.length - 1] };
const union = (of) => [...new Set(points.flatMap((point) => Object.keys(of(point))))];
const settings = union((point) => point.values), figures = union((point) => point.figures);
const short = (value) => (typeof value === "number" && !Number.isInteger(value) ? value.toPrecision(4) : String(value ?? ""));

function row(cells, tag = "td") {
  const tr = document.createElement("tr");
  for (const cell of cells) {
    const td = document.createElement(tag);
    td.append(cell);
    tr.append(td);
  }
  return tr;
}

function pick(which, point) {
  const input = document.createElement("input");
  input.type = "radio";
  input.name = which;
  input.checked = picked[which] === point;
  input.ariaLabel = `point ${point.point} as ${which}`;
  input.onchange = () => { picked[which] = point; show(); };
  return input;
}

function show() {
  const { A, B } = picked;
  const run = (point, trace) => `${sweep.folder}/runs/${point.point}/${trace}.run.jsonl`;
  const lines = [A, B].map((point) => `continua replay ${point.command} -o ${sweep.folder}/runs/${point.point}/`);
  document.getElementById("compared").textContent = `Point ${A.point} and point ${B.point}`;
  const rows = sweep.traces.map((name, i) => ({ name, a: A.runs?.[i] ?? [], b: B.runs?.[i] ?? [] }));
  const other = rows.filter(({ a, b }) => String(a) !== String(b));
  const first = (other[0] ?? rows[0]).name;
  lines.push(`continua diff ${run(A, first)} ${run(B, first)}`, `continua serve ${sweep.folder}/runs`);
  document.getElementById("commands").textContent = lines.join("\n");
  const table = document.getElementById("runs");
  if (other.length === 0) {
    table.replaceChildren(row(["The counts of all runs are equal."]));
    return;
  }
  table.replaceChildren(row(["runs whose counts differ", ...sweep.counts.flatMap((count) => [`${count} A`, "B"])], "th"));
  for (const { name, a, b } of other)
    table.append(row([name, ...sweep.counts.flatMap((_, i) => [short(a[i]), short(b[i])])]));
}

const table = document.getElementById("points");
table.append(row(["A", "B", "point", ...settings, "seed", ...figures], "th"));
for (const point of points)
  table.append(row([pick("A", point), pick("B", point), String(point.point), ...settings.map((name) => short(point.values[name])),
    short(point.seed), ...figures.map((name) => short(point.figures[name]))]));
show();
</script>
</body>
</html>
)html";

constexpr const char* shown_counts[] = {"inputs", "refusals", "utterances", "acts_done", "expectations_met"};

// The trace's counts, with the number of its right answers at the end.
Json counts_in(const Json& trace) {
  Json all = Json::array();
  for (const auto* count : shown_counts) all.push_back(trace.value(count, Json(0)));
  all.push_back(trace.contains("score") ? trace["score"].value("lax", Json(0)) : Json(0));
  return all;
}

Json point_of(const Json& line, bool with_runs) {
  Json values = line["set"];
  if (line.contains("policy")) values["policy"] = line["policy"];
  std::string command;
  Json runs = Json::array();
  for (const auto& trace : line["traces"]) {
    command += shell_word(trace["trace"].get<std::string>()) + " ";
    if (with_runs) runs.push_back(counts_in(trace));
  }
  Json point{{"point", line["point"]}, {"values", std::move(values)}, {"figures", line["figures"]}};
  point["seed"] = line.value("seed", Json());
  point["command"] = command + line["with"].get<std::string>();
  if (with_runs) point["runs"] = std::move(runs);
  return point;
}

}  // namespace

std::string sweep_page(const std::vector<Json>& lines, const std::string& folder,
                       const std::vector<std::string>& pictures) {
  Json sweep{{"folder", shell_word(folder)}, {"traces", Json::array()}, {"counts", Json::array()}};
  for (const auto* count : shown_counts) sweep["counts"].push_back(count);
  sweep["counts"].push_back("answers right");
  for (const auto& trace : lines.front()["traces"])
    sweep["traces"].push_back(trace_name(trace["trace"].get<std::string>()));
  for (const auto& line : lines)
    sweep["points"].push_back(point_of(line, lines.size() * line["traces"].size() <= most_runs));
  std::string data;
  for (const char c : compact(sweep)) data += c == '<' ? "\\u003c" : std::string(1, c);
  std::string page = head;
  for (const auto& picture : pictures)
    page += fmt::format("<p><img src=\"{0}\" alt=\"{0}\"></p>\n", in_markup(picture));
  return page + "<script type=\"application/json\" id=\"sweep\">" + data + "</script>" + body;
}

}  // namespace continua
