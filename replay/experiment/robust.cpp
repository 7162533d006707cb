#include "continua/replay/experiment/robust.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

#include "continua/core/random.h"
#include "continua/replay/experiment/ddmin.h"
#include "continua/replay/experiment/log_lines.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/world/geometry.h"

namespace continua {
namespace {

std::optional<Happened> happened_in(std::string_view record) {
  const auto kind = text_in(record, "kind");
  if (kind == "utterance") return Happened{Happened::Kind::utterance, text_in(record, "text")};
  if (kind == "act" && text_in(record, "status") == "asked" && member_in(record, "step").empty())
    return Happened{Happened::Kind::act, text_in(record, "program")};
  if (kind != "input" || member_in(record, "line") == "null") return std::nullopt;
  const auto event = text_in(member_in(record, "event"), "kind");
  if (event == "speech" || event == "gesture") return Happened{Happened::Kind::human, ""};
  return std::nullopt;
}

std::string number_of_act(std::string_view record) { return std::string(member_in(record, "act")); }

// How an act went: the statuses of its records and of its steps'.
struct Course {
  bool has_done_step = false;
  std::string last;
};

std::map<std::string, Course> courses_of_acts(std::string_view log) {
  std::map<std::string, Course> courses;
  each_line(log, [&](std::string_view record) {
    if (text_in(record, "kind") != "act") return;
    auto& course = courses[number_of_act(record)];
    const auto status = text_in(record, "status");
    if (member_in(record, "step").empty())
      course.last = status;
    else if (status == "done")
      course.has_done_step = true;
  });
  return courses;
}

// The body refused the act at its beginning: nothing moved, and the avatar says why.
bool came_to_nothing(const Course& course) {
  return !course.has_done_step && (course.last == "blocked" || course.last == "unreachable");
}

std::vector<std::string> texts_of(const std::vector<Happened>& all, Happened::Kind kind) {
  std::vector<std::string> texts;
  for (const auto& one : all)
    if (one.kind == kind) texts.push_back(one.text);
  return texts;
}

// People who point at a place do not tell it more exactly, metres.
constexpr double same_place_m = 0.1;

// Equal but for points, as "<0.1, -0.2, 0>", that are near each other.
bool is_same_act(std::string_view a, std::string_view b) {
  const auto point_at = [](std::string_view text, std::size_t from) {
    Vec3 point = Vec3::Zero();
    const auto end = text.find('>', from);
    const std::string piece(text.substr(from, end - from));
    const bool is_point = end != std::string_view::npos &&
                          std::sscanf(piece.c_str(), "<%lf, %lf, %lf", &point.x(), &point.y(), &point.z()) == 3;
    return is_point ? std::optional(point) : std::nullopt;
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const auto one = point_at(a, i), other = point_at(b, j);
    if (one && other && (*one - *other).norm() < same_place_m) {
      i = a.find('>', i) + 1;
      j = b.find('>', j) + 1;
    } else if (a[i++] != b[j++]) {
      return false;
    }
  }
  return i == a.size() && j == b.size();
}

// The first acts of `some` that are not among those of `all`, in this order; empty if it leaves some out at most.
std::vector<std::string> besides(const std::vector<std::string>& some, const std::vector<std::string>& all) {
  std::vector<std::string> others;
  auto from = all.begin();
  for (const auto& one : some) {
    const auto found = std::find_if(from, all.end(), [&](const auto& other) { return is_same_act(one, other); });
    if (found == all.end())
      others.push_back(one);
    else
      from = found + 1;
  }
  return others;
}

// The number of happenings until the human goes on after the first utterance that is none of the other run; all of
// them where there is none. The first of two values: whether there is one.
std::pair<bool, std::size_t> first_other_answer(const std::vector<Happened>& whole,
                                                const std::vector<Happened>& noisy) {
  const auto said = texts_of(whole, Happened::Kind::utterance);
  auto from = said.begin();
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    if (noisy[i].kind != Happened::Kind::utterance) continue;
    const auto found = std::find(from, said.end(), noisy[i].text);
    if (found != said.end()) {
      from = found + 1;
      continue;
    }
    while (i < noisy.size() && noisy[i].kind != Happened::Kind::human) ++i;
    return {true, i};
  }
  return {false, noisy.size()};
}

std::vector<Happened> until_other_answer(const std::vector<Happened>& whole, const std::vector<Happened>& noisy) {
  const auto size = static_cast<std::ptrdiff_t>(first_other_answer(whole, noisy).second);
  return {noisy.begin(), noisy.begin() + size};
}

class Trials {
 public:
  Trials(Session& session, const RobustOptions& options, Trace trace)
      : session_(session), options_(options), trace_(std::move(trace)), seed_(own_seed(options.seed, trace_)) {}

  Result<Robustness> run() {
    auto whole = run_of(edited_trace(trace_, {}));
    if (!whole) return whole.error();
    whole_ = *std::move(whole);
    Robustness found;
    for (const auto& kind : noise_kinds()) {
      if (!has_kind(options_.noise, kind) || !applies(kind)) continue;
      bool broken = false;
      for (const double strength : options_.strengths) {
        RobustPoint point{kind, strength};
        for (int i = 0; i < options_.count; ++i) {
          const auto edits =
              edits_of(trace_, only(options_.noise, kind, strength), seed_ + static_cast<std::uint64_t>(i));
          const auto end = edits.empty() ? RunEnd::same : end_of(edited_trace(trace_, edits));
          ++point.ends[static_cast<std::size_t>(end)];
          if (end != RunEnd::otherwise || broken) continue;
          broken = true;
          found.breaks.push_back(smallest(edits, kind, strength));
        }
        found.points.push_back(point);
      }
    }
    return found;
  }

 private:
  // Traces of the same form would err alike by the same seed.
  static std::uint64_t own_seed(std::uint64_t seed, const Trace& trace) {
    for (const char c : write_trace(trace)) seed = Random(seed ^ static_cast<unsigned char>(c)).next();
    return seed;
  }

  // Whether the trace has anything that this kind of noise changes.
  bool applies(const std::string& kind) const {
    const auto strongest = std::max_element(options_.strengths.begin(), options_.strengths.end());
    const auto noise = only(options_.noise, kind, *strongest);
    for (int i = 0; i < options_.count; ++i)
      if (!edits_of(trace_, noise, seed_ + static_cast<std::uint64_t>(i)).empty()) return true;
    return false;
  }

  Result<std::vector<Happened>> run_of(const Trace& trace) {
    std::ostringstream log;
    const auto run = session_.run(trace, {}, log);
    if (!run) return run.error();
    return happenings_of(log.view());
  }

  RunEnd end_of(const Trace& trace) {
    const auto run = run_of(trace);
    require(run.ok(), "a trace with other events can be replayed");
    return run_end(whole_, *run);
  }

  Break smallest(const std::vector<Edit>& edits, const std::string& kind, double strength) {
    const auto breaks = [&](const Indices& part) {
      return end_of(edited_trace(trace_, part_of(edits, part))) == RunEnd::otherwise;
    };
    const auto least = part_of(edits, ddmin(edits.size(), breaks));
    Break found{session_.trace().head().name, kind, strength, {}, {}, edited_trace(trace_, least)};
    for (const auto& edit : least) found.sentences.push_back(edit.sentence);
    const auto run = run_of(found.with);
    found.acts =
        besides(texts_of(until_other_answer(whole_, *run), Happened::Kind::act), texts_of(whole_, Happened::Kind::act));
    return found;
  }

  Session& session_;
  const RobustOptions& options_;
  const Trace trace_;
  const std::uint64_t seed_;  // of its first run
  std::vector<Happened> whole_;
};

}  // namespace

std::vector<Happened> happenings_of(std::string_view log) {
  const auto courses = courses_of_acts(log);
  std::vector<Happened> all;
  each_line(log, [&](std::string_view record) {
    if (auto one = happened_in(record))
      if (one->kind != Happened::Kind::act || !came_to_nothing(courses.at(number_of_act(record))))
        all.push_back(*std::move(one));
  });
  return all;
}

RunEnd run_end(const std::vector<Happened>& whole, const std::vector<Happened>& noisy) {
  const auto acts = texts_of(whole, Happened::Kind::act);
  const auto done = texts_of(noisy, Happened::Kind::act);
  if (std::equal(done.begin(), done.end(), acts.begin(), acts.end(), is_same_act)) return RunEnd::same;
  const auto then = texts_of(until_other_answer(whole, noisy), Happened::Kind::act);
  if (!besides(then, acts).empty()) return RunEnd::otherwise;
  return first_other_answer(whole, noisy).first ? RunEnd::asks : RunEnd::less;
}

int RobustPoint::runs() const {
  int sum = 0;
  for (const int one : ends) sum += one;
  return sum;
}

double RobustPoint::share(RunEnd end) const {
  return runs() ? static_cast<double>(ends[static_cast<std::size_t>(end)]) / runs() : 0;
}

Result<Robustness> robustness_of(Session& session, const RobustOptions& options) {
  auto events = session.trace().events();
  if (!events) return events.error();
  return Trials(session, options, Trace{{session.trace().head()}, *std::move(events)}).run();
}

void add(Robustness& sum, Robustness more) {
  for (auto& point : more.points) {
    const auto known = std::find_if(sum.points.begin(), sum.points.end(), [&](const RobustPoint& one) {
      return one.kind == point.kind && one.strength == point.strength;
    });
    if (known == sum.points.end())
      sum.points.push_back(std::move(point));
    else
      for (std::size_t i = 0; i < run_ends; ++i) known->ends[i] += point.ends[i];
  }
  std::move(more.breaks.begin(), more.breaks.end(), std::back_inserter(sum.breaks));
}

}  // namespace continua
