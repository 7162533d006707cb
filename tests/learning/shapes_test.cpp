// Taught gestures recognised by their shape.
#include "continua/learning/shapes.h"

#include "continua/learning/learning_file.h"
#include "support/catch.h"

using namespace continua;
using Verdict = Recognition::Verdict;

namespace {

Learned taught(const std::vector<std::tuple<std::string, std::string, std::vector<double>>>& lessons) {
  Learned learned;
  for (const auto& [gesture, object, shape] : lessons) {
    learned.gestures.insert_or_assign(gesture, Term::entity(object));
    if (!shape.empty()) learned.learn_shape(gesture, Shape(shape));
  }
  return learned;
}

constexpr ShapeLimits limits{0.4, 0.25};

}  // namespace

TEST_CASE("the nearest exemplar decides within the limit") {
  const auto learned = taught({{"a", "cup", {1, 0}}, {"b", "knife", {0, 1}}});
  const auto found = recognise(Shape({0.1, 0.9}), learned, limits);
  CHECK(found.verdict == Verdict::recognised);
  CHECK(found.nearest->gesture == "b");
  CHECK(found.rival->gesture == "a");
  CHECK(recognise(Shape({-1, 0.1}), learned, limits).verdict == Verdict::too_far);
  CHECK(recognise(Shape({1, 0}), Learned(), limits).verdict == Verdict::nothing_known);
}

TEST_CASE("a shape between two meanings is contested, between two exemplars of one it is not") {
  const std::vector<double> a = {1, 0}, b = {1, 0.3}, middle = {1, 0.15};
  CHECK(recognise(Shape(middle), taught({{"a", "cup", a}, {"b", "knife", b}}), limits).verdict == Verdict::contested);
  CHECK(recognise(Shape(middle), taught({{"a", "cup", a}, {"b", "cup", b}}), limits).verdict == Verdict::recognised);
  CHECK(recognise(Shape(b), taught({{"a", "cup", a}, {"b", "knife", b}}), limits).nearest->gesture == "b");
  CHECK(recognise(Shape(a), taught({{"a", "cup", a}, {"b", "knife", a}}), limits).verdict == Verdict::contested);
}

TEST_CASE("shapes of other lengths are not compared, but counted") {
  const auto found = recognise(Shape({1, 0, 0}), taught({{"a", "cup", {1, 0}}, {"b", "knife", {0, 1}}}), limits);
  CHECK(found.verdict == Verdict::nothing_known);
  CHECK(found.of_other_length == 2);
  CHECK(found.reason == "no shape of 3 numbers was taught; 2 known shapes of other lengths are not compared");
}

TEST_CASE("exemplars of one meaning that are alike are forgotten together") {
  const auto learned =
      taught({{"a", "cup", {1, 0}}, {"b", "cup", {1, 0.1}}, {"c", "cup", {0, 1}}, {"d", "knife", {1, 0.05}}});
  CHECK(of_one_shape("a", learned, limits) == std::vector<std::string>{"a", "b"});
  CHECK(of_one_shape("x", learned, limits) == std::vector<std::string>{"x"});
}

TEST_CASE("an unnamed gesture gets a name that is free, and the same shape the same name") {
  ShownShapes shown;
  const auto learned = taught({{"shape_1", "cup", {1, 0}}});
  const auto taken = [](std::string_view name) { return name == "shape_2"; };
  CHECK(shown.name_for(Shape({1, 0}), learned, taken) == "shape_1");
  CHECK(shown.name_for(Shape({0, 1}), learned, taken) == "shape_3");
  shown.add("shape_3", Shape({0, 1}));
  CHECK(shown.name_for(Shape({0, 1}), learned, taken) == "shape_3");
  CHECK(shown.find("shape_3") == Shape({0, 1}));
  CHECK(shown.find("shape_4").empty());
  for (std::size_t i = 0; i < ShownShapes::most; ++i)
    shown.add(std::to_string(i), Shape({0, 0, 1.0 * static_cast<double>(i)}));
  CHECK(shown.find("shape_3").empty());
}

TEST_CASE("exemplars are kept in the file of what was learned") {
  const auto learned = taught({{"a", "cup", {1, 0.25}}, {"b", "knife", {}}});
  const auto text = print_learned(learned);
  const auto again = parse_learned(text, "l.json", term_signature());
  REQUIRE(again);
  CHECK(*again == learned);
  const auto error = [](const std::string& shapes) {
    const auto bad = parse_learned(R"({"learned":1,"gestures":{"a":{"means":"cup","shapes":)" + shapes + "}}}",
                                   "l.json", term_signature());
    return bad ? std::string() : bad.error().text();
  };
  CHECK(error("[[]]") == "l.json:1:55: found a list, expected a list of one number or more");
  CHECK(error(R"([["x"]])") == "l.json:1:55: found a list, expected a list of one number or more");
}
