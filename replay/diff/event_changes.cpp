#include "continua/replay/diff/event_changes.h"

#include <algorithm>
#include <map>

#include "continua/replay/diff/sequence_alignment.h"

namespace continua {
namespace {

using Pair = std::pair<std::size_t, std::size_t>;

constexpr std::size_t unpaired = static_cast<std::size_t>(-1);

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  return (a ^ (b + 0x9E3779B97F4A7C15ULL)) * 0xD6E8FEB86659FD93ULL;
}

class EventAligner {
 public:
  EventAligner(const std::vector<EventSeen>& a, const std::vector<EventSeen>& b)
      : a_(a), b_(b), of_a_(a.size(), unpaired), of_b_(b.size(), unpaired) {}

  EventAlignment align() {
    pair_in_order([](const EventSeen& event) { return mixed(event.content, static_cast<std::uint64_t>(event.t.us)); });
    pair_between([](const EventSeen& event) { return event.content; });
    pair_moved();
    pair_between([](const EventSeen& event) { return event.modality; });
    return told();
  }

 private:
  void pair(std::size_t a, std::size_t b) {
    of_a_[a] = b;
    of_b_[b] = a;
  }

  template <class Key>
  void pair_part(Pair from, Pair to, const Key& key) {
    std::vector<std::uint64_t> keys_a, keys_b;
    std::vector<std::size_t> places_a, places_b;
    for (auto i = from.first; i < to.first; ++i)
      if (of_a_[i] == unpaired) keys_a.push_back(key(a_[i])), places_a.push_back(i);
    for (auto j = from.second; j < to.second; ++j)
      if (of_b_[j] == unpaired) keys_b.push_back(key(b_[j])), places_b.push_back(j);
    if (keys_a.empty() || keys_b.empty()) return;
    for (const auto& [i, j] : continua::align(keys_a, keys_b).pairs) pair(places_a[i], places_b[j]);
  }

  template <class Key>
  void pair_in_order(const Key& key) {
    pair_part({0, 0}, {a_.size(), b_.size()}, key);
  }

  // Between the pairs there are, which stay. Pairs that cross others part nothing.
  template <class Key>
  void pair_between(const Key& key) {
    std::vector<Pair> anchors;
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (of_a_[i] != unpaired && (anchors.empty() || of_a_[i] > anchors.back().second))
        anchors.emplace_back(i, of_a_[i]);
    Pair from{0, 0};
    for (const auto& anchor : anchors) {
      pair_part(from, anchor, key);
      from = {anchor.first + 1, anchor.second + 1};
    }
    pair_part(from, {a_.size(), b_.size()}, key);
  }

  // The remaining events of equal content have changed their places among the others: paired in order of time, by
  // content.
  void pair_moved() {
    std::map<std::uint64_t, std::vector<std::size_t>> left;
    for (std::size_t j = b_.size(); j-- > 0;)
      if (of_b_[j] == unpaired) left[b_[j].content].push_back(j);
    for (std::size_t i = 0; i < a_.size(); ++i) {
      if (of_a_[i] != unpaired) continue;
      const auto found = left.find(a_[i].content);
      if (found == left.end() || found->second.empty()) continue;
      pair(i, found->second.back());
      found->second.pop_back();
    }
  }

  // Whether each of two events stands, as far as time tells, where the other one stood.
  bool swapped(std::size_t first, std::size_t second) const {
    const auto b_first = of_a_[first], b_second = of_a_[second];
    if (b_first == unpaired || b_second == unpaired || b_first < b_second) return false;
    return a_[first].content == b_[b_first].content && a_[second].content == b_[b_second].content &&
           a_[first].t == b_[b_second].t && a_[second].t == b_[b_first].t && a_[first].t != a_[second].t;
  }

  EventAlignment told() {
    EventAlignment all;
    std::vector<bool> is_told(a_.size(), false);
    std::map<std::int64_t, std::vector<std::size_t>> by_time;  // of moved events of a
    for (std::size_t i = 0; i < a_.size(); ++i)
      if (of_a_[i] != unpaired && a_[i].t != b_[of_a_[i]].t) by_time[a_[i].t.us].push_back(i);
    for (std::size_t i = 0; i < a_.size(); ++i) {
      const auto j = of_a_[i];
      if (j == unpaired) {
        all.changes.push_back({EventChange::Kind::dropped, i, std::nullopt});
        continue;
      }
      all.pairs.emplace_back(i, j);
      const bool same = a_[i].content == b_[j].content;
      all.same += same;
      if (is_told[i]) continue;
      if (!same) {
        all.changes.push_back({EventChange::Kind::changed, i, j});
      } else if (a_[i].t != b_[j].t) {
        const auto candidates = by_time.find(b_[j].t.us);
        const auto other = candidates == by_time.end()
                               ? std::vector<std::size_t>::const_iterator()
                               : std::find_if(candidates->second.cbegin(), candidates->second.cend(),
                                              [&](std::size_t k) { return k > i && !is_told[k] && swapped(i, k); });
        if (candidates != by_time.end() && other != candidates->second.cend()) {
          is_told[*other] = true;
          all.changes.push_back({EventChange::Kind::swapped, i, j, Pair(*other, of_a_[*other])});
        } else {
          all.changes.push_back({EventChange::Kind::moved, i, j});
        }
      } else if (crosses(i)) {
        all.changes.push_back({EventChange::Kind::moved, i, j});
      }
    }
    for (std::size_t j = 0; j < b_.size(); ++j)
      if (of_b_[j] == unpaired) all.changes.push_back({EventChange::Kind::added, std::nullopt, j});
    std::stable_sort(all.changes.begin(), all.changes.end(),
                     [&](const EventChange& x, const EventChange& y) { return time_of(x) < time_of(y); });
    return all;
  }

  // Of one instant, but in another order than its neighbour.
  bool crosses(std::size_t i) const {
    return i + 1 < a_.size() && of_a_[i + 1] != unpaired && of_a_[i + 1] < of_a_[i] && a_[i + 1].t == a_[i].t;
  }

  SimTime time_of(const EventChange& change) const {
    if (!change.a) return b_[*change.b].t;
    return change.b ? std::min(a_[*change.a].t, b_[*change.b].t) : a_[*change.a].t;
  }

  const std::vector<EventSeen>&a_, &b_;
  std::vector<std::size_t> of_a_, of_b_;  // each one's counterpart
};

}  // namespace

const char* name_of(EventChange::Kind kind) {
  switch (kind) {
    case EventChange::Kind::dropped:
      return "dropped";
    case EventChange::Kind::added:
      return "added";
    case EventChange::Kind::moved:
      return "moved";
    case EventChange::Kind::changed:
      return "changed";
    case EventChange::Kind::swapped:
      return "swapped";
  }
  return "";
}

EventAlignment align_events(const std::vector<EventSeen>& a, const std::vector<EventSeen>& b) {
  return EventAligner(a, b).align();
}

}  // namespace continua
