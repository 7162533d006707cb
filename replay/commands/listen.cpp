#include "continua/replay/commands/listen.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/trace/event_shift.h"
#include "continua/replay/trace/trace_event.h"

namespace continua {
namespace {

constexpr const char* input_name = "standard input";

// Writes what a stream knows.
class Listening {
 public:
  Listening(const ListenFilterOptions& options, std::shared_ptr<const Camera> camera)
      : format_(*recogniser_format(options.from)),
        now_(options.now),
        stream_(format_, {input_name, now_, std::move(camera), knowledge_folder()}) {
    if (!format_.of_calendar) start_clock();
  }

  void add(std::string_view text) {
    stream_.add(text);
    tell();
  }
  void end() {
    stream_.end();
    tell();
  }
  std::size_t refused() const { return refused_; }

 private:
  static std::string knowledge_folder() {
    const auto data = find_data_paths();
    return data ? data->knowledge.string() : "";
  }

  void tell() {
    while (auto gain = stream_.next()) {
      for (const auto& problem : gain->problems) refuse(problem);
      for (auto& event : gain->events) tell(std::move(event));
    }
  }

  void tell(Json event) {
    if (now_)
      for (const char* member : {"t", "until", "words"}) event.erase(member);
    if (event.contains("t")) event = since_first(std::move(event));
    auto checked = event;
    if (!checked.contains("t")) checked["t"] = 0;
    std::vector<Error> problems;
    std::vector<Note> notes;
    event_from_json(std::move(checked), input_name, stream_.line(), problems, notes);
    if (!problems.empty()) return refuse(problems.front());
    write(event);
  }

  // Times of a calendar become times since the first event.
  Json since_first(Json event) {
    if (!first_s_) {
      const double t_s = event["t"].get<double>();
      first_s_ = t_s >= least_calendar_s ? t_s : 0;
      if (format_.of_calendar) start_clock();
    }
    return shifted_event(std::move(event), SimTime{} - SimTime::from_seconds(*first_s_));
  }

  // A session that goes by the wall's clock begins together with the recogniser's time.
  void start_clock() const {
    if (!now_) write({{"kind", "clock"}, {"t", 0}});
  }

  static void write(const Json& event) {
    put(stdout, compact(event) + "\n");
    std::fflush(stdout);
  }

  void refuse(const Error& problem) {
    report(problem);
    ++refused_;
  }

  const RecogniserFormat& format_;
  bool now_;
  RecogniserStream stream_;
  std::optional<double> first_s_;  // 0: times are those of a recording
  std::size_t refused_ = 0;
};

}  // namespace

int run_listen(const ListenFilterOptions& options) {
  const auto camera = named_camera(options.camera);
  if (!camera) return report(camera.error()), exit_impossible;
  Listening listening(options, *camera);
  std::array<char, 65536> piece;
  for (;;) {
    const auto size = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return report({input_name, fmt::format("cannot be read: {}", std::strerror(errno))}), exit_impossible;
    if (size == 0) break;
    listening.add({piece.data(), static_cast<std::size_t>(size)});
  }
  listening.end();
  return listening.refused() > 0 ? exit_no : exit_done;
}

void describe_listen(CLI::App& command, ListenFilterOptions& options) {
  std::vector<std::string> formats;
  std::string described = "what standard input is";
  for (const auto& format : recogniser_formats()) {
    formats.emplace_back(format.name);
    described += fmt::format("; {}: {}", format.name, format.what);
  }
  command.add_option("--from", options.from, described)->check(CLI::IsMember(formats))->required();
  command.add_option("--camera", options.camera,
                     "where the recogniser's camera is (RECOGNISERS.md): hands become pointing rays");
  command.add_flag("--now", options.now,
                   "events happen as they arrive; otherwise at the times that the recogniser tells, and as they arrive "
                   "where it tells none");
  command.footer(
      "With record --clock wall, times count from the beginning of listen.\n"
      "Examples: my_vosk.py | continua listen --from vosk | continua record --clock wall -o talk.trace.jsonl\n"
      "          pocketsphinx_continuous -infile talk.wav -time yes | continua listen --from pocketsphinx\n"
      "          pocketsphinx_continuous -inmic yes | continua listen --from pocketsphinx --now | continua record");
}

}  // namespace continua
