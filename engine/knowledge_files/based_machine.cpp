#include "continua/knowledge_files/based_machine.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "continua/core/located_json.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr const char* based_on = "based_on";
constexpr std::size_t most_bases = 8;  // one upon the other

/// A machine, and the places of its leaves by their pointers.
struct Whole {
  Json root;
  std::map<std::string, std::string> where;
};

// Members of objects one by one, anything else as a whole; null takes a member away.
void merge(Json& base, const Json& change) {
  for (const auto& [key, value] : change.items()) {
    if (value.is_null())
      base.erase(key);
    else if (value.is_object() && base.contains(key) && base[key].is_object())
      merge(base[key], value);
    else
      base[key] = value;
  }
}

// A transition takes the place of the one with its id, or stands after all. Gives their indices, in the order of the
// changes.
std::vector<std::size_t> merge_transitions(Json& base, const Json& changes) {
  std::vector<std::size_t> indices;
  for (const auto& change : changes) {
    const auto same = std::find_if(base.begin(), base.end(), [&](const Json& one) {
      return one.is_object() && change.is_object() && one.contains("id") && change.contains("id") &&
             one["id"] == change["id"];
    });
    indices.push_back(static_cast<std::size_t>(same - base.begin()));
    if (same == base.end())
      base.push_back(change);
    else
      *same = change;
  }
  return indices;
}

// "/transitions/0/when" of the changes as a pointer of the whole.
std::string in_whole(const std::string& pointer, const std::vector<std::size_t>& indices) {
  constexpr std::string_view list = "/transitions/";
  if (!pointer.starts_with(list)) return pointer;
  std::size_t index = 0;
  const auto rest = std::from_chars(pointer.data() + list.size(), pointer.data() + pointer.size(), index).ptr;
  if (index >= indices.size()) return pointer;
  return fmt::format("{}{}{}", list, indices[index], std::string_view(rest, pointer.data() + pointer.size()));
}

void apply(Whole& whole, const LocatedJson& changes) {
  Json rest = changes.root();
  std::vector<std::size_t> indices;
  if (rest.contains("transitions") && rest["transitions"].is_array() && whole.root.contains("transitions") &&
      whole.root["transitions"].is_array()) {
    indices = merge_transitions(whole.root["transitions"], rest["transitions"]);
    rest.erase("transitions");
  }
  rest.erase(based_on);
  merge(whole.root, rest);
  const Json leaves = changes.root().flatten();
  for (const auto& [pointer, value] : leaves.items()) whole.where[in_whole(pointer, indices)] = changes.where(pointer);
}

Result<Whole> whole_of(const LocatedJson& file, const std::string& path, const DataPaths& data,
                       std::vector<std::string>& above) {
  const auto doubled = file.duplicates();
  if (!doubled.empty())
    return file.error(doubled.front().place,
                      fmt::format("the key {} a second time in this object", in_quotes(doubled.front().key)));
  Whole whole{Json::object(), {}};
  if (const auto& root = file.root(); root.is_object() && root.contains(based_on)) {
    const auto pointer = std::string("/") + based_on;
    if (!root[based_on].is_string()) return file.error(pointer, "expected the name or the path of a machine");
    const auto base = resolve_machine(root[based_on], data, fs::path(path).parent_path(), file.where(pointer));
    if (!base) return base.error();
    above.push_back(fs::weakly_canonical(path).string());
    if (above.size() > most_bases || std::find(above.begin(), above.end(), fs::weakly_canonical(*base)) != above.end())
      return file.error(pointer, fmt::format("is based on itself, or on more than {} others", most_bases));
    const auto document = LocatedJson::read(*base);
    if (!document) return document.error();
    auto below = whole_of(*document, *base, data, above);
    if (!below) return below.error();
    whole = *std::move(below);
  }
  if (!file.root().is_object()) return file.error("", "expected a machine, a JSON object");
  apply(whole, file);
  return whole;
}

}  // namespace

Error BasedMachine::told(const Error& error, const std::string& path) const {
  const auto begin = path + ":";
  if (!error.where.starts_with(begin)) return error;
  std::size_t line = 0;
  std::from_chars(error.where.data() + begin.size(), error.where.data() + error.where.size(), line);
  const auto place = where.find(line);
  return {place == where.end() ? path : place->second, error.sentence};
}

Result<std::optional<BasedMachine>> based_machine(const std::string& text, const std::string& path,
                                                  const DataPaths& data) {
  const auto none = std::optional<BasedMachine>();
  if (text.find(based_on) == std::string::npos) return none;
  const auto file = LocatedJson::parse(text, path);
  if (!file || !file->root().is_object() || !file->root().contains(based_on)) return none;  // the loader tells
  std::vector<std::string> above;
  const auto whole = whole_of(*file, path, data, above);
  if (!whole) return whole.error();
  BasedMachine machine{whole->root.dump(1), {}};
  const auto document = LocatedJson::parse(machine.text, path);
  if (!document) return document.error();
  for (const auto& [pointer, where] : whole->where) machine.where[document->place(pointer).line] = where;
  return std::optional(std::move(machine));
}

}  // namespace continua
