#include "continua/replay/annotation/label_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <sstream>

#include "continua/core/characters.h"
#include "continua/replay/trace/session_notation.h"

namespace continua {
namespace {

std::deque<std::string> words_of_label(const std::string& label) {
  std::istringstream text(label);
  std::deque<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

// "0.1,-0.2" as numbers.
std::optional<Json> numbers_in(const std::string& word, std::size_t count) {
  Json numbers = Json::array();
  std::istringstream text(word);
  for (std::string part; std::getline(text, part, ',');) {
    const auto number = finite_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

// The value of a part of a gesture's label, if the word can be that part.
std::optional<Json> value_of_part(const std::string& part, const std::string& word) {
  static const std::map<std::string, std::vector<std::string>> words = {
      {"hand", {"left", "right"}},
      {"direction", {"left", "right", "front", "back", "up", "down"}},
      {"phase", {"start", "stop", "stroke"}}};
  if (part == "target") return numbers_in(word, 2);
  const auto& known = words.at(part);
  const auto small = folded(word);
  return std::find(known.begin(), known.end(), small) == known.end() ? std::nullopt : std::optional<Json>(small);
}

// Parts before the name are read from the front, parts after it from the back; the rest is the name.
Result<Json> read_gesture(const std::string& label, const std::vector<std::string>& parts) {
  auto words = words_of_label(label);
  Json members = Json::object();
  const auto name = std::find(parts.begin(), parts.end(), "name");
  for (auto part = parts.begin(); part != name && words.size() > 1; ++part)
    if (const auto value = value_of_part(*part, words.front())) members[*part] = *value, words.pop_front();
  for (auto part = parts.end(); part != name && part - 1 != name && words.size() > 1; --part)
    if (const auto value = value_of_part(*(part - 1), words.back())) members[*(part - 1)] = *value, words.pop_back();
  std::string named;
  for (const auto& word : words) named += (named.empty() ? "" : "_") + word;
  if (named.empty()) return Error{"", "found an empty label; expected a gesture's name"};
  members["name"] = named;
  return members;
}

Result<Json> read_place(const std::string& label, bool hands) {
  auto words = words_of_label(label);
  Json members = Json::object();
  if (hands && !words.empty())
    if (const auto hand = value_of_part("hand", words.front())) members["hand"] = *hand, words.pop_front();
  if (words.size() == 1)
    if (const auto target = numbers_in(words[0], 2)) return members["target"] = *target, members;
  if (words.size() == 2) {
    const auto from = numbers_in(words[0], 3), direction = numbers_in(words[1], 3);
    if (from && direction) return members["ray"] = {{"from", *from}, {"direction", *direction}}, members;
  }
  return Error{"",
               fmt::format("found {}; expected a point x,y of the table, or a ray x,y,z dx,dy,dz", in_quotes(label))};
}

}  // namespace

Result<Json> read_label(const std::string& label, const TierUse& use) {
  if (use.kind == "gesture") return read_gesture(label, use.parts);
  if (use.kind == "pointing" || use.kind == "gaze") return read_place(label, use.kind == "pointing");
  if (label.empty()) return Error{"", fmt::format("found an empty label; expected the text of {}", use.kind)};
  if (use.kind == "speech" || use.kind == "mark") return Json{{"text", label}};
  if (use.kind == "observed") return Json{{"channel", use.channel}, {"content", label}};
  const auto members = LocatedJson::parse(label, "");
  if (!members || !members->root().is_object())
    return Error{"",
                 fmt::format("found {}; expected what must hold, as JSON: {{\"says\":\"Okay.\"}}", in_quotes(label))};
  return members->root();
}

}  // namespace continua
