#include "continua/replay/explain/run_account.h"

#include <algorithm>
#include <map>
#include <unordered_set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/counted.h"
#include "continua/replay/explain/explain_lines.h"
#include "continua/replay/log/act_outcome.h"
#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_text.h"
#include "continua/replay/log/run_words.h"

namespace continua {
namespace {

constexpr double minute_s = 60;
constexpr std::size_t most_of_a_minute = 8;  // moves of one side that a minute's line names
constexpr std::size_t most_failures = 3;     // that the sentences tell

std::string clock(double t) {
  const auto whole = static_cast<long>(t + 0.0005);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}
std::string text_of_member(std::string_view line, std::string_view key) { return text_in(member_in(line, key)); }

struct Move {
  enum class Who { human, avatar } who = Who::human;
  std::size_t n = 0;
  double t = 0;
  std::string text;
  bool question = false, sentence = false, taken = true;
};

struct Deed {
  std::size_t n = 0;  // where it was asked for
  double t = 0, until = 0;
  std::string program, status, reason;
};

// The happenings of a run that people would tell.
class Happenings {
 public:
  explicit Happenings(const RunIndex& run) : run_(run), words_(run) {}

  Outcome read() {
    return run_.read_lines(
        [this](std::size_t n) {
          const auto& kind = run_.kind(n);
          return (log::is<log::Input>(kind) && !run_.entry(n).sample) || log::is<log::Utterance>(kind) ||
                 log::is<log::Act>(kind) || log::is<log::Expect>(kind) ||
                 (log::is<log::Refusal>(kind) && !run_.entry(n).by_sample);
        },
        [this](std::size_t n, std::string_view line) {
          const auto& kind = run_.kind(n);
          if (log::is<log::Input>(kind)) input(n, member_in(line, "event"));
          if (log::is<log::Utterance>(kind)) utterance(n, text_of_member(line, "text"));
          if (log::is<log::Act>(kind)) act(n, line);
          if (log::is<log::Refusal>(kind)) refuse(n);
          if (log::is<log::Expect>(kind)) ++(member_in(line, "met") == "false" ? unmet_ : met_);
          return true;
        });
  }

  Json account() const { return {{"sentences", sentences()}, {"acts", acts()}, {"minutes", minutes()}}; }

 private:
  double t_of(std::size_t n) const { return run_.entry(n).t.seconds(); }

  void input(std::size_t n, std::string_view event) {
    const auto kind = text_of_member(event, "kind");
    const bool speech = kind == "speech";
    if (!speech && (kind != "gesture" || text_of_member(event, "phase") == "stop")) return;
    if (speech && member_in(event, "final") == "false") return;
    const auto text = speech ? "“" + text_of_member(event, "text") + "”"
                             : words_.gesture(text_of_member(event, "name"), text_of_member(event, "direction"));
    place_[n] = moves_.size();
    moves_.push_back({Move::Who::human, n, t_of(n), text, false, speech});
  }
  void utterance(std::size_t n, const std::string& text) {
    moves_.push_back({Move::Who::avatar, n, t_of(n), "“" + text + "”", text.ends_with('?'), true});
  }
  void refuse(std::size_t n) {
    const auto cause = run_.cause(n);
    const auto of = cause ? place_.find(*cause) : place_.end();
    if (of != place_.end()) moves_[of->second].taken = false;
  }
  void act(std::size_t n, std::string_view line) {
    if (!member_in(line, "step").empty()) return;
    const auto status = text_of_member(line, "status");
    const auto [known, is_new] = deed_of_.try_emplace(text_of_member(line, "act"), deeds_.size());
    if (is_new) deeds_.push_back({n, t_of(n), t_of(n), words_.term(text_of_member(line, "program")), "", ""});
    auto& deed = deeds_[known->second];
    deed.until = t_of(n);
    deed.status = status;
    deed.reason = words_.reason_of_act(line);
  }

  // The moves on the way to an act: after the act before was asked for, until it was.
  struct Way {
    std::size_t moves = 0, questions = 0, refused = 0;
    double from = 0, to = 0;
  };
  Way way_to(std::size_t deed) const {
    const auto after = deed == 0 ? 0 : deeds_[deed - 1].n;
    Way way{0, 0, 0, deeds_[deed].t, deeds_[deed].t};
    const auto first =
        std::partition_point(moves_.begin(), moves_.end(), [&](const Move& one) { return one.n <= after; });
    for (auto at = first; at != moves_.end() && at->n < deeds_[deed].n; ++at) {
      const auto& move = *at;
      if (move.who == Move::Who::human) {
        if (way.moves++ == 0) way.from = move.t;
        way.refused += move.taken ? 0 : 1;
      } else if (move.question) {
        ++way.questions;
      }
    }
    return way;
  }
  static std::string told(const Way& way) {
    std::vector<std::string> parts{counted(way.moves, "move") + " of the human"};
    if (way.questions) parts.push_back(counted(way.questions, "question"));
    if (way.refused) parts.push_back(fmt::format("{} not understood", way.refused));
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  Json sentences() const {
    Json all = Json::array();
    const auto end = t_of(run_.size() - 1);
    std::size_t said = 0, questions = 0, words = 0, gestures = 0, refused = 0;
    for (const auto& move : moves_) {
      if (move.who == Move::Who::avatar) ++said, questions += move.question ? 1 : 0;
      if (move.who == Move::Who::human) ++(move.sentence ? words : gestures), refused += move.taken ? 0 : 1;
    }
    all.push_back({{"text", fmt::format("In {} the human said {} and made {}, {} of which were not understood; the "
                                        "avatar said {}, {} of them questions.",
                                        clock(end), counted(words, "sentence"), counted(gestures, "gesture"), refused,
                                        counted(said, "sentence"), questions)},
                   {"n", moves_.empty() ? 0 : moves_.front().n}});
    add_acts(all);
    if (unmet_)
      all.push_back(
          {{"text", fmt::format("{} of {} not met.", unmet_, counted(unmet_ + met_, "expectation"))}, {"n", 0}});
    return all;
  }
  void add_acts(Json& all) const {
    if (deeds_.empty()) return;
    std::map<std::string, std::size_t> outcomes;
    for (const auto& deed : deeds_) ++outcomes[log::has_failed(deed.status) ? "failed" : deed.status];
    std::vector<std::string> told_outcomes;
    for (const auto& [outcome, count] : outcomes)
      told_outcomes.push_back(fmt::format("{} {}", count, outcome == "stopped" ? "given up" : outcome));
    all.push_back({{"text", fmt::format("{}: {}.", counted(deeds_.size(), "act"), fmt::join(told_outcomes, ", "))},
                   {"n", deeds_.front().n}});
    std::size_t failures = 0;
    for (const auto& deed : deeds_)
      if (log::has_failed(deed.status) && failures++ < most_failures)
        all.push_back({{"text", fmt::format("At {} one failed (the avatar {}): {}.", clock(deed.until), deed.program,
                                            deed.reason.empty() ? deed.status : deed.reason)},
                       {"n", deed.n}});
    std::size_t longest = 0;
    Way way = way_to(0);
    for (std::size_t i = 1; i < deeds_.size(); ++i)
      if (const auto other = way_to(i); other.to - other.from > way.to - way.from) longest = i, way = other;
    if (deeds_.size() > 1 && way.moves > 0)
      all.push_back({{"text", fmt::format("The longest way to an act took {}, from {} to {}: {}; then the avatar {}.",
                                          clock(way.to - way.from), clock(way.from), clock(way.to), told(way),
                                          deeds_[longest].program)},
                     {"n", deeds_[longest].n}});
  }

  Json acts() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < deeds_.size(); ++i) {
      const auto& deed = deeds_[i];
      const bool failed = log::has_failed(deed.status);
      const auto how = failed                     ? fmt::format(": {}", deed.reason.empty() ? deed.status : deed.reason)
                       : deed.status == "stopped" ? ", given up"
                       : deed.status == "done"    ? ""
                                                  : ", not ended";
      const auto way = way_to(i);
      const auto after = way.moves ? fmt::format("; after {}", told(way)) : std::string();
      all.push_back({{"text", fmt::format("{} the avatar {}{}{}", clock(deed.t), deed.program, how, after)},
                     {"n", deed.n},
                     {"t", deed.t},
                     {"failed", failed}});
    }
    return all;
  }

  // "points, yes, “Put it there.” and 3 more"; the same move again and again is told once.
  static std::string listed(const std::vector<std::string>& told) {
    std::vector<std::string> parts;
    for (const auto& one : told)
      if (parts.empty() || parts.back() != one) parts.push_back(one);
    if (parts.size() <= most_of_a_minute) return fmt::format("{}", fmt::join(parts, ", "));
    const auto more = parts.size() - most_of_a_minute;
    parts.resize(most_of_a_minute);
    return fmt::format("{} and {} more", fmt::join(parts, ", "), more);
  }
  Json minutes() const {
    Json all = Json::array();
    const auto end = t_of(run_.size() - 1);
    for (double from = 0; from <= end && end > minute_s; from += minute_s) {
      const auto before = [](double t) { return [t](const auto& one) { return one.t < t; }; };
      const auto part = [&](const auto& all_of) {
        return std::pair(std::partition_point(all_of.begin(), all_of.end(), before(from)),
                         std::partition_point(all_of.begin(), all_of.end(), before(from + minute_s)));
      };
      std::vector<std::string> shown, said, done;
      std::size_t refused = 0, first = run_.size();
      const auto [moves_from, moves_to] = part(moves_);
      for (auto move = moves_from; move != moves_to; ++move) {
        first = std::min(first, move->n);
        (move->who == Move::Who::avatar ? said : shown).push_back(move->text);
        refused += move->taken ? 0 : 1;
      }
      const auto [deeds_from, deeds_to] = part(deeds_);
      for (auto deed = deeds_from; deed != deeds_to; ++deed) {
        first = std::min(first, deed->n);
        done.push_back(deed->program + (log::has_failed(deed->status) ? ", which failed" : ""));
      }
      if (first == run_.size()) continue;
      std::vector<std::string> parts;
      if (!shown.empty())
        parts.push_back("human: " + listed(shown) + (refused ? fmt::format(" ({} not understood)", refused) : ""));
      if (!said.empty()) parts.push_back("avatar: " + listed(said));
      for (const auto& one : done) parts.push_back("the avatar " + one);
      all.push_back({{"text", fmt::format("{}. ", fmt::join(parts, ". "))},
                     {"n", first},
                     {"from", from},
                     {"to", std::min(end, from + minute_s)}});
      auto& text = all.back()["text"].get_ref<std::string&>();
      text.pop_back();
    }
    return all;
  }

  const RunIndex& run_;
  const RunWords words_;
  std::vector<Move> moves_;
  std::map<std::size_t, std::size_t> place_;  // of a human's move by its record
  std::vector<Deed> deeds_;
  std::map<std::string, std::size_t> deed_of_;
  std::size_t met_ = 0, unmet_ = 0;
};

}  // namespace

Result<Json> run_account(const RunIndex& run) {
  Happenings happenings(run);
  if (const auto problem = happenings.read()) return *problem;
  return happenings.account();
}

std::string account_text(const Json& account, std::size_t width) {
  std::string text, first;
  for (const auto& one : account.at("sentences"))
    first += (first.empty() ? "" : " ") + one.at("text").get<std::string>();
  text += wrapped(first, "", "", width);
  const auto list = [&](const char* heading, const char* of, const auto& line_of) {
    if (account.at(of).empty()) return;
    text += fmt::format("\n{}\n", heading);
    for (const auto& one : account.at(of)) text += wrapped(line_of(one), "  ", "    ", width);
  };
  const auto numbered = [](const Json& one) {
    return fmt::format("{}  #{}", one.at("text").get<std::string>(), one.at("n").get<std::size_t>());
  };
  list("The acts", "acts", numbered);
  list("Minute by minute", "minutes", [&](const Json& one) {
    return fmt::format("{} – {}  {}", clock(one.at("from")), clock(one.at("to")), numbered(one));
  });
  return text;
}

}  // namespace continua
