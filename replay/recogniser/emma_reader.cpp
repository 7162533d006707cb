// EMMA 1.0, W3C's notation for what recognisers of any kind have understood.
#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>

#include "continua/replay/recogniser/json_values.h"
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

class EmmaReader {
 public:
  EmmaReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<std::vector<Json>> read() {
    const auto parsed = document_.load_buffer(text_.data(), text_.size());
    if (!parsed)
      return lacks(name_, line(parsed.offset),
                   fmt::format("EMMA in XML; found that it is no XML: {}", parsed.description()));
    const auto root = document_.document_element();
    if (local(root.name()) != "emma")
      return lacks(name_, line(root.offset_debug()), "<emma:emma>, the root of an EMMA document");
    if (auto problem = walk(root)) return *problem;
    return events_;
  }

 private:
  Outcome walk(const pugi::xml_node& element) {
    for (const auto part : element.children()) {
      const auto name = local(part.name());
      Outcome problem;
      if (name == "one-of")
        problem = add_list(part);
      else if (name == "interpretation")
        problem = add(part, {part});
      else if (name == "group" || name == "sequence")
        problem = walk(part);
      if (problem) return problem;
    }
    return std::nullopt;
  }

  // An n-best list is one event; lists in lists, such as of several readings of one sound, are one list.
  Outcome add_list(const pugi::xml_node& list) {
    std::vector<pugi::xml_node> all;
    collect(list, all);
    return all.empty() ? Outcome() : add(list, all);
  }

  static void collect(const pugi::xml_node& list, std::vector<pugi::xml_node>& all) {
    for (const auto part : list.children())
      if (local(part.name()) == "interpretation")
        all.push_back(part);
      else if (local(part.name()) == "one-of" && all.size() < 100)
        collect(part, all);
  }

  Outcome add(const pugi::xml_node& element, const std::vector<pugi::xml_node>& interpretations) {
    const auto start = finite_number(inherited(interpretations.front(), "start"));
    const auto end = finite_number(inherited(interpretations.front(), "end"));
    if (!start) return lacks(name_, line(element.offset_debug()), "emma:start, in milliseconds");
    const auto mode = inherited(interpretations.front(), "mode"), medium = inherited(interpretations.front(), "medium");
    const bool speech = mode == "voice" || medium == "acoustic" || (mode.empty() && medium.empty());
    Json event = {{"t", *start / 1000}, {"kind", speech ? "speech" : "gesture"}};
    if (end && *end >= *start) event["until"] = *end / 1000;
    for (const auto& one : interpretations) {
      if (attribute_of(one, "uninterpreted") == "true" && attribute_of(one, "tokens").empty()) continue;
      auto content = attribute_of(one, "tokens");
      if (content.empty() || !speech) content = text_within(one);
      const auto sure = finite_number(attribute_of(one, "confidence"));
      if (content.empty()) continue;
      Json alternative = {{"text", content}, {"confidence", std::clamp(sure.value_or(1), 0.0, 1.0)}};
      event["alternatives"].push_back(std::move(alternative));
    }
    if (!event.contains("alternatives")) return std::nullopt;
    if (event["alternatives"].size() == 1) {
      const auto [text, sure] = std::pair(event["alternatives"][0]["text"], event["alternatives"][0]["confidence"]);
      event.erase("alternatives");
      event[speech ? "text" : "name"] = text;
      if (sure != 1.0) event["confidence"] = sure;
    }
    events_.push_back(std::move(event));
    return std::nullopt;
  }

  std::size_t line(std::ptrdiff_t offset) const {
    const auto end = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + end, '\n'));
  }

  std::string_view text_;
  const std::string& name_;
  pugi::xml_document document_;
  std::vector<Json> events_;
};

}  // namespace

Result<std::vector<Json>> read_emma(std::string_view text, const std::string& name) {
  return EmmaReader(text, name).read();
}

}  // namespace continua
