// Categories: their text, and which fit together.
#include "continua/language/category.h"

#include "support/catch.h"

using namespace continua;

namespace {

const Atoms& atoms() {
  static const Atoms all = {
      {"S", {{Type::truth()}, "V", false, false, {}}},
      {"NP", {{Type::entity(), Type::list(Type::entity())}, "N", true, true, {}}},
      {"N", {{Type::function(Type::entity(), Type::truth())}, "N", false, true, {"one", "many"}}}};
  return all;
}

Category category(const char* text) { return Category::parse(text, atoms()).value(); }
std::string error(const char* text) {
  const auto parsed = Category::parse(text, atoms());
  return parsed ? "read as " + parsed->text() : parsed.error().text();
}

// The result of `one` applied to `other`, when they are a function and its argument.
std::string made(const char* one, const char* other) {
  const auto function = category(one);
  Agreement agreement;
  return agreement.agree(function.argument(), category(other)) ? agreement.settled_one(function.result()).text() : "";
}

}  // namespace

TEST_CASE("a category is printed as it is read") {
  for (const char* text : {"S", "N[many]", "S/NP", "S\\NP/NP", "S/(S/NP)", "N\\*N", "N\\N\\(N\\N)/*(N\\N)"})
    CHECK(category(text).text() == text);
  CHECK(category("((S/NP))/(NP)") == category("S/NP/NP"));
  CHECK_FALSE(category("S/NP") == category("S\\NP"));
  CHECK_FALSE(category("S/NP") == category("S/*NP"));
  CHECK_FALSE(category("N") == category("N[one]"));
  CHECK(category("S/NP/N").size() == 3);
}

TEST_CASE("what is no category is told with its column") {
  CHECK(error("") == "column 1: found nothing more, expected a category");
  CHECK(error("S/Np") == "column 3: found 'Np', expected a category (did you mean 'N'?)");
  CHECK(error("S/(NP") == "column 6: found nothing more, expected )");
  CHECK(error("S NP") == "column 2: found ' NP', expected / or \\");
  CHECK(error("N[mani]") == "column 3: N has no feature 'mani' (did you mean 'many'?)");
  CHECK(error("N[many") == "column 7: found nothing more, expected ]");
  CHECK(error(std::string(100, '(').c_str()) == "column 34: parentheses nested deeper than 32");
  std::string wide = "S";
  for (int i = 0; i < 40; ++i) wide += "/S";
  CHECK_THAT(error(wide.c_str()), Catch::Contains("a category of more than 32 atoms"));
}

TEST_CASE("features agree, and an atom without one passes on what it meets") {
  CHECK(made("S/NP", "NP") == "S");
  CHECK(made("S/NP", "N") == "");
  CHECK(made("N/N", "N[many]") == "N[many]");
  CHECK(made("N/N", "N") == "N");
  CHECK(made("NP/N[one]", "N[many]") == "");
  CHECK(made("NP/N[one]", "N") == "NP");
  CHECK(made("N\\N/(N/N)", "N/N[many]") == "N[many]\\N[many]");
  CHECK(made("N/(N/N)", "N[one]/N[many]") == "");
}

TEST_CASE("atoms of different names settle their features apart") {
  Atoms german = atoms();
  german["N"].features = {"m", "f"};
  german["NP"].features = {"nom", "acc"};
  const auto read = [&](const char* text) { return Category::parse(text, german).value(); };
  const auto made = [&](const char* one, const char* other) {
    const auto function = read(one);
    Agreement agreement;
    return agreement.agree(function.argument(), read(other)) ? agreement.settled_one(function.result()).text() : "";
  };
  CHECK(made("NP/N", "N[m]") == "NP");
  CHECK(made("NP[acc]/N[m]", "N[m]") == "NP[acc]");
  CHECK(made("NP[acc]/N[m]", "N[f]") == "");
  CHECK(made("NP/N/(NP/N)", "NP[acc]/N[f]") == "NP[acc]/N[f]");
  CHECK(made("NP/N/(NP/NP)", "NP[acc]/NP[nom]") == "");
}

TEST_CASE("types follow from categories") {
  CHECK(type_of(category("S/N/NP"), atoms()).text() == "e -> (e -> t) -> t");
  CHECK(type_of(category("NP/NP"), atoms(), 1).text() == "e -> e*");
}

TEST_CASE("a category has the name and the number of the atom that remains of it") {
  const auto is_of = [](const Category& of, const char* name, std::size_t number) {
    CAPTURE(of.text());
    CHECK(of.target().text() == name);
    CHECK(of.target_number() == number);
  };
  is_of(category("N[many]"), "N", 0);
  is_of(category("NP/N/S"), "NP", 1);
  is_of(category("S\\(NP/N)"), "S", 2);
  is_of(Category::function(category("S/NP"), Category::Slash::backward, category("N")), "S", 2);
  Agreement agreement;
  CHECK(agreement.agree(category("N"), category("N[one]")));
  is_of(agreement.settled_one(category("N/NP")), "N", 0);
}
