// Definitions of ROS messages from their text.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>

#include "continua/replay/mcap/ros_message.h"

namespace continua {
namespace {

constexpr std::uint64_t longest_array = std::uint64_t{1} << 24;
constexpr int deepest_message = 20;  // messages within messages

const std::set<std::string, std::less<>> basic_types = {"bool",   "byte",    "char",    "int8",   "uint8",
                                                        "int16",  "uint16",  "int32",   "uint32", "int64",
                                                        "uint64", "float32", "float64", "string"};

class DefinitionReader {
 public:
  DefinitionReader(const std::string& type, std::string_view text)
      : text_(std::string(text)), message_(ros_type(type)) {
    definition_.type = message_;
    const std::vector<RosMember> time = {{"int32", "sec"}, {"uint32", "nanosec"}};
    definition_.types = {{"builtin_interfaces/Time", time}, {"builtin_interfaces/Duration", time}};
  }

  Result<RosDefinition> read() {
    definition_.types[message_];
    for (std::string line; std::getline(text_, line);) {
      ++number_;
      if (auto problem = read_line(line)) return *problem;
    }
    std::set<std::string> known;
    if (auto problem = check(definition_.type, 0, known)) return *problem;
    return std::move(definition_);
  }

 private:
  Error wrong(const std::string& sentence) const {
    return {fmt::format("the definition of {}, line {}", definition_.type, number_), sentence};
  }

  Outcome read_line(std::string line) {
    if (line.starts_with("====")) return std::nullopt;
    std::istringstream parts(line.substr(0, line.find('#')));
    std::string type, name, rest;
    parts >> type >> name >> rest;
    if (type == "MSG:") {
      message_ = ros_type(name);
      definition_.types[message_].clear();
      return std::nullopt;
    }
    const bool constant = name.find('=') != std::string::npos || rest.starts_with('=');  // uint8 WAVING = 6
    if (type.empty() || constant) return std::nullopt;
    if (name.empty()) return wrong(fmt::format("found {}; expected a type and a name", in_quotes(line)));
    return add_member(type, name);
  }

  Outcome add_member(std::string type, const std::string& name) {
    RosMember member;
    member.name = name;
    if (const auto bracket = type.find('['); bracket != std::string::npos) {
      const auto count = type.substr(bracket + 1, type.find(']') - bracket - 1);
      const auto read = std::from_chars(count.data(), count.data() + count.size(), member.count);
      const bool whole = read.ec == std::errc() && read.ptr == count.data() + count.size();
      const bool list = count.empty() || count.starts_with("<=");
      if (!list && (!whole || member.count == 0 || member.count > longest_array))
        return wrong(fmt::format("found the length {}; expected 1 to {}", in_quotes(count), longest_array));
      member.many = list ? RosMember::Many::list : RosMember::Many::exactly;
      type.resize(bracket);
    }
    type.resize(std::min(type.find("<="), type.size()));  // a text of limited length
    if (type == "time" || type == "duration")
      type = type == "time" ? "builtin_interfaces/Time" : "builtin_interfaces/Duration";
    if (type == "Header") type = "std_msgs/Header";
    member.type = basic_types.contains(type) ? type : full_name(type);
    definition_.types[message_].push_back(std::move(member));
    return std::nullopt;
  }

  // Names without a package are of the package of the message.
  std::string full_name(const std::string& type) const {
    if (type.find('/') != std::string::npos) return ros_type(type);
    return message_.substr(0, message_.find('/') + 1) + type;
  }

  // Whether all parts are defined, and none is part of itself.
  Outcome check(const std::string& type, int depth, std::set<std::string>& known) const {
    if (basic_types.contains(type) || known.contains(type)) return std::nullopt;
    const auto found = definition_.types.find(type);
    if (found == definition_.types.end()) return wrong(fmt::format("{} is not defined", in_quotes(type)));
    if (depth == deepest_message)
      return wrong(fmt::format("found messages in messages, {} and more deep", deepest_message));
    for (const auto& member : found->second)
      if (auto problem = check(member.type, depth + 1, known)) return problem;
    known.insert(type);
    return std::nullopt;
  }

  std::istringstream text_;
  std::size_t number_ = 0;
  std::string message_;  // whose members the lines are
  RosDefinition definition_;
};

}  // namespace

std::string ros_type(std::string_view name) {
  std::string type(name);
  if (const auto at = type.find("/msg/"); at != std::string::npos) type.erase(at, 4);
  return type;
}

Result<RosDefinition> read_ros_definition(const std::string& type, std::string_view text) {
  return DefinitionReader(type, text).read();
}

}  // namespace continua
