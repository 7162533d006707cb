// The shapes of JSON in a machine file, and the problems found on the way.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine_file/machine_keys.h"
#include "machine_file/machine_reader.h"

namespace continua {
namespace {

constexpr std::size_t most_problems = 1000;

std::string found(const Json& json) {
  if (json.is_string()) return in_quotes(json.get<std::string>());
  if (json.is_number()) return compact(json);
  return json.is_array() ? "a list" : json.is_object() ? "an object" : json.is_null() ? "null" : compact(json);
}

}  // namespace

Item MachineReader::member(const Item& object, const std::string& key) const {
  if (!object.json || !object.json->is_object()) return {nullptr, object.pointer};
  const auto known = object.json->find(key);
  if (known == object.json->end()) return {nullptr, object.pointer};
  std::string escaped;
  for (const char c : key) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return {&*known, object.pointer + "/" + escaped};
}

Item MachineReader::required(const Item& object, const std::string& key, const char* what) {
  auto item = member(object, key);
  if (!item.json) problem(object, fmt::format("there is no \"{}\"; expected {}", key, what));
  return item;
}

Item MachineReader::element(const Item& array, std::size_t index) const {
  return {&(*array.json)[index], array.pointer + "/" + std::to_string(index)};
}

bool MachineReader::expect_object(const Item& item, const char* what) {
  if (!item.json) return false;
  if (!item.json->is_object()) return mismatch(item, fmt::format("{}, an object", what));
  const auto keys = machine_keys().find(what);
  if (keys == machine_keys().end()) return true;
  for (const auto& [key, value] : item.json->items()) {
    const auto& known = keys->second;
    if (std::find(known.begin(), known.end(), key) == known.end())
      problem_at_key(member(item, key),
                     fmt::format("unknown key {} of {}{}", in_quotes(key), what, nearest(key, known)));
    else if (key == "about" && !value.is_string())
      mismatch(member(item, key), "what it is about, a string");
  }
  return true;
}

bool MachineReader::expect_array(const Item& item, const char* what) {
  if (!item.json) return false;
  return item.json->is_array() || mismatch(item, fmt::format("{}, a list", what));
}

std::string MachineReader::text_of(const Item& item, const char* what) {
  if (!item.json) return {};
  if (!item.json->is_string()) mismatch(item, fmt::format("{}, a string", what));
  return item.json->is_string() ? item.json->get<std::string>() : std::string();
}

std::string MachineReader::name_of(const Item& item, const char* what) {
  auto name = text_of(item, what);
  if (name.empty() && item.json && item.json->is_string()) mismatch(item, what);
  return name;
}

std::optional<std::string> MachineReader::one_of(const Item& object, const std::string& key,
                                                 const std::vector<std::string>& names) {
  const auto item = member(object, key);
  if (!item.json) return std::nullopt;
  const auto expected = fmt::to_string(fmt::join(names, " or "));
  const auto name = text_of(item, expected.c_str());
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  if (item.json->is_string()) mismatch(item, expected + nearest(name, names));
  return std::nullopt;
}

double MachineReader::number_of(const Item& item, const char* what, double otherwise, double least, double most) {
  if (!item.json) return otherwise;
  const double number = item.json->is_number() ? item.json->get<double>() : std::nan("");
  if (number >= least && number <= most) return number;
  mismatch(item, fmt::format("{}, a number from {} to {}", what, least, most));
  return otherwise;
}

bool MachineReader::truth_of(const Item& item, bool otherwise) {
  if (!item.json) return otherwise;
  if (!item.json->is_boolean()) return mismatch(item, "true or false"), otherwise;
  return item.json->get<bool>();
}

bool MachineReader::mismatch(const Item& item, const std::string& expected) {
  problem(item, fmt::format("found {}, expected {}", found(*item.json), expected));
  return false;
}

void MachineReader::problem(const Item& at, std::string sentence) {
  note(document_->place(at.pointer), std::move(sentence));
}

void MachineReader::problem_in_text(const Item& at, const Error& error, std::size_t from, std::size_t before) {
  constexpr std::string_view prefix = "column ";
  require(error.where.starts_with(prefix), "an error in a text names its column");
  const auto byte = std::stoul(error.where.substr(prefix.size())) - 1;
  note(document_->place_in_text(at.pointer, from + (byte < before ? 0 : byte - before)), error.sentence);
}

void MachineReader::problem_at_key(const Item& at, std::string sentence) {
  note(document_->key_place(at.pointer), std::move(sentence));
}

void MachineReader::note(TextPlace place, std::string sentence) {
  if (!full()) problems_.push_back({document_, place, std::move(sentence)});
}

bool MachineReader::full() const { return problems_.size() >= most_problems; }

std::string MachineReader::nearest(const std::string& name, const std::vector<std::string>& known) const {
  return full() ? std::string() : did_you_mean(name, known);
}

std::vector<Error> MachineReader::problems() {
  const auto of_phrases = [this](const Problem& problem) { return problem.document != &machine_document_; };
  std::stable_sort(problems_.begin(), problems_.end(), [&](const Problem& a, const Problem& b) {
    return std::pair(of_phrases(a), a.place) < std::pair(of_phrases(b), b.place);
  });
  std::vector<Error> errors;
  for (const auto& problem : problems_) {
    auto error = problem.document->error(problem.place, problem.sentence);
    if (of_phrases(problem)) error.sentence += fmt::format(" (read for the machine {})", machine_.name);
    if (errors.empty() || errors.back().text() != error.text()) errors.push_back(std::move(error));
  }
  errors.insert(errors.end(), phrase_problems_.begin(), phrase_problems_.end());
  return errors;
}

}  // namespace continua
