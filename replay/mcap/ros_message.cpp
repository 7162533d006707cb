// Messages of ROS 2 from and to CDR: four bytes that tell the order of bytes, then the members, each number at a place
// that its size divides, counted from there.
#include "continua/replay/mcap/ros_message.h"

#include <fmt/format.h>

#include <algorithm>

#include "continua/replay/mcap/little_endian.h"

namespace continua {
namespace {

constexpr std::size_t head_bytes = 4;
constexpr std::string_view little_endian_head{"\0\1\0\0", head_bytes};

template <class Number>
Number reversed(Number number) {
  auto* bytes = reinterpret_cast<unsigned char*>(&number);
  std::reverse(bytes, bytes + sizeof number);
  return number;
}

// Calls `use` with a number of the type; false for a text or a message.
template <class Use>
bool with_number(const std::string& type, Use use) {
  if (type == "bool" || type == "byte" || type == "char" || type == "uint8") return use(std::uint8_t{}), true;
  if (type == "int8") return use(std::int8_t{}), true;
  if (type == "int16") return use(std::int16_t{}), true;
  if (type == "uint16") return use(std::uint16_t{}), true;
  if (type == "int32") return use(std::int32_t{}), true;
  if (type == "uint32") return use(std::uint32_t{}), true;
  if (type == "int64") return use(std::int64_t{}), true;
  if (type == "uint64") return use(std::uint64_t{}), true;
  if (type == "float32") return use(float{}), true;
  if (type == "float64") return use(double{}), true;
  return false;
}

class CdrReader {
 public:
  CdrReader(const RosDefinition& definition, std::string_view bytes)
      : definition_(definition), bytes_(bytes.substr(std::min(head_bytes, bytes.size()))), big_(bytes[1] == 0) {}

  Json message(const std::string& type) {
    Json json = Json::object();
    const auto& members = definition_.types.at(type);
    if (members.empty()) bytes_.number<std::uint8_t>();  // CDR has no empty messages
    for (const auto& member : members) json[member.name] = value(member);
    return json;
  }

  bool ok() const { return bytes_.ok(); }

 private:
  Json value(const RosMember& member) {
    if (member.many == RosMember::Many::one) return single(member.type);
    auto count = member.many == RosMember::Many::list ? number<std::uint32_t>() : member.count;
    Json list = Json::array();
    if (count > bytes_.left()) bytes_.view(bytes_.left() + 1);  // each takes a byte or more
    for (; count > 0 && ok(); --count) list.push_back(single(member.type));
    return list;
  }

  Json single(const std::string& type) {
    Json json;
    const bool is_number = with_number(type, [&](auto kind) { json = number<decltype(kind)>(); });
    if (is_number) return type == "bool" ? Json(json != 0) : json;
    if (type != "string") return message(type);
    const auto text = bytes_.view(number<std::uint32_t>());
    return std::string(text.substr(0, text.find('\0')));
  }

  template <class Number>
  Number number() {
    bytes_.view((sizeof(Number) - bytes_.at() % sizeof(Number)) % sizeof(Number));
    const auto read = bytes_.number<Number>();
    return big_ ? reversed(read) : read;
  }

  const RosDefinition& definition_;
  ByteReader bytes_;
  bool big_;
};

class CdrWriter {
 public:
  explicit CdrWriter(const RosDefinition& definition) : definition_(definition) {}

  void put_message(const std::string& type, const Json& json) {
    const auto& members = definition_.types.at(type);
    if (members.empty()) put(std::uint8_t{0});
    for (const auto& member : members) put_value(member, json.is_object() ? json.value(member.name, Json()) : Json());
  }

  std::string finish() { return std::string(little_endian_head) + bytes_; }

 private:
  void put_value(const RosMember& member, const Json& json) {
    if (member.many == RosMember::Many::one) return put_single(member.type, json);
    const auto there = json.is_array() ? json.size() : 0;
    if (member.many == RosMember::Many::list) put(static_cast<std::uint32_t>(there));
    const auto count = member.many == RosMember::Many::list ? there : member.count;
    for (std::size_t i = 0; i < count; ++i) put_single(member.type, i < there ? json[i] : Json());
  }

  void put_single(const std::string& type, const Json& json) {
    const auto put_as = [&](auto kind) {
      using Number = decltype(kind);
      put(json.is_number() ? json.get<Number>() : static_cast<Number>(json.is_boolean() && json.get<bool>()));
    };
    if (with_number(type, put_as)) return;
    if (type != "string") return put_message(type, json);
    const auto text = json.is_string() ? json.get<std::string>() : std::string();
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_ += text;
    bytes_ += '\0';
  }

  template <class Number>
  void put(Number number) {
    bytes_.append((sizeof(Number) - bytes_.size() % sizeof(Number)) % sizeof(Number), '\0');
    put_number(bytes_, number);
  }

  const RosDefinition& definition_;
  std::string bytes_;
};

}  // namespace

Result<Json> message_of_cdr(const RosDefinition& definition, std::string_view bytes) {
  if (bytes.size() < head_bytes || bytes[0] != 0 || (bytes[1] != 0 && bytes[1] != 1))
    return Error{"", fmt::format("the message of {} does not begin as CDR does", definition.type)};
  CdrReader reader(definition, bytes);
  auto json = reader.message(definition.type);
  if (!reader.ok())
    return Error{"", fmt::format("the message ends within the members of {}: its {} bytes are fewer than these take",
                                 definition.type, bytes.size())};
  return json;
}

std::string cdr_of_message(const RosDefinition& definition, const Json& message) {
  CdrWriter writer(definition);
  writer.put_message(definition.type, message);
  return writer.finish();
}

}  // namespace continua
