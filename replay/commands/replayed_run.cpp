#include "continua/replay/commands/replayed_run.h"

#include "continua/replay/commands/command.h"
#include "continua/replay/log/run_log_file.h"
#include "continua/replay/terminal/progress.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {

Result<std::string> replayed_run(const std::string& trace, ReplayOptions options, const std::filesystem::path& folder) {
  Progress progress(1);
  options.progress = [&](double done) { progress.show(0, done); };
  auto session = Session::load(trace, std::move(options));
  if (!session) return session.error();
  if (session->warning()) report_warning(*session->warning());
  const auto path = (folder / (trace_name(trace) + ".run.jsonl")).string();
  RunLogFile file(path);
  if (!file.stream()) return *file.commit();
  const auto summary = session->run(file.stream());
  progress.clear();
  if (summary.stopped) return *summary.stopped;
  if (const auto problem = file.commit()) return *problem;
  return path;
}

}  // namespace continua
