#include "continua/replay/annotation/tier_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "continua/core/digest.h"
#include "continua/replay/annotation/event_tiers.h"
#include "continua/replay/annotation/label_reading.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/trace/event_shift.h"
#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_header.h"

namespace continua {
namespace {

// Words that no longer pause parts are one utterance, where no other tier tells the utterances.
constexpr double longest_pause_s = 0.5;

double seconds(std::int64_t ms) { return static_cast<double>(ms) / 1000; }

// An event and where it stood in the trace that was exported.
struct Made {
  Json event;
  std::size_t line = std::numeric_limits<std::size_t>::max();
  std::size_t source = 0;  // line of the annotations' file
  double t() const { return event["t"].get<double>(); }
};

class TierImport {
 public:
  TierImport(const Annotations& annotations, const TierMap& map) : annotations_(annotations), map_(map) {
    trace_.name = annotations.name;
  }

  Result<Trace> trace() {
    if (auto problem = read_header()) return *problem;
    for (const auto& [name, use] : map_.tiers)
      if (auto problem = add_tier(name, use)) return *problem;
    for (const auto& [name, use] : map_.tiers)
      if (use.kind == "words") add_words(*tier_named(name));
    finish();
    if (trace_.events.empty())
      return Error{trace_.name, trace_.notes.empty()
                                    ? "no annotation of a tier in the map; expected one that becomes an event"
                                    : "no annotation can be used; the first: " + trace_.notes.front().sentence};
    trace_.digest = digest(write_trace(trace_));
    return std::move(trace_);
  }

 private:
  Outcome read_header() {
    Json header = {{"kind", "trace"}, {"version", 1}};
    if (!annotations_.header.empty()) {
      const auto own = LocatedJson::parse(annotations_.header, trace_.name + ": continua.trace");
      if (!own) return own.error();
      header = own->root();
    } else {
      header["source"] = std::filesystem::path(trace_.name).filename().string();
      for (const auto& [file, offset_s] : annotations_.media) {
        Json media = {{"file", file}};
        if (offset_s != 0) media["offset"] = offset_s;
        header["media"].push_back(media);
      }
    }
    if (header.is_object())
      for (const auto& [name, value] : map_.header.items()) header[name] = value;
    std::vector<Error> problems;
    const auto line = compact(header);
    const auto read = header_from_line(std::string_view(line), trace_.name + ": the trace's header", 1, problems);
    if (!problems.empty()) return problems.front();
    trace_.header = *read;
    return std::nullopt;
  }

  const Tier* tier_named(const std::string& name) const {
    const auto found = std::find_if(annotations_.tiers.begin(), annotations_.tiers.end(),
                                    [&](const Tier& tier) { return tier.name == name; });
    return found == annotations_.tiers.end() ? nullptr : &*found;
  }

  Outcome add_tier(const std::string& name, const TierUse& use) {
    const auto* tier = tier_named(name);
    if (!tier) {
      std::vector<std::string> names;
      for (const auto& each : annotations_.tiers) names.push_back(each.name);
      return Error{trace_.name, fmt::format("there is no tier {}{}; expected one of the map's names", in_quotes(name),
                                            did_you_mean(name, names))};
    }
    if (use.kind.empty() || use.kind == "words") return std::nullopt;
    for (const auto& annotation : tier->annotations)
      if (!add_exported(annotation, use) && use.kind != "event") add_by_hand(*tier, annotation, use);
    return std::nullopt;
  }

  // Whether the annotation still tells of the event that it was exported from.
  bool add_exported(const Annotation& annotation, const TierUse& use) {
    const auto &event = member_of(annotation.event, "event"), &at = member_of(annotation.event, "at");
    const auto& line = member_of(annotation.event, "line");
    const bool whole = event.is_object() && member_of(event, "t").is_number() && at.is_array() && at.size() == 2 &&
                       at[0].is_number_integer() && at[1].is_number_integer() && line.is_number_unsigned();
    if (!whole) return false;
    const bool used_so = text_of(event, "kind") == use.kind && text_of(event, "channel") == use.channel;
    if (use.kind != "event" && (!used_so || label_of_event(event) != label_of(annotation.value))) return false;
    const auto begin = annotation.begin_ms - at[0].get<std::int64_t>(),
               end = annotation.end_ms - at[1].get<std::int64_t>();
    Json moved = begin == 0 ? event : shifted_event(event, {begin * 1000});
    if (begin != end && (event.contains("until") || use.kind == "speech")) moved["until"] = seconds(annotation.end_ms);
    made_.push_back({std::move(moved), line.get<std::size_t>(), annotation.n});
    return true;
  }

  void add_by_hand(const Tier& tier, const Annotation& annotation, const TierUse& use) {
    const auto replaced = use.values.find(annotation.value);
    const auto label = replaced == use.values.end() ? annotation.value : replaced->get<std::string>();
    auto members = read_label(label, use);
    if (!members)
      return note(annotation.n, fmt::format("left out of {}: {}", in_quotes(tier.name), members.error().sentence));
    Json event = {{"t", seconds(annotation.begin_ms)}, {"kind", use.kind}};
    if (annotation.n > 0) event["row"] = annotation.n;
    for (const auto& source : {members.value(), use.set})
      for (const auto& [name, value] : source.items()) event[name] = value;
    const bool lasts = annotation.end_ms > annotation.begin_ms;
    if (use.kind == "gesture" && use.phases && lasts) {
      event["phase"] = "start";
      made_.push_back({event, Made{}.line, annotation.n});
      event["phase"] = "stop";
      event["t"] = seconds(annotation.end_ms);
    } else if (lasts && use.kind != "observed" && use.kind != "mark" && use.kind != "expect") {
      event["until"] = seconds(annotation.end_ms);
    }
    made_.push_back({std::move(event), Made{}.line, annotation.n});
  }

  // Words belong to the speech in whose time they begin; else they make utterances.
  void add_words(const Tier& tier) {
    std::optional<std::size_t> own;
    for (const auto& word : tier.annotations) {
      if (word.value.empty()) continue;
      const double begin = seconds(word.begin_ms), end = seconds(word.end_ms);
      const Json entry = {{"text", word.value}, {"t", begin}};
      const auto holds = [&](const Made& each) {
        return each.event["kind"] == "speech" && each.t() <= begin && begin < each.event.value("until", each.t());
      };
      const auto of = std::find_if(made_.begin(), made_.end(), holds);
      if (of != made_.end() && !(own && of == made_.begin() + static_cast<std::ptrdiff_t>(*own))) {
        of->event["words"].push_back(entry);
        continue;
      }
      if (!own || begin - made_[*own].event["until"].get<double>() > longest_pause_s) {
        own = made_.size();
        made_.push_back({{{"t", begin}, {"kind", "speech"}, {"text", ""}}, Made{}.line, word.n});
        if (word.n > 0) made_.back().event["row"] = word.n;
      }
      auto& event = made_[*own].event;
      const auto before = event["text"].get<std::string>();
      event["text"] = before + (before.empty() ? "" : " ") + word.value;
      event["until"] = end;
      event["words"].push_back(entry);
    }
  }

  // Events in the order of time; of one time in that of the exported trace, then as the tiers are listed.
  void finish() {
    std::stable_sort(made_.begin(), made_.end(), [](const Made& a, const Made& b) {
      const bool a_ends = a.event["kind"] == "end", b_ends = b.event["kind"] == "end";
      if (a_ends != b_ends) return b_ends;
      return a.t() != b.t() ? a.t() < b.t() : a.line < b.line;
    });
    double reached = 0;
    for (auto& each : made_) {
      if (each.event["kind"] == "end") each.event["t"] = std::max(each.t(), reached);
      std::vector<Error> problems;
      auto event = event_from_json(each.event, trace_.name, trace_.events.size() + 2, problems, trace_.notes);
      if (!problems.empty()) {
        note(each.source, "left out: " + problems.front().sentence);
        continue;
      }
      reached = std::max(reached, each.t());
      trace_.events.push_back(std::move(event));
    }
  }

  void note(std::size_t line, std::string sentence) { trace_.notes.push_back({line, std::move(sentence)}); }

  const Annotations& annotations_;
  const TierMap& map_;
  Trace trace_;
  std::vector<Made> made_;
};

}  // namespace

Result<Trace> trace_of_annotations(const Annotations& annotations, const TierMap& map) {
  return TierImport(annotations, map).trace();
}

}  // namespace continua
