#include "continua/knowledge_files/deictic_program.h"

#include "continua/term/term_text.h"
#include "support/catch.h"

using namespace continua;

namespace {

// The program of a document with these arguments and steps.
Result<std::optional<DeicticProgram>> program(const std::string& arguments, const std::string& steps,
                                              const std::string& more = "") {
  std::string text = "<VoxML><Entity Type='Program'/><Lex><Pred>point</Pred></Lex><Type><Head>assignment</Head><Args>";
  for (const auto& each : {std::string("x:agent"), std::string("y:finger"), std::string("z:location")})
    text += "<Arg Value='" + each + "'/>";
  text += "<Arg Value='" + arguments + "'/></Args><Body><Subevent Value='" + steps + "'/></Body>" + more;
  Catalogue catalogue;
  catalogue.add(read_voxeme(text + "</Type></VoxML>", "point.xml").value().voxeme);
  return deictic_program(catalogue);
}

const char* const steps = "extend(x,y);def(vec(x->y×z),as(w))";

std::string wrong(const Result<std::optional<DeicticProgram>>& read) { return read ? "none" : read.error().text(); }

}  // namespace

TEST_CASE("[[point]] is a function from agent, finger, spread and place to things and the place") {
  const auto read = program("w:physobj[]•location", steps, "<Spread Least='0.02' PerMetre='0.03'/>");
  REQUIRE(read);
  REQUIRE(*read);
  const DeicticProgram& point = **read;
  CHECK(print(point.function) == "\\x y sd z. dot(met(vec(x, y, z), sd), z)");
  CHECK(point.function.type().text() == "e -> e -> num -> loc -> e* • loc");
  CHECK(point.sd_m(std::nullopt) == 0.02);
  CHECK(point.sd_m(0.5) == 0.02);
  CHECK(point.sd_m(2) == 0.06);
  const auto applied = application_of(point, "right", 0.06, {0.1, 0.2, 0}, {"plate", "knife"});
  CHECK(print(applied.function) == "\\z. dot(met(vec(human, right_finger, z), 0.06), z)");
  CHECK(applied.function.type().text() == "loc -> e* • loc");
  CHECK(print(applied.result) == "dot([plate, knife], <0.1, 0.2, 0>)");
  CHECK(applied.result.type() == Type::pointing());
}

TEST_CASE("a document of [[point]] that says something else is an error, and none is no program") {
  CHECK(wrong(program("w:location", steps)) == "point.xml: 'w' has the type 'location', expected physobj[]•location");
  CHECK(wrong(program("w:physobj[]•location", "extend(x,y)")) ==
        "point.xml: no step defines what is pointed at, expected def(vec(x -> y × z),as(w))");
  CHECK(wrong(program("w:physobj[]•location", "extend(x,y);def(vec(z->y×x),as(w))")) ==
        "point.xml: 'z' in 'vec(z -> y × x)' has the type 'location', expected agent");
  CHECK(wrong(program("w:physobj[]•location", steps, "<Spread Least='0'/>")) ==
        "point.xml: its Spread has a Least of 0 m, expected more");
  const auto none = deictic_program(Catalogue());
  REQUIRE(none);
  CHECK_FALSE(*none);
}
