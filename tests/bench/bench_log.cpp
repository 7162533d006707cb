// The cost of a run log: kinematic replays of traces or session logs, against the time that nlohmann/json takes to
// parse and dump the log that they write. bench_log FILE… writes a table; see README.md.
#include <algorithm>
#include <chrono>
#include <functional>
#include <sstream>

#include <fmt/format.h>

#include "continua/replay/session/session.h"
#include "continua/replay/trace/session_import.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

constexpr int rounds = 5;

/// The shortest wall time of the rounds.
double best_s(const std::function<void()>& work) {
  double best = 1e9;
  for (int round = 0; round < rounds; ++round) {
    const auto before = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count());
  }
  return best;
}

/// Takes a log and throws it away.
class Nothing : public std::streambuf {
  std::streamsize xsputn(const char*, std::streamsize size) override { return size; }
  int overflow(int c) override { return c; }
};

std::size_t parsed_and_dumped(const std::string& log) {
  std::istringstream lines(log);
  std::size_t bytes = 0;
  for (std::string line; std::getline(lines, line);) bytes += Json::parse(line).dump().size();
  return bytes;
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
      "| trace | log, MB | replay, s | log thrown away, s | parse and dump, s | ratio |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  double replays_s = 0, references_s = 0;
  for (int i = 1; i < argc; ++i) {
    const auto path = trace_of(argv[i], folder);
    if (!path) return fail(path.error());
    ReplayOptions options;
    options.physics = false;
    auto session = Session::load(*path, std::move(options));
    if (!session) return fail(session.error());
    std::string log;
    const double replay_s = best_s([&] {
      std::ostringstream out;
      session->run(out);
      log = out.str();
    });
    Nothing nothing;
    const double discarded_s = best_s([&] {
      std::ostream out(&nothing);
      session->run(out);
    });
    std::size_t bytes = 0;
    const double reference_s = best_s([&] { bytes += parsed_and_dumped(log); });
    fmt::print("| {} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} |\n", argv[i],
               static_cast<double>(bytes) / rounds / 1e6, replay_s, discarded_s, reference_s, replay_s / reference_s);
    std::fflush(stdout);
    replays_s += replay_s;
    references_s += reference_s;
  }
  fmt::print("| all | | {:.2f} | | {:.2f} | {:.1f} |\n", replays_s, references_s, replays_s / references_s);
}
