#include "continua/simulation/scene_source.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/simulation/mjcf_tags.h"

namespace continua {

namespace {

constexpr auto npos = std::string_view::npos;

// Far beyond what a table full of objects takes.
constexpr std::pair<const char*, int> most_of_sizes[] = {
    {"njmax", 200'000},     {"nconmax", 100'000}, {"nstack", 100'000'000}, {"nuserdata", 100'000},
    {"nkey", 1000},         {"nuser_body", 1000}, {"nuser_jnt", 1000},     {"nuser_geom", 1000},
    {"nuser_site", 1000},   {"nuser_cam", 1000},  {"nuser_tendon", 1000},  {"nuser_actuator", 1000},
    {"nuser_sensor", 1000},
};

}  // namespace

Result<SceneSource> SceneSource::read(const std::string& path) {
  SceneSource source;
  source.path_ = path;
  std::vector<std::string> open_files;
  if (auto wrong = source.expand(path, open_files)) return *wrong;
  if (auto wrong = source.check_sizes()) return *wrong;
  source.drop_keyframes();
  return source;
}

void SceneSource::drop_keyframes() {
  std::optional<std::size_t> begin;
  for (auto tag = next_tag(text_, 0); tag; tag = next_tag(text_, tag->end)) {
    if (tag->name == "keyframe" && !begin) begin = tag->begin;
    if (tag->name == "key")
      keyframes_.push_back({where(line_of(text_, tag->begin)), value_of(text_, *tag, "name").value_or(""),
                            value_of(text_, *tag, "qpos").value_or("")});
    const bool closed = tag->name == "/keyframe" || (tag->name == "keyframe" && tag->self_closing);
    if (!begin || !closed) continue;
    make_blank(text_, *begin, tag->end);
    begin.reset();
  }
}

// MuJoCo allocates what an element <size> asks for, before it looks at anything else.
Outcome SceneSource::check_sizes() const {
  for (auto tag = next_tag(text_, 0); tag; tag = next_tag(text_, tag->end)) {
    if (tag->name != "size") continue;
    for (const auto& [name, most] : most_of_sizes) {
      const auto value = value_of(text_, *tag, name);
      // Anything but a number is MuJoCo's to refuse.
      const double asked = value ? std::strtod(value->c_str(), nullptr) : 0;
      if (asked > most)
        return Error{where(line_of(text_, tag->begin)),
                     fmt::format("{} is \"{}\"; expected at most {}", name, *value, most)};
    }
  }
  return std::nullopt;
}

// The scene's own file keeps its root element; an included file contributes only the root's content.
Outcome SceneSource::expand(const std::string& file, std::vector<std::string>& open_files) {
  auto read = read_file(file);
  if (!read) return read.error();
  if (text_.size() + read->size() > most_bytes)
    return Error{file, fmt::format("makes the scene longer than {} bytes, with all that it includes", most_bytes)};
  const std::string_view text = *read;
  const auto root = next_tag(text, 0);
  if (!root || root->name.substr(0, 6) != "mujoco")
    return Error{file + ":1", "expected an MJCF file, whose outermost element is <mujoco>"};
  open_files.push_back(file);

  const bool included = open_files.size() > 1;
  const std::size_t close = text.rfind("</mujoco");
  std::size_t from = included ? root->end : 0;
  const std::size_t end = !included ? text.size() : close == npos || close < from ? from : close;

  const auto copy = [&](std::size_t begin, std::size_t stop) {
    int line = line_of(text, begin);
    for (const char letter : text.substr(begin, stop - begin)) {
      if (lines_.empty() || text_.back() == '\n') lines_.push_back({file, line});
      text_ += letter;
      line += letter == '\n';
    }
  };

  for (auto tag = next_tag(text, root->end); tag && tag->begin < end; tag = next_tag(text, tag->end)) {
    if (tag->name != "include") continue;
    const std::string here = fmt::format("{}:{}", file, line_of(text, tag->begin));
    const auto name = value_of(text, *tag, "file");
    if (!name || !tag->self_closing) return Error{here, "expected <include file=\"…\"/>"};
    const auto path = (std::filesystem::path(file).parent_path() / *name).lexically_normal().string();
    if (std::find(open_files.begin(), open_files.end(), path) != open_files.end())
      return Error{here, fmt::format("'{}' includes itself", *name)};
    if (++inclusions_ > most_inclusions)
      return Error{
          here, fmt::format("is the scene's inclusion number {}; expected at most {}", inclusions_, most_inclusions)};
    copy(from, tag->begin);
    if (auto wrong = expand(path, open_files)) {
      if (wrong->where == path) return Error{here, fmt::format("cannot include '{}': {}", *name, wrong->sentence)};
      return wrong;
    }
    from = tag->end;
  }
  copy(from, end);
  open_files.pop_back();
  return std::nullopt;
}

std::string SceneSource::where(int line) const {
  if (line < 1 || static_cast<std::size_t>(line) > lines_.size()) return path_;
  const Line& origin = lines_[static_cast<std::size_t>(line) - 1];
  return fmt::format("{}:{}", origin.file, origin.number);
}

std::string SceneSource::where(std::string_view name, std::string_view attribute_name) const {
  std::string found = path_;
  for (auto tag = next_tag(text_, 0); tag; tag = next_tag(text_, tag->end))
    if (tag->name == name && attribute_of(text_, *tag, attribute_name)) found = where(line_of(text_, tag->begin));
  return found;
}

SceneSource SceneSource::with(std::string_view elements) const {
  SceneSource more = *this;
  const std::size_t end = text_.rfind("</mujoco");
  if (end != npos) more.text_.insert(end, elements);
  return more;
}

SceneSource SceneSource::with_changes(std::vector<Change> changes) const {
  SceneSource changed = *this;
  std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.begin > b.begin; });
  for (const auto& change : changes) changed.text_.replace(change.begin, change.end - change.begin, change.text);
  return changed;
}

SceneSource SceneSource::without_body(std::string_view name) const {
  SceneSource rest = *this;
  std::optional<std::size_t> begin;
  int depth = 0;
  for (auto tag = next_tag(text_, 0); tag; tag = next_tag(text_, tag->end)) {
    if (tag->name == "body") {
      const auto found = value_of(text_, *tag, "name");
      if (!begin && found && *found == name) begin = tag->begin;
      if (begin && !tag->self_closing) ++depth;
    } else if (begin && tag->name == "/body") {
      --depth;
    }
    if (!begin || depth > 0) continue;
    make_blank(rest.text_, *begin, tag->end);
    break;
  }
  return rest;
}

}  // namespace continua
