#include "continua/replay/inspector/run_agreement.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_text.h"
#include "continua/replay/score/score.h"

namespace continua {
namespace {

std::string text_of_member(std::string_view line, std::string_view key) { return text_in(member_in(line, key)); }

// An input of the trace, or a move.
struct Happening {
  enum class Of { human, other, avatar } of = Of::human;
  SimTime t;
  AvatarMove move;
  bool sample = false;
};

class Reader {
 public:
  explicit Reader(const RunIndex& run) : run_(run) {}

  Outcome read() {
    return run_.read_lines(
        [this](std::size_t n) {
          return log::is_any<log::Input, log::Observed, log::Utterance, log::AvatarGesture, log::Act>(run_.kind(n));
        },
        [this](std::size_t n, std::string_view line) {
          add(n, line);
          return true;
        });
  }

  std::vector<Episode> episodes() {
    Episodes all(at_once_, true);
    for (auto& [of, t, move, sample] : happenings_) {
      if (of == Happening::Of::human) all.begin({t, move.n, 0, "", sample, {}, {}, {}});
      if (of == Happening::Of::other) all.observed(std::move(move), t);
      if (of == Happening::Of::avatar) all.produced(std::move(move), t);
    }
    return all.take({});
  }

 private:
  void add(std::size_t n, std::string_view line) {
    const auto& kind = run_.kind(n);
    if (log::is<log::Input>(kind)) {
      const auto of = text_of_member(member_in(line, "event"), "kind");
      if (of == "act") return;  // the avatar's own
      add(Happening::Of::human, n, "", "");
      happenings_.back().sample = of == "pointing" || of == "gaze";
      input_ = happenings_.back().t;
    } else if (log::is<log::Observed>(kind)) {
      add(Happening::Of::other, n, text_of_member(line, "channel"), text_of_member(line, "content"));
      at_once_ = at_once_ && input_ == happenings_.back().t;
    } else if (log::is<log::Utterance>(kind)) {
      add(Happening::Of::avatar, n, "speech", text_of_member(line, "text"));
    } else if (log::is<log::AvatarGesture>(kind)) {
      add(Happening::Of::avatar, n, "gesture", text_of_member(line, "gesture"));
    } else if (member_in(line, "step").empty() && text_of_member(line, "status") == "asked") {
      add(Happening::Of::avatar, n, "action", text_of_member(line, "program"));
    }
  }
  void add(Happening::Of of, std::size_t n, std::string channel, std::string content) {
    happenings_.push_back({of, run_.entry(n).t, {std::move(channel), std::move(content), static_cast<int>(n)}, false});
  }

  const RunIndex& run_;
  std::vector<Happening> happenings_;
  SimTime input_;
  bool at_once_ = true;  // every observed move has the time of the input before it
};

}  // namespace

Result<Json> run_agreement(const RunIndex& run) {
  const auto& kinds = run.kinds();
  if (std::find(kinds.begin(), kinds.end(), log::Observed::kind.name) == kinds.end()) return Json();
  Reader reader(run);
  if (const auto problem = reader.read()) return *problem;
  Score score;
  std::vector<int> misses;
  for (const auto& episode : reader.episodes()) {
    score.add(episode);
    if (is_miss(episode)) misses.push_back((episode.observed.empty() ? episode.produced : episode.observed).front().n);
  }
  std::sort(misses.begin(), misses.end());
  return Json{{"answers", score.speaking}, {"alike", score.lax}, {"misses", misses}};
}

}  // namespace continua
