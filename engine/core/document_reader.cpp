#include "continua/core/document_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "continua/core/json_pointer.h"

namespace continua {
namespace {

std::string shown(const Json& json) {
  if (json.is_string()) return in_quotes(json.get_ref<const std::string&>());
  return json.is_array() ? "a list" : json.is_object() ? "an object" : compact(json);
}

}  // namespace

std::string any_of(const std::vector<std::string>& names) {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
  return all;
}

std::size_t byte_of_column(const Error& error) {
  constexpr std::string_view prefix = "column ";
  require(error.where.starts_with(prefix), "an error in a text names its column");
  return std::stoul(error.where.substr(prefix.size())) - 1;
}

const LocatedJson& Item::document() const {
  require(reader_ != nullptr, "an item without a document has no place");
  return *reader_->sources_[source_].document;
}

const Json& Item::json() const {
  require(exists(), "an absent item has no value");
  return *json_;
}

std::string Item::where() const { return document().where(pointer_); }

Item Item::member(std::string_view key) const {
  const auto found = is_object() ? json_->find(key) : Json::const_iterator();
  if (!is_object() || found == json_->end()) return {reader_, source_, nullptr, pointer_};
  return {reader_, source_, &*found, pointer_ + "/" + pointer_part(key)};
}

Item Item::required(std::string_view key, std::string_view what) const {
  auto item = member(key);
  if (!item.exists()) problem(fmt::format("there is no \"{}\"; expected {}", key, what));
  return item;
}

Item Item::element(std::size_t index) const {
  if (!is_list() || index >= json_->size()) return {reader_, source_, nullptr, pointer_};
  return {reader_, source_, &(*json_)[index], fmt::format("{}/{}", pointer_, index)};
}

std::vector<NamedItem> Item::members(std::string_view what) const {
  std::vector<NamedItem> members;
  if (!exists()) return members;
  if (!is_object()) return mismatch(fmt::format("{}, an object", what)), members;
  for (const auto& [key, value] : json_->items())
    members.push_back({key, Item(reader_, source_, &value, pointer_ + "/" + pointer_part(key))});
  return members;
}

std::vector<Item> Item::elements(std::string_view what) const {
  std::vector<Item> elements;
  if (!exists()) return elements;
  if (!is_list()) return mismatch(fmt::format("{}, a list", what)), elements;
  for (std::size_t i = 0; i < json_->size(); ++i) elements.push_back(element(i));
  return elements;
}

bool Item::expect_object(std::string_view what, const std::vector<std::string>& keys) const {
  if (!exists()) return false;
  if (!is_object()) return mismatch(fmt::format("{}, an object", what));
  for (const auto& [key, item] : members(what)) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      item.problem_at_key(fmt::format("unknown key {} of {}{}", in_quotes(key), what, nearest(key, keys)));
    else if (key == "about")
      item.text("what it is about");
  }
  return true;
}

void Item::expect_version(std::string_view key, int version) const {
  const auto expected = fmt::format("{}, the version of the format", version);
  const auto found = required(key, expected);
  if (found.exists() && found.json() != version) found.mismatch(expected);
}

std::string Item::text(std::string_view what) const {
  if (is_text()) return json_->get<std::string>();
  if (exists()) mismatch(fmt::format("{}, a string", what));
  return {};
}

std::string Item::name(std::string_view what) const {
  auto name = text(what);
  if (name.empty() && is_text()) mismatch(what);
  return name;
}

std::vector<std::string> Item::texts(std::string_view what) const {
  std::vector<std::string> texts;
  for (const auto& item : elements(what)) {
    if (!item.is_text()) item.mismatch("a string");
    texts.push_back(item.is_text() ? item.json().get<std::string>() : std::string());
  }
  return texts;
}

double Item::number(std::string_view what, double otherwise, double least, double most) const {
  if (!exists()) return otherwise;
  const double number = json_->is_number() ? json_->get<double>() : std::nan("");
  if (number >= least && number <= most) return number;
  mismatch(fmt::format("{}, a number from {} to {}", what, least, most));
  return otherwise;
}

int Item::whole_number(std::string_view what, int otherwise, int least, int most) const {
  if (!exists()) return otherwise;
  const double number = json_->is_number() ? json_->get<double>() : std::nan("");
  if (number >= least && number <= most && number == std::floor(number)) return static_cast<int>(number);
  mismatch(fmt::format("{}, a whole number from {} to {}", what, least, most));
  return otherwise;
}

bool Item::truth(bool otherwise) const {
  if (!exists()) return otherwise;
  if (json_->is_boolean()) return json_->get<bool>();
  mismatch("true or false");
  return otherwise;
}

std::optional<std::string> Item::one_of(const std::vector<std::string>& names, std::string_view what) const {
  if (!exists()) return std::nullopt;
  auto name = text(what);
  if (!is_text()) return std::nullopt;
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  mismatch(any_of(names) + nearest(name, names));
  return std::nullopt;
}

std::optional<std::string> Item::one_of(const std::vector<std::string>& names) const {
  return one_of(names, any_of(names));
}

bool Item::mismatch(std::string_view expected) const {
  problem(fmt::format("found {}, expected {}", shown(json()), expected));
  return false;
}

void Item::problem(std::string sentence) const {
  reader_->note(source_, document().place(pointer_), std::move(sentence));
}

void Item::problem_at_key(std::string sentence) const {
  reader_->note(source_, document().key_place(pointer_), std::move(sentence));
}

void Item::problem_in_text(std::size_t byte, std::string sentence) const {
  reader_->note(source_, document().place_in_text(pointer_, byte), std::move(sentence));
}

void Item::problem_in_text(const Error& error) const { problem_in_text(byte_of_column(error), error.sentence); }

std::string Item::unknown(std::string_view kind, std::string_view name, const std::vector<std::string>& known) const {
  return fmt::format("unknown {} {}{}", kind, in_quotes(name), nearest(name, known));
}

std::string Item::nearest(std::string_view name, const std::vector<std::string>& known) const {
  return reader_is_full() ? std::string() : did_you_mean(name, known);
}

bool Item::reader_is_full() const { return reader_->full(); }

Item DocumentReader::root(const LocatedJson& document, std::string remark) {
  const auto source = sources_.size();
  sources_.push_back({&document, std::move(remark)});
  for (const auto& [place, key] : document.duplicates())
    note(source, place, fmt::format("the key {} a second time in this object", in_quotes(key)));
  return {this, source, &document.root(), ""};
}

void DocumentReader::note(std::size_t source, TextPlace place, std::string sentence) {
  if (!full()) problems_.push_back({source, place, std::move(sentence)});
}

std::vector<Error> DocumentReader::problems() const {
  auto sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::pair(a.source, a.place) < std::pair(b.source, b.place);
  });
  std::vector<Error> errors;
  for (const auto& [source, place, sentence] : sorted) {
    auto error = sources_[source].document->error(place, sentence + sources_[source].remark);
    if (errors.empty() || errors.back().text() != error.text()) errors.push_back(std::move(error));
  }
  return errors;
}

}  // namespace continua
