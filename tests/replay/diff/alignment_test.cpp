// The common parts of two sequences, and the fate of events.
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "continua/replay/diff/event_changes.h"
#include "continua/replay/diff/sequence_alignment.h"
#include "support/catch.h"

using namespace continua;

namespace {

using Numbers = std::vector<std::uint64_t>;

// The length of a longest common subsequence, from its definition.
std::size_t longest(const Numbers& a, const Numbers& b) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j)
      table[i][j] = a[i - 1] == b[j - 1] ? table[i - 1][j - 1] + 1 : std::max(table[i - 1][j], table[i][j - 1]);
  return table.back().back();
}

bool is_common(const Alignment& alignment, const Numbers& a, const Numbers& b) {
  std::size_t i = 0, j = 0;
  for (const auto& [at_a, at_b] : alignment.pairs) {
    if (at_a < i || at_b < j || at_a >= a.size() || at_b >= b.size() || a[at_a] != b[at_b]) return false;
    i = at_a + 1;
    j = at_b + 1;
  }
  return true;
}

Numbers counted_from(std::uint64_t first, std::size_t count) {
  Numbers numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

// "A1 B2.5": events by content and time; small letters are of another kind.
std::vector<EventSeen> events(const std::string& text) {
  std::vector<EventSeen> events;
  std::istringstream stream(text);
  for (std::string word; stream >> word;)
    events.push_back({static_cast<std::uint64_t>(word[0]), static_cast<std::uint64_t>(std::islower(word[0]) != 0),
                      SimTime::from_seconds(std::stod(word.substr(1)))});
  return events;
}

std::string changes(const std::string& a, const std::string& b) {
  const auto of_a = events(a), of_b = events(b);
  const auto name = [](const std::vector<EventSeen>& of, std::size_t at) {
    return fmt::format("{}{:g}", static_cast<char>(of[at].content), of[at].t.seconds());
  };
  std::string all;
  for (const auto& change : align_events(of_a, of_b).changes) {
    all += (all.empty() ? "" : ", ") + std::string(name_of(change.kind));
    if (change.a) all += " " + name(of_a, *change.a);
    if (change.b) all += " " + name(of_b, *change.b);
    if (change.other) all += " with " + name(of_a, change.other->first);
  }
  return all;
}

}  // namespace

TEST_CASE("of short sequences the alignment is a longest common subsequence") {
  const bool holds = rc::check([] {
    const auto some = rc::gen::container<Numbers>(rc::gen::inRange<std::uint64_t>(0, 4));
    const auto a = *some, b = *some;
    const auto alignment = align(a, b);
    RC_ASSERT(is_common(alignment, a, b));
    RC_ASSERT(alignment.pairs.size() == longest(a, b));
    RC_ASSERT(alignment.searched == std::pair(a.size(), b.size()));
  });
  CHECK(holds);
}

TEST_CASE("of long sequences scattered edits are found again, near and far") {
  auto a = counted_from(0, 20000);
  auto b = a;
  std::size_t common = a.size();
  for (std::size_t at = 100; at < 19000; at += 700) {
    b[at] = 1000000 + at;
    --common;
  }
  b.insert(b.begin() + 5000, 3, 77777777);
  b.erase(b.begin() + 12101, b.begin() + 12104);
  common -= 3;
  const auto added = counted_from(5000000, 4000);
  b.insert(b.begin() + 15001, added.begin(), added.end());
  const auto alignment = align(a, b);
  CHECK(is_common(alignment, a, b));
  CHECK(alignment.pairs.size() == common);
  CHECK(alignment.searched == std::pair(a.size(), b.size()));
}

TEST_CASE("sequences without anything in common are given up early") {
  const auto a = counted_from(0, 300000), b = counted_from(1000000, 300000);
  const auto alignment = align(a, b);
  CHECK(alignment.pairs.empty());
  CHECK(alignment.searched == std::pair<std::size_t, std::size_t>(0, 0));
}

TEST_CASE("what became of events") {
  struct Row {
    const char *a, *b, *changes;
  };
  for (const auto& [a, b, expected] : {
           Row{"A1 B2 C3", "A1 B2 C3", ""},
           Row{"A1 B2 C3", "A1 C3", "dropped B2"},
           Row{"A1 C3", "A1 B2 C3", "added B2"},
           Row{"A1 B2 C3", "A1 B2.2 C3", "moved B2 B2.2"},
           Row{"A1 B2 C3", "A1 C3 B3.5", "moved B2 B3.5"},
           Row{"A1 B2 C3", "A1 C2 B3", "swapped B2 B3 with C3"},
           Row{"A1 B2 C3", "A1 X2 C3", "changed B2 X2"},
           Row{"A1 b2 C3", "A1 X2 C3", "dropped b2, added X2"},
           Row{"Y1 Y2 Y3", "Y2 Y3", "dropped Y1"},
           Row{"Y1 Y2 Y3", "Y1 Y3", "dropped Y2"},
           Row{"A1 B2 C3", "A2 B3 C4", "moved A1 A2, moved B2 B3, moved C3 C4"},
           Row{"A1 B1 C3", "B1 A1 C3", "moved A1 A1"},
           Row{"", "A1", "added A1"},
           Row{"", "", ""},
       }) {
    INFO(a << " / " << b);
    CHECK(changes(a, b) == expected);
  }
}

TEST_CASE("every event is paired, dropped or added, whatever the events are") {
  const bool holds = rc::check([] {
    const auto some = rc::gen::map(rc::gen::container<std::vector<std::pair<std::uint64_t, int>>>(
                                       rc::gen::pair(rc::gen::inRange<std::uint64_t>(0, 4), rc::gen::inRange(0, 6))),
                                   [](std::vector<std::pair<std::uint64_t, int>> raw) {
                                     std::stable_sort(raw.begin(), raw.end(),
                                                      [](const auto& x, const auto& y) { return x.second < y.second; });
                                     std::vector<EventSeen> seen;
                                     for (const auto& [content, t] : raw)
                                       seen.push_back({content, content % 2, SimTime::from_seconds(t)});
                                     return seen;
                                   });
    const auto a = *some, b = *some;
    const auto aligned = align_events(a, b);
    std::vector<int> met_a(a.size()), met_b(b.size());
    for (const auto& [i, j] : aligned.pairs) {
      ++met_a.at(i);
      ++met_b.at(j);
      RC_ASSERT(a[i].modality == b[j].modality);
    }
    for (const auto& change : aligned.changes) {
      if (change.kind == EventChange::Kind::dropped) ++met_a.at(*change.a);
      if (change.kind == EventChange::Kind::added) ++met_b.at(*change.b);
    }
    RC_ASSERT(std::all_of(met_a.begin(), met_a.end(), [](int met) { return met == 1; }));
    RC_ASSERT(std::all_of(met_b.begin(), met_b.end(), [](int met) { return met == 1; }));
    RC_ASSERT(align_events(a, a).changes.empty());
  });
  CHECK(holds);
}
