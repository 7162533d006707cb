#include "continua/core/named_values.h"

#include "support/catch.h"

using namespace continua;

namespace {

enum class Light { red, amber, green };
constexpr NamedValue<Light> lights[] = {{Light::red, "red"}, {Light::green, "green"}};

}  // namespace

TEST_CASE("one table prints and reads the values of an enum") {
  CHECK(name_in(lights, Light::green) == "green");
  CHECK(name_in(lights, Light::amber).empty());
  CHECK(value_in(lights, "red") == Light::red);
  CHECK_FALSE(value_in(lights, "Red"));
  CHECK(names_in(lights) == std::vector<std::string>{"red", "green"});
}
