// Messages of ROS 2 from and to their bytes.
#include "continua/replay/mcap/ros_message.h"

#include <rapidcheck.h>

#include "support/catch.h"

namespace continua {
namespace {

RosDefinition definition_of(const std::string& type, const std::string& text) {
  auto definition = read_ros_definition(type, text);
  if (!definition) FAIL(definition.error().text());
  return *std::move(definition);
}

const std::string line = "================================================================================\n";

TEST_CASE("Constants, comments, defaults and limits are no members") {
  const auto definition = definition_of("p/msg/M", R"(# a comment
uint8 WAVING = 6 # another
string GREETING="hi"
uint8 gesture
string s "default"
string<=5[<=3] names
float64[2] pair
builtin_interfaces/Time stamp
Part part
)" + line + "MSG: p/Part\nint8 x\n");
  std::vector<std::string> names;
  for (const auto& member : definition.types.at("p/M")) names.push_back(member.type + " " + member.name);
  CHECK(names == std::vector<std::string>{"uint8 gesture", "string s", "string names", "float64 pair",
                                          "builtin_interfaces/Time stamp", "p/Part part"});
}

TEST_CASE("Definitions that are none are errors with their line") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"uint8", "the definition of p/M, line 1: found 'uint8'; expected a type and a name"},
      {"int8 a\nint8[0] b", "the definition of p/M, line 2: found the length '0'; expected 1 to 16777216"},
      {"int8[x] b", "the definition of p/M, line 1: found the length 'x'; expected 1 to 16777216"},
      {"Part p", "the definition of p/M, line 1: 'p/Part' is not defined"},
      {"M again", "the definition of p/M, line 1: found messages in messages, 20 and more deep"},
      {"wstring w", "the definition of p/M, line 1: 'p/wstring' is not defined"}};
  for (const auto& [text, expected] : cases) CHECK(read_ros_definition("p/M", text).error().text() == expected);
}

TEST_CASE("A message comes back from its bytes") {
  const auto definition = definition_of("p/M", R"(bool b
int64 i
string s
uint16[] list
float64[2] pair
Part[] parts
Nothing nothing
float32 f
)" + line + "MSG: p/Part\nstring name\nint16 x\n" + line +
                                                   "MSG: p/Nothing\n");
  const auto law = [&](bool b, std::int64_t i, const std::vector<std::uint16_t>& list, double x) {
    const auto s = std::string(*rc::gen::container<std::string>(rc::gen::inRange('a', 'z')));
    Json message{{"b", b},
                 {"i", i},
                 {"s", s},
                 {"list", list},
                 {"pair", {x, -x}},
                 {"parts", Json::array()},
                 {"nothing", Json::object()},
                 {"f", 0.5}};
    for (const auto each : list) message["parts"].push_back({{"name", s}, {"x", each % 1000}});
    const auto bytes = cdr_of_message(definition, message);
    const auto back = message_of_cdr(definition, bytes);
    RC_ASSERT(back.ok());
    RC_ASSERT(back.value() == message);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      RC_ASSERT_FALSE(message_of_cdr(definition, std::string_view(bytes).substr(0, size)).ok());
  };
  CHECK(rc::check(law));
}

// Bytes as other programs write them, one of them with the largest byte first.
TEST_CASE("Bytes of both orders are read") {
  const auto definition = definition_of("p/M", "uint8 a\nuint32 b\nstring s\nfloat64 d\n");
  const Json expected = {{"a", 1}, {"b", 258}, {"s", "hi"}, {"d", 1.0}};
  using namespace std::string_literals;
  CHECK(*message_of_cdr(definition, "\0\1\0\0\1\0\0\0\2\1\0\0\3\0\0\0hi\0\0\0\0\0\0\0\0\xf0\x3f"s) == expected);
  CHECK(*message_of_cdr(definition, "\0\0\0\0\1\0\0\0\0\0\1\2\0\0\0\3hi\0\0\x3f\xf0\0\0\0\0\0\0"s) == expected);
}

TEST_CASE("Bytes that are not the message are errors") {
  const auto definition = definition_of("p/M", "uint32[] list\n");
  using namespace std::string_literals;
  CHECK(message_of_cdr(definition, ""s).error().sentence == "the message of p/M does not begin as CDR does");
  CHECK(message_of_cdr(definition, "\0\3\0\0\0\0\0\0"s).error().sentence ==
        "the message of p/M does not begin as CDR does");
  CHECK(message_of_cdr(definition, "\0\1\0\0\xff\xff\xff\x7f"s).error().sentence ==
        "the message ends within the members of p/M: its 8 bytes are fewer than these take");
}

}  // namespace
}  // namespace continua
