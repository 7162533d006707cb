#include "continua/voxml/program_check.h"

#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

void add(Catalogue& catalogue, Voxeme::Entity entity, const char* name, std::vector<VoxemeArgument> arguments,
         const char* body = nullptr) {
  Voxeme voxeme;
  voxeme.entity = entity;
  voxeme.predicate = name;
  voxeme.path = std::string(name) + ".xml";
  voxeme.arguments = std::move(arguments);
  if (body) voxeme.body = parse_subevents(body).value();
  catalogue.add(std::move(voxeme));
}

// The problems of a program with these steps.
std::string wrong(const char* body) {
  const VoxemeArgument x{"x", "agent"}, y{"y", "physobj"}, z{"z", "location"};
  Catalogue catalogue;
  add(catalogue, Voxeme::Entity::relation, "at", {y, z});
  add(catalogue, Voxeme::Entity::relation, "near", {y, z});
  add(catalogue, Voxeme::Entity::relation, "hold", {x, y});
  add(catalogue, Voxeme::Entity::program, "grasp", {x, y}, "grasp(x,y)");
  add(catalogue, Voxeme::Entity::program, "go", {x, y, {"a", "T[]"}}, "go(x,y)");
  add(catalogue, Voxeme::Entity::program, "tried", {x, y, z}, body);
  std::string all;
  for (const auto& problem : check_programs(catalogue)) all += problem.text() + "\n";
  return all;
}

}  // namespace

TEST_CASE("Steps name programs and relations that exist, with as many arguments as they have") {
  CHECK(wrong("grasp(x,y);while(hold(x,y)^!at(y,z)):tried(x,y,z);if(at(y,z)):grasp(y);while(hold(y))").empty());
  CHECK(wrong("def(loc(y),as('l1'));tried(x,y,near(z));tried(y,loc(z));repeat(2,'grasp(y)')").empty());
  CHECK(wrong("go(x,y);go(x,y,z,'A.Plan',loc(y),z)").empty());
  CHECK(wrong("go()") == "tried.xml: 'go()': the program 'go' has 3 arguments\n");
  CHECK(wrong("grab(x,y)") == "tried.xml: 'grab(x, y)': there is no program 'grab'\n");
  CHECK(wrong("grasp(x,y,z)") == "tried.xml: 'grasp(x, y, z)': the program 'grasp' has 2 arguments\n");
  CHECK(wrong("grasp") == "tried.xml: 'grasp': there is no program 'grasp'\n");
  CHECK(wrong("while(hold(x,y)^!over(y,z)):grasp(x,y)") == "tried.xml: 'over(y, z)': there is no relation 'over'\n");
  CHECK(wrong("if(at(y)):grasp(y)") == "tried.xml: 'at(y)': the relation 'at' has 2 arguments\n");
  CHECK(wrong("tried(x,y,near(y,z))") == "tried.xml: 'near(y, z)': the relation 'near' has 2 arguments\n");
  CHECK(wrong("tried(x,y,over(z))") == "tried.xml: 'over(z)': there is no relation 'over'\n");
  CHECK(wrong("def(y)") == "tried.xml: 'def(y)': expected def(loc(y),as('l1'))\n");
  CHECK(wrong("repeat(2)") == "tried.xml: 'repeat(2)': expected repeat(2,'swap(y,z)')\n");
  CHECK(wrong("repeat(2,'grab(y)')") == "tried.xml: 'grab(y)': there is no program 'grab'\n");
  CHECK(wrong("repeat(2,\"repeat(2,'grasp(y)')\")") ==
        "tried.xml: 'repeat(2, 'grasp(y)')': repeats within what is repeated\n");
}

TEST_CASE("A program that points extends a finger and names the things that its vector meets, with their place") {
  const auto wrong = [](const char* body, const char* head = "assignment", const char* w = "physobj[]•location") {
    Voxeme point;
    point.entity = Voxeme::Entity::program;
    point.predicate = "point";
    point.path = "point.xml";
    point.head.name = head;
    point.arguments = {{"x", "agent"}, {"y", "finger"}, {"z", "location"}, {"w", w}};
    point.body = parse_subevents(body).value();
    Catalogue catalogue;
    catalogue.add(std::move(point));
    std::string all;
    for (const auto& problem : check_programs(catalogue)) all += problem.text() + "\n";
    return all;
  };
  CHECK(wrong("extend(x,y);def(vec(x->y×z),as(w))").empty());
  CHECK(wrong("extend(x);def(vec(x->y×z),as(w))") ==
        "point.xml: 'extend(x)': expected extend(x,y): the agent and the finger\n"
        "point.xml: 'def(vec(x -> y × z), as(w))': no step extends 'y'\n");
  CHECK(wrong("extend(x,y);def(vec(x->y×v),as(w))") ==
        "point.xml: 'vec(x -> y × v)': 'v' is no argument of the program\n");
  CHECK(wrong("extend(x,y);def(vec(x->y×z),as(w))", "assignment", "location") ==
        "point.xml: 'def(vec(x -> y × z), as(w))': 'w' has the type 'location', expected a compound such as "
        "physobj[]•location\n");
  CHECK(wrong("extend(x,y)", "transition") == "point.xml: 'extend(x, y)': there is no program 'extend'\n");
}

TEST_CASE("The project's own voxemes load without a note, and their programs name what exists") {
  const auto read = read_catalogue(source_dir() + "/engine/knowledge/voxemes");
  CHECK(read.documents > 0);
  for (const auto& problem : read.problems) FAIL_CHECK(problem.text());
  for (const auto& note : read.notes) FAIL_CHECK(note.text());
  for (const auto& problem : check_programs(read.catalogue)) FAIL_CHECK(problem.text());
}
