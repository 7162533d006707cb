// Faults and reached things of a run, from its log.
#include <algorithm>
#include <cctype>
#include <set>

#include "continua/replay/experiment/log_lines.h"
#include "continua/replay/experiment/trace_search.h"

namespace continua {
namespace {

constexpr int refusals_in_a_row = 3;

std::string without_numbers(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isdigit(c) != 0; });
  return text;
}

// The program's name: "put" of "put(knife, in(cup))".
std::string head_of(const std::string& program) { return program.substr(0, program.find('(')); }

bool is_human(std::string_view record) {
  if (member_in(record, "line") == "null") return false;
  const auto kind = text_in(member_in(record, "event"), "kind");
  return kind == "speech" || kind == "gesture";
}

// Sees one record after the other.
class FaultFinder {
 public:
  void see(std::string_view record) {
    const auto kind = text_in(record, "kind");
    if (kind == "problem") add({"problem", without_numbers(text_in(record, "message"))});
    if (kind == "utterance") {
      has_words_ = true;
      refused_ = 0;
    }
    if (kind == "transition") refused_ = 0;
    if (kind == "refusal") see_refusal(record);
    if (kind == "input" && is_human(record)) close_move();
    if (kind == "act" && text_in(record, "status") == "asked" && member_in(record, "step").empty())
      acts_.push_back(head_of(text_in(record, "program")));
  }

  std::vector<Fault> take() {
    close_move();
    return std::move(faults_);
  }

 private:
  void see_refusal(std::string_view record) {
    const auto input = text_in(record, "input");
    if (!input.starts_with("speech") && !input.starts_with("gesture")) return;
    if (++refused_ == refusals_in_a_row) add({"refusals", text_in(record, "state")});
  }

  // All that came of the human's last move is there.
  void close_move() {
    for (const auto& act : acts_)
      if (!has_words_) add({"wordless", act});
    acts_.clear();
    has_words_ = false;
  }

  void add(Fault fault) {
    if (std::find(faults_.begin(), faults_.end(), fault) == faults_.end()) faults_.push_back(std::move(fault));
  }

  std::vector<Fault> faults_;
  std::vector<std::string> acts_;  // since the human's last move
  bool has_words_ = false;
  int refused_ = 0;  // in a row
};

}  // namespace

std::vector<Fault> faults_of(std::string_view log) {
  FaultFinder finder;
  each_line(log, [&](std::string_view record) { finder.see(record); });
  return finder.take();
}

std::vector<std::string> reached_in(std::string_view log) {
  std::set<std::string> reached;
  std::string before;
  each_line(log, [&](std::string_view record) {
    if (!record.starts_with("{\"kind\":\"transition\"")) return;
    auto id = text_in(record, "id");
    reached.insert(id);
    reached.insert(before + " > " + id);
    before = std::move(id);
  });
  return {reached.begin(), reached.end()};
}

}  // namespace continua
