// The cost of a run log: kinematic replays of traces or session logs, against the time that nlohmann/json takes to
// parse and dump the log that they write. bench_log FILE… writes a table; see README.md.
#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "continua/core/replaced_file.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/session_import.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

constexpr int rounds = 5;

/// The shortest processor time of each work in turn, over the rounds: a neighbour's load meets all of them alike.
template <std::size_t count>
std::array<double, count> best_s(const std::array<std::function<void()>, count>& works) {
  std::array<double, count> best;
  best.fill(1e9);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto before = std::clock();
      works[i]();
      best[i] = std::min(best[i], static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    }
  }
  return best;
}

std::size_t parsed_and_dumped(const std::string& log) {
  std::istringstream lines(log);
  std::size_t bytes = 0;
  for (std::string line; std::getline(lines, line);) bytes += Json::parse(line).dump().size();
  return bytes;
}

std::string text_of(const std::function<void(std::ostream&)>& written) {
  std::ostringstream out;
  written(out);
  return out.str();
}

Result<std::string> trace_of(const std::string& path, const TemporaryFolder& folder) {
  if (path.ends_with(".trace.jsonl")) return path;
  auto trace = import_session(path);
  if (!trace) return trace.error();
  return folder.file("session.trace.jsonl", write_trace(*trace));
}

int fail(const Error& error) {
  fmt::print(stderr, "bench_log: {}\n", error.text());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print("bench_log: skipped, no traces and no session logs were named\n");
    return 0;
  }
  const TemporaryFolder folder;
  fmt::print(
      "| trace | log, MB | replay, s | records thrown away, s | parse and dump, s | ratio | cost of the log |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  const auto print_row = [](const std::string& name, std::size_t bytes, const std::array<double, 3>& times_s) {
    const auto [replay_s, thrown_away_s, reference_s] = times_s;
    fmt::print("| {} | {:.1f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} |\n", name, static_cast<double>(bytes) / 1e6,
               replay_s, thrown_away_s, reference_s, replay_s / reference_s, replay_s / thrown_away_s);
    std::fflush(stdout);
  };
  ReplacedFile null_file("/dev/null");  // as a replay writes one, without the disk
  std::ostream nowhere(nullptr);
  std::size_t all_bytes = 0;
  std::array<double, 3> all_s{};
  for (int i = 1; i < argc; ++i) {
    const auto path = trace_of(argv[i], folder);
    if (!path) return fail(path.error());
    ReplayOptions options;
    options.physics = false;
    auto session = Session::load(*path, std::move(options));
    if (!session) return fail(session.error());
    const auto replay = [&](std::ostream& out) { session->run(out); };
    const auto log = text_of(replay);
    std::size_t bytes = 0;  // so that no work is left out
    const auto times_s = best_s<3>(
        {[&] { replay(null_file.stream()); }, [&] { replay(nowhere); }, [&] { bytes += parsed_and_dumped(log); }});
    if (bytes < log.size()) return 1;
    print_row(argv[i], log.size(), times_s);
    all_bytes += log.size();
    for (std::size_t k = 0; k < 3; ++k) all_s[k] += times_s[k];
  }
  print_row("all", all_bytes, all_s);
}
