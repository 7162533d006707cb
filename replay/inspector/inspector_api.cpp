#include "continua/replay/inspector/inspector_api.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/diff/run_diff_text.h"
#include "continua/replay/explain/explain.h"
#include "continua/replay/explain/run_account.h"
#include "continua/replay/inspector/run_agreement.h"
#include "continua/replay/inspector/run_columns.h"
#include "continua/replay/inspector/run_find.h"
#include "continua/replay/inspector/run_labels.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_listing.h"
#include "continua/replay/log/run_views.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

constexpr std::size_t most_records = 5000;  // in one answer
constexpr std::size_t most_worlds = 4;      // kept
constexpr std::size_t most_numbers = 500;   // named one by one
constexpr std::size_t most_kept = 100;      // answers of other kinds than these
constexpr std::size_t most_columns = 2;     // runs of which they are kept
constexpr std::size_t most_diffs = 4;       // pairs of which they are kept
constexpr auto json_type = "application/json";
constexpr auto bytes_type = "application/octet-stream";

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string decoded(std::string_view text, bool plus_is_space) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && hex_value(text[i + 1]) >= 0 && hex_value(text[i + 2]) >= 0) {
      out += static_cast<char>(hex_value(text[i + 1]) * 16 + hex_value(text[i + 2]));
      i += 2;
    } else {
      out += plus_is_space && text[i] == '+' ? ' ' : text[i];
    }
  }
  return out;
}

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const auto end = std::min(text.find(at, from), text.size());
    if (end > from) parts.emplace_back(text.substr(from, end - from));
    from = end + 1;
  }
  return parts;
}

// A number of the query, `otherwise` when it is not given, or a sentence about a value that is no number.
template <class Number>
Result<Number> number(const Query& query, const char* name, Number otherwise) {
  const auto found = query.find(name);
  if (found == query.end()) return otherwise;
  if (const auto value = number_in<Number>(found->second)) return *value;
  return Error{"", fmt::format("{}={} is not a number", name, found->second)};
}

Result<std::size_t> record_number(const Query& query, const RunIndex& run) {
  if (!query.count("n")) return Error{"", "n is missing: the number of a record"};
  auto n = number<std::size_t>(query, "n", 0);
  if (n && *n >= run.size()) return Error{"", fmt::format("n={}: the run has records 0 to {}", *n, run.size() - 1)};
  return n;
}

Result<RecordFilter> record_filter(const Query& query) {
  RecordFilter filter;
  if (const auto kinds = query.find("kind"); kinds != query.end()) filter.kinds = split(kinds->second, ',');
  for (const auto& [name, into] : {std::pair{"from", &filter.from_s}, {"to", &filter.to_s}}) {
    if (!query.count(name)) continue;
    const auto seconds = number<double>(query, name, 0);
    if (!seconds) return seconds.error();
    *into = *seconds;
  }
  const auto after = number<std::size_t>(query, "after", 0), limit = number<std::size_t>(query, "limit", filter.limit);
  if (!after) return after.error();
  if (!limit) return limit.error();
  filter.after = *after;
  filter.limit = std::min(*limit, most_records);
  return filter;
}

// n=5,17,300 or from=N&limit=K, in order.
Result<std::vector<std::size_t>> record_numbers(const Query& query, const RunIndex& run) {
  std::vector<std::size_t> numbers;
  if (const auto named = query.find("n"); named != query.end()) {
    for (const auto& part : split(named->second, ',')) {
      const auto n = number_in<std::size_t>(part);
      if (!n || *n >= run.size())
        return Error{"", fmt::format("n={}: the run has records 0 to {}", part, run.size() - 1)};
      numbers.push_back(*n);
    }
    if (numbers.size() > most_numbers) return Error{"", fmt::format("n: more than {} numbers", most_numbers)};
    std::sort(numbers.begin(), numbers.end());
    return numbers;
  }
  const auto from = number<std::size_t>(query, "from", 0), limit = number<std::size_t>(query, "limit", most_numbers);
  if (!from) return from.error();
  if (!limit) return limit.error();
  for (auto n = *from; n < run.size() && numbers.size() < std::min(*limit, most_records); ++n) numbers.push_back(n);
  return numbers;
}

std::string text_of_query(const Query& query, const char* name) {
  const auto found = query.find(name);
  return found == query.end() ? std::string() : found->second;
}

Result<std::string> work_out(const RunIndex& log, const std::string& id, const std::string& view) {
  if (view == "columns") return run_columns(log);
  auto told = view == "graph" ? run_graph(log) : run_summary(log);
  if (!told) return told.error();
  if (view != "") return compact(*told);
  (*told)["id"] = id;
  auto agreement = run_agreement(log);
  if (!agreement) return agreement.error();
  (*told)["as_observed"] = *std::move(agreement);
  return compact(*told);
}

ApiResponse labels(const RunIndex& log, const Query& query) {
  const auto numbers = record_numbers(query, log);
  return numbers ? answer(run_labels(log, *numbers)) : api_error(400, numbers.error().sentence);
}

ApiResponse find(const RunIndex& log, const Query& query) {
  const auto found = run_find(log, text_of_query(query, "text"), text_of_query(query, "kind"));
  if (!found) return api_error(500, found.error().text());
  return {200, bytes_type,
          std::string(reinterpret_cast<const char*>(found->data()), found->size() * sizeof(found->front()))};
}

}  // namespace

ApiResponse answer(const Json& body, int status) { return {status, json_type, compact(body)}; }
ApiResponse answer(const Result<Json>& body) { return body ? answer(*body) : api_error(500, body.error().text()); }

ApiResponse api_error(int status, const std::string& message) {
  return {status, json_type, compact(Json{{"error", {{"message", message}}}})};
}

Target split_target(std::string_view target) {
  Target split_up;
  const auto question = target.find('?');
  split_up.path = decoded(target.substr(0, question), false);
  if (question == std::string_view::npos) return split_up;
  for (const auto& part : split(target.substr(question + 1), '&')) {
    const auto equals = std::min(part.find('='), part.size());
    const auto value = equals < part.size() ? std::string_view(part).substr(equals + 1) : std::string_view();
    split_up.query.emplace(decoded(part.substr(0, equals), true), decoded(value, true));
  }
  return split_up;
}

ApiResponse InspectorApi::get(std::string_view target) {
  const auto [path, query] = split_target(target);
  const auto parts = split(path, '/');
  if (parts.size() >= 2 && parts[0] == "api") {
    if (parts[1] == "runs" && parts.size() == 2) return answer(Json{{"runs", listings_.all()}});
    if (parts[1] == "runs" && parts.size() == 6 && parts[3] == "media" && parts[5] == "peaks") return peaks(path);
    if (parts[1] == "runs" && parts.size() <= 4) return run(parts[2], parts.size() == 4 ? parts[3] : "", query);
    if (parts[1] == "schema" && parts.size() == 2) return answer(log::schema_json());
    if (parts[1] == "diff" && parts.size() == 2) return diff(query);
    if (parts[1] == "sessions") return api_error(501, "live sessions are not served by this version");
  }
  return api_error(404, fmt::format("there is nothing at {}", path));
}

void InspectorApi::start_preparing() {
  listings_.start([this](const std::string& id) {
    const auto opened = library_.open(id);
    // Views of a log that grows are out of date before anybody asks for them.
    if (!opened || !*opened || is_live(**opened)) return;
    for (const char* view : {"", "graph", "columns"}) kept(*opened, id, view);
  });
}

bool InspectorApi::is_live(const RunIndex& log) const {
  return !log.complete() && library_.is_being_written(log.path(), file_state(log.path()));
}

ApiResponse InspectorApi::growth(const std::string& id) {
  const auto opened = library_.open(id);
  if (!opened) return api_error(422, opened.error().text());
  if (!*opened) return api_error(404, fmt::format("there is no run '{}'", id));
  const RunIndex& log = **opened;
  return answer(Json{{"records", log.size()},
                     {"t", log.entry(log.size() - 1).t.seconds()},
                     {"complete", log.complete()},
                     {"live", is_live(log)}});
}

ApiResponse InspectorApi::run(const std::string& id, const std::string& view, const Query& query) {
  const auto opened = library_.open(id);
  if (!opened) return api_error(422, opened.error().text());
  if (!*opened) return api_error(404, fmt::format("there is no run '{}'", id));
  const RunIndex& log = **opened;

  if (view == "records") {
    const auto filter = record_filter(query);
    if (!filter) return api_error(400, filter.error().sentence);
    auto records = run_records(log, *filter);
    return records ? ApiResponse{200, json_type, *std::move(records)} : api_error(500, records.error().text());
  }
  if (view == "stack" || view == "derivation") {
    const auto n = record_number(query, log);
    if (!n) return api_error(400, n.error().sentence);
    if (view == "derivation") return answer(run_derivation(log, *n));
    if (!query.count("branch")) return answer(run_stack(log, *n));
    const auto branch = number<std::int64_t>(query, "branch", 0);
    if (!branch) return api_error(400, branch.error().sentence);
    const auto stack = run_branch_stack(log, *n, *branch);
    return stack ? answer(*stack) : api_error(404, stack.error().sentence);
  }
  if (view == "explain") {
    const auto n = record_number(query, log);
    if (!n) return api_error(400, n.error().sentence);
    const auto cell = query.find("cell");
    if (cell == query.end()) {
      auto told = explain(log, *n);
      if (told) (*told)["run"] = id;  // pages are given away, and paths are this machine's
      return answer(told);
    }
    const auto told = explain_cell(log, *n, cell->second);
    return told ? answer(*told) : api_error(404, told.error().sentence);
  }
  if (view == "account") {
    const auto account = run_account(log);
    return account ? answer(*account) : api_error(422, account.error().text());
  }
  if (view == "labels") return labels(log, query);
  if (view == "find") return find(log, query);
  if (view == "frame") return frame(*opened, query);
  if (view == "notes") return notes(log);
  if (view == "media") return media(id);
  if (view == "poses") return poses(*opened, query);
  if (view == "scene") {
    const auto scene = run_scene(log);
    return scene ? answer(*scene) : api_error(422, scene.error().text());
  }
  if (view != "" && view != "graph" && view != "columns") return api_error(404, fmt::format("a run has no '{}'", view));

  return kept(*opened, id, view);
}

bool InspectorApi::Kept::is_of(const Runs& asked) const {
  return std::equal(runs.begin(), runs.end(), asked.begin(), asked.end(),
                    [](const auto& run, const auto& one) { return run.lock() == one; });
}

ApiResponse InspectorApi::kept(const std::shared_ptr<const RunIndex>& run, const std::string& id,
                               const std::string& view) {
  return kept({run}, id, view, view == "columns" ? most_columns : most_kept, [&] { return work_out(*run, id, view); });
}

// Answers that depend on logs alone: worked out once. `most` of this view are kept.
ApiResponse InspectorApi::kept(const Runs& runs, const std::string& ids, const std::string& view, std::size_t most,
                               const std::function<Result<std::string>()>& work_out) {
  const std::string type = view == "columns" ? bytes_type : json_type;
  {
    const std::lock_guard lock(mutex_);
    const auto known =
        std::find_if(kept_.begin(), kept_.end(), [&](const Kept& one) { return one.view == view && one.ids == ids; });
    if (known != kept_.end() && known->is_of(runs)) {
      kept_.splice(kept_.begin(), kept_, known);
      return {200, type, known->body};
    }
  }
  auto body = work_out();
  if (!body) return api_error(view == "diff" ? 422 : 500, body.error().text());
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const Kept& one) {
    return (one.view == view && one.ids == ids) ||
           std::any_of(one.runs.begin(), one.runs.end(), [](const auto& run) { return run.expired(); });
  });
  kept_.push_front({ids, view, {runs.begin(), runs.end()}, *body});
  std::size_t of_view = 0;
  std::erase_if(kept_, [&](const Kept& one) { return one.view == view && ++of_view > most; });
  return {200, type, *std::move(body)};
}

ApiResponse InspectorApi::poses(const std::shared_ptr<const RunIndex>& run, const Query& query) {
  const auto end = run->entry(run->size() - 1).t.seconds();
  const auto from = number<double>(query, "from", 0), to = number<double>(query, "to", end);
  if (!from) return api_error(400, from.error().sentence);
  if (!to) return api_error(400, to.error().sentence);
  if (!(*from >= 0 && *from <= *to && *to <= latest_s))
    return api_error(
        400, fmt::format("from={} and to={}; expected seconds from 0, the first not after the second", *from, *to));
  const auto world = world_of(run);
  if (!world) return api_error(422, world.error().text());
  return answer((*world)->window(SimTime::from_seconds(*from), SimTime::from_seconds(*to)));
}

Result<std::shared_ptr<RunWorld>> InspectorApi::world_of(const std::shared_ptr<const RunIndex>& run) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::find_if(worlds_.begin(), worlds_.end(), [&](const auto& kept) { return kept.run == run; });
    if (known != worlds_.end()) {
      worlds_.splice(worlds_.begin(), worlds_, known);
      return worlds_.front().world;
    }
  }
  auto world = RunWorld::read(run);
  if (!world) return world;
  const std::lock_guard lock(mutex_);
  // The world of a log which has changed since is of no more use.
  worlds_.remove_if([&](const KeptWorld& kept) { return kept.run->path() == run->path(); });
  worlds_.push_front({run, *world});
  if (worlds_.size() > most_worlds) worlds_.pop_back();
  return world;
}

ApiResponse InspectorApi::diff(const Query& query) {
  Runs sides;
  std::string ids;
  for (const char* side : {"a", "b"}) {
    const auto id = query.find(side);
    if (id == query.end()) return api_error(400, fmt::format("{} is missing: the id of a run", side));
    const auto opened = library_.open(id->second);
    if (!opened) return api_error(422, opened.error().text());
    if (!*opened) return api_error(404, fmt::format("there is no run '{}'", id->second));
    sides.push_back(*opened);
    ids += id->second + '\n';
  }
  const auto tolerance = number<double>(query, "tolerance", DiffOptions().tolerance_m);
  if (!tolerance) return api_error(400, tolerance.error().sentence);
  if (!(*tolerance >= 0)) return api_error(400, fmt::format("tolerance={}; expected metres from 0", *tolerance));
  return kept(sides, fmt::format("{}{}", ids, *tolerance), "diff", most_diffs, [&]() -> Result<std::string> {
    const auto told = diff_runs(*sides[0], *sides[1], {*tolerance});
    if (!told) return told.error();
    auto body = diff_json(*sides[0], *sides[1], *told);
    body["pairs"] = told->pairs;
    body["markdown"] = diff_markdown(*sides[0], *sides[1], *told);
    return compact(body);
  });
}

ApiResponse InspectorApi::frame(const std::shared_ptr<const RunIndex>& run, const Query& query) {
  if (!query.count("t")) return api_error(400, "t is missing: seconds from the run's start");
  const auto t = number<double>(query, "t", 0);
  if (!t) return api_error(400, t.error().sentence);
  const auto end = run->entry(run->size() - 1).t;
  if (!(*t >= 0 && *t <= end.seconds()))
    return api_error(400, fmt::format("t={}: the run goes from 0 to {} s", *t, end.seconds()));
  const auto found = query.find("size");
  const std::string size = found == query.end() ? "" : found->second;
  if (!frames_) return api_error(501, "pictures are not served here");
  if (const auto wrong = frames_->wrong_size(size)) return api_error(400, "size: " + wrong->sentence);
  if (const auto missing = frames_->unavailable()) return api_error(501, missing->text());
  auto png = frames_->png(run, SimTime::from_seconds(*t), size);
  if (!png) return api_error(422, png.error().text());
  return {200, "image/png", std::move(png).value()};
}

}  // namespace continua
