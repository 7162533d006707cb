#include "continua/core/located_json.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_map>

#include <fmt/format.h>

#include "continua/core/json_pointer.h"

template class nlohmann::basic_json<nlohmann::ordered_map>;
template class nlohmann::detail::lexer<continua::Json, continua::detail::TextOfString>;
template class nlohmann::detail::lexer<continua::Json, continua::detail::TextOfView>;
template class nlohmann::detail::serializer<continua::Json>;

namespace continua {
namespace {

// Walks a text that is valid JSON and notes the beginning of each value and its key.
template <class Note>
class PlaceFinder {
 public:
  PlaceFinder(std::string_view text, Note note) : text_(text), note_(std::move(note)) {}

  void walk(const std::string& pointer, std::optional<TextPlace> key = std::nullopt) {
    skip_space();
    note_(pointer, here(), key.value_or(here()), at_);
    if (text_[at_] == '{')
      walk_members(pointer);
    else if (text_[at_] == '[')
      walk_elements(pointer);
    else if (text_[at_] == '"')
      skip_string();
    else
      while (at_ < text_.size() && std::string_view(",]} \n\t\r").find(text_[at_]) == std::string_view::npos) step();
  }

  std::vector<LocatedJson::Duplicate> duplicates;

 private:
  TextPlace here() const { return {line_, at_ - line_start_ + 1}; }

  void walk_members(const std::string& pointer) {
    std::set<std::string> keys;
    step();
    for (skip_space(); text_[at_] != '}'; skip_space()) {
      const auto place = here();
      const auto from = at_;
      skip_string();
      const auto key = Json::parse(text_.substr(from, at_ - from)).template get<std::string>();
      if (!keys.insert(key).second) duplicates.push_back({place, key});
      skip_space();
      step();  // the colon
      walk(pointer + "/" + pointer_part(key), place);
      skip_comma();
    }
    step();
  }

  void walk_elements(const std::string& pointer) {
    step();
    std::size_t index = 0;
    for (skip_space(); text_[at_] != ']'; skip_space()) {
      walk(pointer + "/" + std::to_string(index++));
      skip_comma();
    }
    step();
  }

  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    }
    ++at_;
  }
  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \n\t\r").find(text_[at_]) != std::string_view::npos) step();
  }
  void skip_comma() {
    skip_space();
    if (text_[at_] == ',') step();
  }
  void skip_string() {
    step();
    while (text_[at_] != '"') {
      if (text_[at_] == '\\') step();
      step();
    }
    step();
  }

  std::string_view text_;
  Note note_;
  std::size_t at_ = 0, line_ = 1, line_start_ = 0;
};

// The library's message "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error …; last read:
// '…'; expected …" without its first two parts, and without the part `last read` if it is long.
std::string plain_sentence(std::string what) {
  constexpr std::size_t longest = 60;
  if (const auto from = what.find("; last read: "); from != std::string::npos) {
    const auto expected = what.rfind("'; expected");
    const auto to = expected == std::string::npos || expected < from ? what.size() : expected + 1;
    if (to - from > longest) what.erase(from, to - from);
  }
  const auto position = what.find("column ");
  const auto colon = position == std::string::npos ? what.find("] ") : what.find(": ", position);
  return "not valid JSON: " + (colon == std::string::npos ? what : what.substr(colon + 2));
}

struct Excess {
  std::size_t at;
  std::string sentence;
};

// The members of all objects in a value.
std::size_t members_in(const Json& value) {
  std::size_t count = value.is_object() ? value.size() : 0;
  if (value.is_structured())
    for (const auto& inner : value) count += members_in(inner);
  return count;
}

// The colons of a valid document outside its texts: one for each member that it writes.
std::size_t members_written(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == ':') ++count;
    if (text[at] != '"') continue;
    for (++at; text[at] != '"'; ++at)
      if (text[at] == '\\') ++at;
  }
  return count;
}

// The keys that a valid document has a second time in one object.
std::vector<LocatedJson::Duplicate> duplicates_in(std::string_view text) {
  PlaceFinder finder(text, [](const std::string&, TextPlace, TextPlace, std::size_t) {});
  finder.walk("");
  return std::move(finder.duplicates);
}

// The first place where brackets nest deeper than `max_json_depth`, or an object has more than `max_json_members`.
std::optional<Excess> excess(std::string_view text) {
  std::vector<std::size_t> colons;  // in each open bracket
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
    } else if (c == '[' || c == '{') {
      if (colons.size() == max_json_depth)
        return Excess{at, fmt::format("nested deeper than {} levels; expected fewer", max_json_depth)};
      colons.push_back(0);
    } else if ((c == ']' || c == '}') && !colons.empty()) {
      colons.pop_back();
    } else if (c == ':' && !colons.empty() && ++colons.back() > max_json_members) {
      return Excess{at, fmt::format("an object with more than {} members; expected fewer", max_json_members)};
    }
  }
  return std::nullopt;
}

// The length of the character or escape at `at` in a quoted text, in the document and in the value.
std::pair<std::size_t, std::size_t> escape_lengths(std::string_view text, std::size_t at) {
  if (text[at] != '\\') return {1, 1};
  if (text[at + 1] != 'u') return {2, 1};
  const auto code = std::stoul(std::string(text.substr(at + 2, 4)), nullptr, 16);
  if (code >= 0xD800 && code < 0xDC00) return {12, 4};  // the first of a pair
  return {6, code < 0x80 ? 1 : code < 0x800 ? 2 : 3};
}

// The place of a number too large for a double. The library reports it without a place, as "… number overflow parsing
// '1e999'".
std::size_t place_of_number(std::string_view text, std::string_view what) {
  const auto from = what.find('\''), to = what.rfind('\'');
  const auto found = from < to ? text.find(what.substr(from + 1, to - from - 1)) : std::string_view::npos;
  return found == std::string_view::npos ? 0 : found;
}

// `first_line`: the number of the text's first line in the file `name`.
Result<Json> parse_text(std::string_view text, const std::string& name, std::size_t first_line) {
  const auto error_at = [&](std::size_t at, std::string sentence) {
    const auto end = std::min(at, text.size());
    const auto newlines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const auto newline = end == 0 ? std::string_view::npos : text.rfind('\n', end - 1);
    const auto column = newline == std::string_view::npos ? end + 1 : end - newline;
    return Error{fmt::format("{}:{}:{}", name, first_line + static_cast<std::size_t>(newlines), column),
                 std::move(sentence)};
  };
  if (auto found = excess(text)) return error_at(found->at, std::move(found->sentence));
  try {
    auto value = Json::parse(text);
    // The library takes a byte of value 0 for the end of the text, whatever follows.
    if (const auto zero = text.find('\0'); zero != std::string_view::npos)
      return error_at(zero, "found a byte of value 0 after the JSON; expected nothing more");
    return value;
  } catch (const nlohmann::json::parse_error& problem) {
    return error_at(problem.byte > 0 ? problem.byte - 1 : 0, plain_sentence(problem.what()));
  } catch (const nlohmann::json::exception& problem) {
    return error_at(place_of_number(text, problem.what()), plain_sentence(problem.what()));
  }
}

}  // namespace

std::string compact(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

Result<Json> parse_json_line(std::string_view text, const std::string& name, std::size_t line) {
  auto value = parse_text(text, name, line);
  if (!value || members_in(*value) == members_written(text)) return value;
  const auto [place, key] = duplicates_in(text).front();
  return Error{fmt::format("{}:{}:{}", name, line + place.line - 1, place.column),
               fmt::format("the key '{}' a second time in this object", key)};
}

struct LocatedJson::Locations {
  std::once_flag found;
  std::unordered_map<std::string, Location> by_pointer;
};

Result<LocatedJson> LocatedJson::parse(std::string_view text, std::string name) {
  text = without_byte_order_mark(text);
  LocatedJson document;
  document.name_ = std::move(name);
  if (text.find_first_not_of(" \n\t\r") == std::string_view::npos)
    return Error{document.name_ + ":1:1", "the file is empty; expected a JSON document"};
  auto root = parse_text(text, document.name_, 1);
  if (!root) return root.error();
  document.root_ = std::move(root).value();
  document.text_ = text;
  document.locations_ = std::make_shared<Locations>();
  if (members_in(document.root_) != members_written(text)) document.duplicates_ = duplicates_in(text);
  return document;
}

Result<LocatedJson> LocatedJson::read(const std::string& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  return parse(*text, path);
}

const LocatedJson::Location* LocatedJson::location(std::string_view pointer) const {
  std::call_once(locations_->found, [this] {
    PlaceFinder finder(text_, [this](const std::string& at, TextPlace value, TextPlace key, std::size_t offset) {
      locations_->by_pointer.insert_or_assign(at, Location{value, key, offset});
    });
    finder.walk("");
  });
  const auto& known = locations_->by_pointer;
  for (std::string at(pointer);;) {
    const auto found = known.find(at);
    if (found != known.end()) return &found->second;
    require(!at.empty(), "a document without a root");
    const auto slash = at.rfind('/');
    at.erase(slash == std::string::npos ? 0 : slash);
  }
}

TextPlace LocatedJson::place(std::string_view pointer) const { return location(pointer)->value; }

TextPlace LocatedJson::key_place(std::string_view pointer) const { return location(pointer)->key; }

TextPlace LocatedJson::place_in_text(std::string_view pointer, std::size_t byte) const {
  const auto& [value, key, offset] = *location(pointer);
  if (text_[offset] != '"') return value;
  auto at = offset + 1;
  for (std::size_t passed = 0; passed < byte && text_[at] != '"';) {
    const auto [length, bytes] = escape_lengths(text_, at);
    at += length;
    passed += bytes;
  }
  return {value.line, value.column + (at - offset)};
}

Error LocatedJson::error(TextPlace place, std::string sentence) const {
  return {fmt::format("{}:{}:{}", name_, place.line, place.column), std::move(sentence)};
}

Result<std::string> read_file(const std::string& path) {
  std::error_code unknown;
  const auto status = std::filesystem::status(path, unknown);
  if (status.type() == std::filesystem::file_type::not_found)
    return Error{path, "there is no such file; expected a readable file"};
  if (std::filesystem::is_directory(status)) return Error{path, "is a folder; expected a readable file"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, "cannot be opened; expected a readable file"};
  std::ostringstream text;
  // Inserting the buffer of an empty file fails, although this is not a reading error.
  if (file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (file.bad() || text.fail()) return Error{path, "cannot be read; expected a readable file"};
  return text.str();
}

std::string_view without_byte_order_mark(std::string_view text) {
  return text.substr(0, 3) == "\xEF\xBB\xBF" ? text.substr(3) : text;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t limit = 60;
  const bool valid = compact(Json(std::string(text))).find("\xEF\xBF\xBD") == std::string::npos;
  std::string out = "'";
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const bool continues = (byte & 0xC0) == 0x80;
    if (at >= limit && !(valid && continues)) {
      out += "…";
      break;
    }
    if (byte < 0x20 || byte == 0x7F || (byte >= 0x80 && !valid))
      out += fmt::format("\\x{:02x}", byte);
    else
      out += text[at];
  }
  return out + "'";
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Rows of the distances between beginnings of a and of b: the one before the last, the last, and the present one.
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({last[j] + (a[i] != b[j]), row[j] + 1, last[j + 1] + 1});
      const bool exchanged = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (exchanged) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 200;  // bounds the work; real names are shorter
  const std::string* nearest = nullptr;
  std::size_t best = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const auto& candidate : known) {
    if (std::max(name.size(), candidate.size()) > longest) continue;
    const auto distance = edit_distance(name, candidate);
    // A distance of two between two short names is not a resemblance.
    const bool alike = 2 * distance <= std::max(name.size(), candidate.size());
    if (alike && distance < best) {
      best = distance;
      nearest = &candidate;
    }
  }
  return nearest ? fmt::format(" (did you mean {}?)", in_quotes(*nearest)) : std::string();
}

}  // namespace continua
