#include "continua/facts/affordances.h"

#include "continua/term/rules.h"
#include "continua/term/term_text.h"
#include "support/catch.h"

namespace continua {
namespace {

Catalogue catalogue_of(std::initializer_list<const char*> documents) {
  Catalogue catalogue;
  for (const auto* document : documents) {
    auto read = read_voxeme(document, "d.xml");
    if (!read) FAIL(read.error().text());
    INFO(document);
    CHECK(read->notes.empty());
    catalogue.add(std::move(read->voxeme));
  }
  return catalogue;
}

std::string object(const std::string& name, const std::string& inside) {
  return "<VoxML><Entity Type='Object'/><Lex><Pred>" + name + "</Pred></Lex>" + inside + "</VoxML>";
}

std::string formulas(std::initializer_list<const char*> all) {
  std::string text = "<Afford_Str><Affordances>";
  for (const auto* each : all) text += std::string("<Affordance Formula='") + each + "'/>";
  return text + "</Affordances></Afford_Str>";
}

std::string program(const std::string& name, const std::string& arguments, std::initializer_list<const char*> steps) {
  std::string text = "<VoxML><Entity Type='Program'/><Lex><Pred>" + name + "</Pred></Lex><Type><Args>" +
                     "<Arg Value='x:agent'/>" + arguments + "</Args><Body>";
  for (const auto* each : steps) text += std::string("<Subevent Value=\"") + each + "\"/>";
  return text + "</Body></Type></VoxML>";
}

const std::string y = "<Arg Value='y:physobj'/>", yz = y + "<Arg Value='z:location'/>";
const std::string movable = "<Embodiment><Movable>true</Movable></Embodiment>";
const std::string hollow =
    "<Type><Concavity>Concave[2]</Concavity></Type><Habitat><Intrinsic><Intr Name='UP[3]' Value='align(Y, E_y)'/>"
    "</Intrinsic><Extrinsic><Extr Name='UP[4]' Value='align(Y,E_y)'/><Extr Name='TOP[4]' Value='top(-Y)'/></Extrinsic>"
    "</Habitat>";

const Catalogue& small_catalogue() {
  static const Catalogue catalogue = catalogue_of({
      object("vase", hollow + movable +
                         formulas({"H[3]->[put(x, in([2]))]contain([2], x)", "H->[grasp(x, [1])]",
                                   "H[4]->[put(x, on([1]))]support([1], x)"}))
          .c_str(),
      object("tray", movable + formulas({"H->[put(x, on([1]))]support([1], x)", "H,hold(x, [1])->[lift([1])]"}))
          .c_str(),
      object("desk", formulas({"H->[put(x, on([1]))]support([1], x)"})).c_str(),
      object("pen", movable + formulas({"H->[grasp(x, [1])]hold(x, [1])", "H->[put([1], in(x))]contain(x, [1])]"}))
          .c_str(),
      program("grasp", y, {"grasp(x,y)"}).c_str(),
      program("lift", y, {"grasp(x,y)", "lift(x,y)"}).c_str(),
      program("move", yz, {"move(x,y,z)"}).c_str(),
      program("slide", yz, {"slide(x,y,z)"}).c_str(),
      program("put", yz, {"grasp(x,y)", "while(hold(x,y)^!at(y,z)):move(x,y,z)"}).c_str(),
      program("stack", yz, {"put(y,on(z))"}).c_str(),
      program("swap", yz, {"def(loc(y),as('l1'))", "put(y,near(z))", "put(z,l1)"}).c_str(),
      program("loop", y, {"loop2(x,y)"}).c_str(),
      program("loop2", y, {"loop(x,y)", "loop(x,y)"}).c_str(),
  });
  return catalogue;
}

ObjectState thing(const std::string& name, const std::string& type, bool with_interior = false) {
  ObjectState object;
  object.name = name;
  object.attributes["type"] = type;
  if (with_interior) object.interior = Box{{-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}};
  return object;
}

WorldSnapshot small_world() {
  WorldSnapshot world;
  world.objects = {thing("standing", "vase", true), thing("lying", "vase"), thing("tray", "tray"),
                   thing("desk", "desk"),           thing("pen", "pen"),    thing("rock", "rock")};
  return world;
}

std::string told(std::optional<bool> answer) { return !answer ? "unknown" : *answer ? "yes" : "no"; }

}  // namespace

TEST_CASE("an object affords what its voxeme's formulas say, in habitats that hold") {
  struct Row {
    const char *object, *what, *answer;
  };
  for (const auto& [object, what, answer] : {
           Row{"standing", "in", "yes"},
           Row{"lying", "in", "no"},
           Row{"standing", "on", "yes"},
           Row{"standing", "grasp", "yes"},
           Row{"lying", "grasp", "yes"},
           Row{"standing", "put", "no"},
           Row{"tray", "on", "yes"},
           Row{"tray", "lift", "yes"},
           Row{"tray", "grasp", "no"},
           Row{"pen", "in", "no"},
           Row{"pen", "put", "yes"},
           Row{"pen", "support", "no"},
           Row{"rock", "grasp", "unknown"},
       }) {
    INFO(object << " " << what);
    const auto world = small_world();
    CHECK(told(affords(*world.find(object), small_catalogue(), what)) == answer);
  }
}

TEST_CASE("what speaks against a program follows from its steps and the voxemes of its objects") {
  Signature names = term_signature();
  const auto world = small_world();
  for (const auto& each : world.objects) names.emplace(each.name, Type::entity());
  names.emplace("avatar", Type::entity());
  for (const auto* each : {"grasp", "lift", "reach", "loop"}) names.emplace(each, Type::parse("e -> t").value());
  for (const auto* each : {"put", "slide"}) names.emplace(each, Type::parse("e -> loc -> t").value());
  for (const auto* each : {"stack", "swap"}) names.emplace(each, Type::parse("e -> e -> t").value());
  for (const auto* each : {"in", "on", "near", "left"}) names.emplace(each, Type::parse("e -> loc").value());
  names.emplace("stop", Type::parse("t").value());
  struct Row {
    const char *program, *why;
  };
  for (const auto& [program, why] : {
           Row{"grasp(pen)", ""},
           Row{"grasp(desk)", "no_grasp"},
           Row{"lift(desk)", "immovable"},
           Row{"grasp(tray)", ""},  // affords lifting
           Row{"reach(desk)", ""},
           Row{"slide(desk, left(pen))", "immovable"},
           Row{"slide(pen, left(pen))", ""},
           Row{"put(pen, on(tray))", ""},
           Row{"put(pen, in(standing))", ""},
           Row{"put(pen, in(lying))", "wrong_habitat"},
           Row{"put(pen, in(tray))", "no_containment"},
           Row{"put(tray, on(pen))", "no_support"},
           Row{"put(tray, near(pen))", ""},
           Row{"put(standing, in(standing))", "itself"},
           Row{"put(rock, on(rock))", "itself"},
           Row{"put(rock, in(rock))", "itself"},
           Row{"put(rock, on(avatar))", ""},
           Row{"put(rock, <0, 0, 0>)", ""},
           Row{"put(desk, <0, 0, 0>)", "immovable"},
           Row{"stack(tray, pen)", "no_support"},
           Row{"stack(pen, tray)", ""},
           Row{"swap(pen, desk)", "immovable"},
           Row{"swap(pen, tray)", ""},
           Row{"loop(pen)", ""},
           Row{"stop", ""},
           Row{"\\x. grasp(x)", ""},
       }) {
    INFO(program);
    CHECK(name_of(obstacle(parse_term(program, names).value(), world, small_catalogue())) == why);
  }
}

}  // namespace continua
