// EMMA 1.0, W3C's notation for what recognisers of any kind have understood.
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "continua/replay/recogniser/json_reader.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/trace/session_notation.h"

namespace continua {
namespace {

// Names count without their prefix, which every file chooses for itself.
std::string_view local(std::string_view name) { return name.substr(name.rfind(':') + 1); }

std::string attribute_of(const pugi::xml_node& element, std::string_view name) {
  for (const auto attribute : element.attributes())
    if (local(attribute.name()) == name) return attribute.value();
  return {};
}

// The value of an interpretation, or of the list that it is in.
std::string inherited(pugi::xml_node element, std::string_view name) {
  for (; element; element = element.parent())
    if (auto value = attribute_of(element, name); !value.empty()) return value;
  return {};
}

std::string text_within(const pugi::xml_node& element) {
  std::string text;
  for (const auto part : element.children()) {
    if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) text += std::string(part.value()) + " ";
    if (part.type() == pugi::node_element && local(part.name()) == "literal") text += text_within(part) + " ";
  }
  return trimmed_words(text);
}

// One document.
class EmmaDocument {
 public:
  EmmaDocument(const OutputPart& part, const std::string& name) : text_(part.text), first_(part.line), name_(name) {}

  Outcome read(std::vector<Json>& events) {
    const auto parsed = document_.load_buffer(text_.data(), text_.size());
    if (!parsed)
      return lacks(name_, line(parsed.offset),
                   fmt::format("EMMA in XML; found that it is no XML: {}", parsed.description()));
    const auto root = document_.document_element();
    if (local(root.name()) != "emma")
      return lacks(name_, line(root.offset_debug()), "<emma:emma>, the root of an EMMA document");
    walk(root, events);
    return std::nullopt;
  }

 private:
  static void walk(const pugi::xml_node& element, std::vector<Json>& events) {
    for (const auto part : element.children()) {
      const auto name = local(part.name());
      if (name == "one-of") {
        std::vector<pugi::xml_node> all;
        collect(part, all);
        add(all, events);
      } else if (name == "interpretation") {
        add({part}, events);
      } else if (name == "group" || name == "sequence") {
        walk(part, events);
      }
    }
  }

  // An n-best list is one event; lists in lists, such as of several readings of one sound, are one list.
  static void collect(const pugi::xml_node& list, std::vector<pugi::xml_node>& all) {
    for (const auto part : list.children())
      if (local(part.name()) == "interpretation")
        all.push_back(part);
      else if (local(part.name()) == "one-of" && all.size() < 100)
        collect(part, all);
  }

  static void add(const std::vector<pugi::xml_node>& interpretations, std::vector<Json>& events) {
    if (interpretations.empty()) return;
    const auto& first = interpretations.front();
    const auto mode = inherited(first, "mode"), medium = inherited(first, "medium");
    const bool speech = mode == "voice" || medium == "acoustic" || (mode.empty() && medium.empty());
    const auto start = finite_number(inherited(first, "start")), end = finite_number(inherited(first, "end"));
    Json event = Json::object();
    if (start) event["t"] = *start / 1000;
    event["kind"] = speech ? "speech" : "gesture";
    if (start && end && *end >= *start) event["until"] = *end / 1000;
    for (const auto& one : interpretations) {
      if (attribute_of(one, "uninterpreted") == "true" && attribute_of(one, "tokens").empty()) continue;
      auto content = attribute_of(one, "tokens");
      if (content.empty() || !speech) content = text_within(one);
      const auto sure = finite_number(attribute_of(one, "confidence"));
      if (content.empty()) continue;
      Json alternative = {{"text", content}, {"confidence", std::clamp(sure.value_or(1), 0.0, 1.0)}};
      event["alternatives"].push_back(std::move(alternative));
    }
    if (!event.contains("alternatives")) return;
    if (event["alternatives"].size() == 1) {
      const auto [text, sure] = std::pair(event["alternatives"][0]["text"], event["alternatives"][0]["confidence"]);
      event.erase("alternatives");
      event[speech ? "text" : "name"] = text;
      if (sure != 1.0) event["confidence"] = sure;
    }
    events.push_back(std::move(event));
  }

  std::size_t line(std::ptrdiff_t offset) const {
    const auto end = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
    return first_ + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + end, '\n'));
  }

  std::string_view text_;
  std::size_t first_;  // line
  const std::string& name_;
  pugi::xml_document document_;
};

class EmmaReader : public RecogniserReader {
 public:
  using RecogniserReader::RecogniserReader;
  void read(const OutputPart& part, Recognised& gain) override {
    if (auto problem = EmmaDocument(part, name()).read(gain.events)) gain.problems.push_back(*std::move(problem));
  }
};

}  // namespace

std::unique_ptr<RecogniserReader> emma_reader(OutputSource source) {
  return std::make_unique<EmmaReader>(std::move(source));
}

}  // namespace continua
