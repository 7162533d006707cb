#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <deque>
#include <map>
#include <pugixml.hpp>

#include "continua/replay/annotation/eaf.h"

namespace continua {
namespace {

std::string text_in(const pugi::xml_node& element) {
  std::string text;
  for (const auto part : element.children())
    if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) text += part.value();
  return text;
}

std::optional<std::int64_t> whole_number(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  return problem == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(number)
                                                                                     : std::nullopt;
}

// The path of an address; "%20" is a blank.
std::string path_of(std::string_view address) {
  for (const std::string_view before : {"file://", "./"})
    if (address.starts_with(before)) address.remove_prefix(before.size());
  std::string path;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned byte = 0;
    const auto* digits = address.data() + i + 1;
    if (address[i] == '%' && i + 2 < address.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2)
      path += static_cast<char>(byte), i += 2;
    else
      path += address[i];
  }
  return path;
}

class EafReader {
 public:
  EafReader(std::string_view text, const std::string& name) : text_(text) { found_.name = name; }

  Result<Annotations> read() {
    for (const auto part : {&EafReader::parse, &EafReader::read_header, &EafReader::read_times, &EafReader::read_tiers,
                            &EafReader::resolve})
      if (auto problem = (this->*part)()) return *problem;
    join_events();
    return std::move(found_);
  }

 private:
  // An annotation that has the time of another one, and which of how many it is there.
  struct Reference {
    std::size_t tier = 0, annotation = 0, place = 0;
    std::string id;
  };
  struct Span {
    std::int64_t begin_ms = 0, end_ms = 0;
    std::size_t tier = 0, annotation = 0;
  };

  Outcome parse() {
    const auto parsed = document_.load_buffer(text_.data(), text_.size());
    // Offsets are those of the text in UTF-8.
    lines_known_ = parsed.encoding == pugi::encoding_utf8;
    if (lines_known_)
      for (std::size_t at = 0; (at = text_.find('\n', at)) != std::string_view::npos; ++at)
        ends_.push_back(static_cast<std::ptrdiff_t>(at));
    if (!parsed)
      return error(parsed.offset, fmt::format("not valid XML: {}; expected ELAN's annotations", parsed.description()));
    root_ = document_.document_element();
    if (std::string_view(root_.name()) != "ANNOTATION_DOCUMENT")
      return error(root_.offset_debug(),
                   fmt::format("found <{}>; expected <ANNOTATION_DOCUMENT>, the root of ELAN's files", root_.name()));
    return std::nullopt;
  }

  Outcome read_header() {
    const auto header = root_.child("HEADER");
    if (const std::string units = header.attribute("TIME_UNITS").as_string("milliseconds"); units != "milliseconds")
      return error(header.offset_debug(), fmt::format("found times in {}; expected milliseconds", in_quotes(units)));
    for (const auto media : header.children("MEDIA_DESCRIPTOR")) {
      const auto relative = media.attribute("RELATIVE_MEDIA_URL");
      const auto address = relative ? relative : media.attribute("MEDIA_URL");
      found_.media.push_back({path_of(address.value()), media.attribute("TIME_ORIGIN").as_double() / 1000});
    }
    for (const auto property : header.children("PROPERTY"))
      if (std::string_view(property.attribute("NAME").value()) == "continua.trace") found_.header = text_in(property);
    return std::nullopt;
  }

  Outcome read_times() {
    std::vector<std::pair<std::string, std::optional<std::int64_t>>> slots;
    for (const auto slot : root_.child("TIME_ORDER").children("TIME_SLOT")) {
      const auto value = slot.attribute("TIME_VALUE");
      const auto time = whole_number(value.value());
      if (value && !time)
        return error(slot.offset_debug(),
                     fmt::format("found the time {}; expected whole milliseconds", in_quotes(value.value())));
      slots.emplace_back(slot.attribute("TIME_SLOT_ID").value(), time);
    }
    // Slots without a time lie evenly between those that have one.
    for (std::size_t i = 0; i < slots.size(); ++i) {
      if (slots[i].second) continue;
      std::size_t next = i;
      while (next < slots.size() && !slots[next].second) ++next;
      const auto before = i > 0 ? *slots[i - 1].second : 0;
      const auto after = next < slots.size() ? *slots[next].second : before;
      slots[i].second = before + (after - before) / static_cast<std::int64_t>(next - i + 1);
    }
    for (const auto& [id, time] : slots) times_.emplace(id, *time);
    return std::nullopt;
  }

  Outcome read_tiers() {
    for (const auto element : root_.children("TIER")) {
      found_.tiers.push_back({element.attribute("TIER_ID").value(), element.attribute("PARTICIPANT").value(), {}});
      for (const auto annotation : element.children("ANNOTATION"))
        for (const auto one : annotation.children())
          if (auto problem = read_annotation(one)) return problem;
    }
    return std::nullopt;
  }

  Outcome read_annotation(const pugi::xml_node& element) {
    auto& annotations = found_.tiers.back().annotations;
    const std::size_t tier = found_.tiers.size() - 1, place = annotations.size();
    annotations.push_back({line(element.offset_debug()), 0, 0, text_in(element.child("ANNOTATION_VALUE"))});
    const std::string id = element.attribute("ANNOTATION_ID").value();
    if (std::string_view(element.name()) == "REF_ANNOTATION") {
      auto& siblings = references_[element.attribute("ANNOTATION_REF").value()];
      siblings.push_back({tier, place, siblings.size(), id});
      return std::nullopt;
    }
    Span span{0, 0, tier, place};
    for (const auto& [name, time] : {std::pair("TIME_SLOT_REF1", &span.begin_ms), {"TIME_SLOT_REF2", &span.end_ms}}) {
      const auto found = times_.find(element.attribute(name).value());
      if (found == times_.end())
        return error(element.offset_debug(), fmt::format("found {} {}; expected the id of a time slot", name,
                                                         in_quotes(element.attribute(name).value())));
      *time = found->second;
    }
    if (span.end_ms < span.begin_ms)
      return error(element.offset_debug(), "found an annotation that ends before it begins");
    aligned_.emplace_back(id, span);
    return std::nullopt;
  }

  // Hands the times of annotations on to those that refer to them. Several of one tier share the time.
  Outcome resolve() {
    std::deque<std::pair<std::string, Span>> known(aligned_.begin(), aligned_.end());
    for (; !known.empty(); known.pop_front()) {
      const auto& id = known.front().first;
      const Span& span = known.front().second;
      auto& annotation = found_.tiers[span.tier].annotations[span.annotation];
      annotation.begin_ms = span.begin_ms, annotation.end_ms = span.end_ms;
      found_.end_ms = std::max(found_.end_ms, span.end_ms);
      const auto found = references_.find(id);
      if (found == references_.end()) continue;
      std::map<std::size_t, std::int64_t> count, next;
      for (const auto& one : found->second) ++count[one.tier];
      for (const auto& one : found->second) {
        const auto share = [&](std::int64_t i) {
          return span.begin_ms + (span.end_ms - span.begin_ms) * i / count[one.tier];
        };
        const auto i = next[one.tier]++;
        known.emplace_back(one.id, Span{share(i), share(i + 1), one.tier, one.annotation});
        if (count[one.tier] == 1) parents_[{one.tier, one.annotation}] = {span.tier, span.annotation};
      }
      references_.erase(found);
    }
    if (references_.empty()) return std::nullopt;
    const auto& lost = references_.begin()->second.front();
    return Error{fmt::format("{}:{}", found_.name, found_.tiers[lost.tier].annotations[lost.annotation].n),
                 fmt::format("found ANNOTATION_REF {}; expected the id of an annotation that has a time",
                             in_quotes(references_.begin()->first))};
  }

  // Our own tiers of events go into the annotations that they are of.
  void join_events() {
    const auto is_event = [](const Tier& tier) { return tier.name.ends_with(events_ending); };
    for (std::size_t tier = 0; tier < found_.tiers.size(); ++tier) {
      if (!is_event(found_.tiers[tier])) continue;
      for (std::size_t i = 0; i < found_.tiers[tier].annotations.size(); ++i) {
        const auto parent = parents_.find({tier, i});
        const auto event = LocatedJson::parse(found_.tiers[tier].annotations[i].value, found_.name);
        if (parent != parents_.end() && event && event->root().is_object())
          found_.tiers[parent->second.first].annotations[parent->second.second].event = event->root();
      }
    }
    std::erase_if(found_.tiers, is_event);
  }

  std::size_t line(std::ptrdiff_t offset) const {
    if (offset < 0 || !lines_known_) return 0;
    return 1 + static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), offset) - ends_.begin());
  }

  Error error(std::ptrdiff_t offset, std::string sentence) const {
    const auto at = line(offset);
    return {at > 0 ? fmt::format("{}:{}", found_.name, at) : found_.name, std::move(sentence)};
  }

  std::string_view text_;
  bool lines_known_ = false;
  std::vector<std::ptrdiff_t> ends_;  // of lines
  pugi::xml_document document_;
  pugi::xml_node root_;
  Annotations found_;
  std::map<std::string, std::int64_t, std::less<>> times_;
  std::vector<std::pair<std::string, Span>> aligned_;
  std::map<std::string, std::vector<Reference>> references_;
  std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> parents_;
};

}  // namespace

Result<Annotations> read_eaf(std::string_view text, const std::string& name) { return EafReader(text, name).read(); }

}  // namespace continua
