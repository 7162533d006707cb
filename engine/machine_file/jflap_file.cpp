#include "continua/machine_file/jflap_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>

#include "continua/core/characters.h"
#include "continua/core/located_json.h"
#include "continua/core/trimmed.h"

namespace continua {
namespace {

// The text in UTF-8. `encoding` is one that pugixml has recognised.
std::string utf8_of(std::string_view text, pugi::xml_encoding encoding) {
  const bool little = encoding == pugi::encoding_utf16_le || encoding == pugi::encoding_utf32_le;
  const bool utf16 = encoding == pugi::encoding_utf16_le || encoding == pugi::encoding_utf16_be;
  const std::size_t width = encoding == pugi::encoding_latin1 ? 1 : utf16 ? 2 : 4;
  std::wstring points;
  for (std::size_t at = 0; at + width <= text.size(); at += width) {
    std::uint32_t unit = 0;
    for (std::size_t i = 0; i < width; ++i)
      unit = unit << 8 | static_cast<unsigned char>(text[at + (little ? width - 1 - i : i)]);
    const bool second_half =
        utf16 && (unit & 0xFC00) == 0xDC00 && !points.empty() && (points.back() & 0xFC00) == 0xD800;
    if (second_half)
      points.back() = static_cast<wchar_t>(0x10000 + ((points.back() & 0x3FF) << 10) + (unit & 0x3FF));
    else
      points += static_cast<wchar_t>(unit);
  }
  return pugi::as_utf8(points);
}

// Whether JFLAP reads the label of a finite automaton as a range: "[0-9]".
bool is_range(const std::vector<std::string>& label) {
  return label.size() == 5 && label[0] == "[" && label[2] == "-" && label[4] == "]";
}

std::vector<std::string> range(const std::string& first, const std::string& last) {
  std::vector<std::string> found;
  for (auto point = pugi::as_wide(first)[0]; point <= pugi::as_wide(last)[0]; ++point)
    if (point < 0xD800 || point > 0xDFFF) found.push_back(pugi::as_utf8(std::wstring(1, point)));
  return found;
}

class JflapReader {
 public:
  JflapReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  Result<JflapAutomaton> read() {
    for (const auto part :
         {&JflapReader::parse, &JflapReader::read_type, &JflapReader::read_states, &JflapReader::read_transitions})
      if (auto problem = (this->*part)()) return *problem;
    return std::move(automaton_);
  }

 private:
  Outcome parse() {
    constexpr unsigned options = pugi::parse_default | pugi::parse_ws_pcdata_single;
    auto parsed = document_.load_buffer(text_.data(), text_.size(), options);
    if (parsed.encoding != pugi::encoding_utf8) {
      text_ = utf8_of(text_, parsed.encoding);
      parsed = document_.load_buffer(text_.data(), text_.size(), options, pugi::encoding_utf8);
    }
    for (std::size_t at = 0, length = 0; at < text_.size(); at += length)
      if ((length = character_length(std::string_view(text_).substr(at))) == 0)
        return error(at, fmt::format("found the byte {:#04x}, which is not UTF-8; expected a JFLAP file in XML",
                                     static_cast<unsigned>(static_cast<unsigned char>(text_[at]))));
    if (!parsed)
      return error(static_cast<std::size_t>(parsed.offset),
                   fmt::format("not valid XML: {}; expected a JFLAP file", parsed.description()));
    root_ = document_.document_element();
    if (std::string_view(root_.name()) != "structure")
      return error(root_, fmt::format("found <{}>; expected <structure>, the root of a JFLAP file", root_.name()));
    // Before JFLAP 7 states and transitions stood in <structure> itself.
    parts_ = root_.child("automaton") ? root_.child("automaton") : root_;
    return std::nullopt;
  }

  Outcome read_type() {
    const auto element = root_.child("type");
    if (!element) return error(root_, "there is no <type>; expected <type>fa</type> or <type>pda</type>");
    const std::string type(trimmed(text_of(element)));
    if (type != "fa" && type != "pda")
      return error(element, fmt::format("found an automaton of type {}; expected fa or pda", in_quotes(type)));
    automaton_.pushdown = type == "pda";
    return std::nullopt;
  }

  Outcome read_states() {
    pugi::xml_node start;
    for (const auto element : parts_.children("state")) {
      const auto id = number(std::string(trimmed(element.attribute("id").value())));
      if (!element.attribute("id")) return error(element, "a state without an id; expected <state id=\"0\">");
      if (!id)
        return error(element, fmt::format("found the state id {}; expected an integer",
                                          in_quotes(element.attribute("id").value())));
      const auto [other, fresh] = states_.emplace(*id, element);
      if (!fresh)
        return error(element, fmt::format("a second state with the id {}; the first is in line {}", *id,
                                          line(other->second.offset_debug())));
      automaton_.states.push_back({name_of(element, *id), *id, static_cast<bool>(element.child("final"))});
      if (!element.child("initial")) continue;
      if (start)
        return error(element, fmt::format("a second initial state; the first is in line {}, expected one",
                                          line(start.offset_debug())));
      start = element;
      automaton_.start = automaton_.states.size() - 1;
    }
    if (automaton_.states.empty()) return error(parts_, "there are no states; expected <state id=\"0\">");
    if (!start) return error(parts_, "no state is initial; expected one with <initial/>");
    return std::nullopt;
  }

  Outcome read_transitions() {
    std::map<long, std::size_t> index;
    for (std::size_t i = 0; i < automaton_.states.size(); ++i) index.emplace(automaton_.states[i].id, i);
    std::set<JflapTransition> seen;
    for (const auto element : parts_.children("transition")) {
      JflapTransition transition;
      for (const auto& [what, end] : {std::pair("from", &transition.from), std::pair("to", &transition.to)}) {
        const auto child = element.child(what);
        if (!child) return error(element, fmt::format("a transition without <{}>; expected the id of a state", what));
        const std::string text(trimmed(text_of(child)));
        const auto id = number(text);
        if (!id || !index.contains(*id))
          return error(child, fmt::format("found <{}> {}; expected the id of a state", what, in_quotes(text)));
        *end = index.at(*id);
      }
      if (auto problem = read_label(element, "read", transition.read)) return problem;
      if (automaton_.pushdown) {
        if (auto problem = read_label(element, "pop", transition.pop)) return problem;
        if (auto problem = read_label(element, "push", transition.push)) return problem;
      } else if (is_range(transition.read)) {
        transition.read = range(transition.read[1], transition.read[3]);
        transition.reads_any = true;
      }
      if (seen.insert(transition).second) automaton_.transitions.push_back(std::move(transition));
    }
    return std::nullopt;
  }

  Outcome read_label(const pugi::xml_node& transition, const char* what, std::vector<std::string>& label) {
    const auto child = transition.child(what);
    if (const auto second = child.next_sibling(what))
      return error(second, fmt::format("a second <{}> of a transition; expected one", what));
    label = characters(without_layout(text_of(child)));
    return std::nullopt;
  }

  static std::string text_of(const pugi::xml_node& element) {
    std::string text;
    for (const auto part : element.children())
      if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) text += part.value();
    return text;
  }

  // Trims only text with line breaks: a blank is a symbol, but an element may be written on several lines.
  static std::string without_layout(const std::string& text) {
    return text.find('\n') == std::string::npos ? text : std::string(trimmed(text));
  }

  // The name of a state: an attribute since JFLAP 7, an element before.
  static std::string name_of(const pugi::xml_node& state, long id) {
    const auto attribute = trimmed(state.attribute("name").value());
    const std::string name(attribute.empty() ? trimmed(text_of(state.child("name"))) : attribute);
    return name.empty() ? fmt::format("q{}", id) : name;
  }

  static std::optional<long> number(const std::string& text) {
    long value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    return value;
  }

  std::size_t line(std::ptrdiff_t offset) const {
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + offset, '\n'));
  }

  Error error(const pugi::xml_node& at, std::string sentence) const {
    return error(static_cast<std::size_t>(at.offset_debug()), std::move(sentence));
  }
  Error error(std::size_t at, std::string sentence) const {
    const auto offset = static_cast<std::ptrdiff_t>(std::min(at, text_.size()));
    return {fmt::format("{}:{}", name_, line(offset)), std::move(sentence)};
  }

  std::string text_;  // in UTF-8 once it is parsed: places in the document are places in it
  std::string name_;
  pugi::xml_document document_;
  pugi::xml_node root_, parts_;
  std::map<long, pugi::xml_node> states_;
  JflapAutomaton automaton_;
};

}  // namespace

Result<JflapAutomaton> read_jflap(std::string_view text, const std::string& name) {
  return JflapReader(text, name).read();
}

}  // namespace continua
