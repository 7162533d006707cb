#include "continua/voxml/catalogue.h"

#include <fmt/format.h>

#include "support/temporary_folder.h"
#include "term/law.h"

using namespace continua;

namespace {

// All that a document was read as, one line for each thing.
std::string told(const Result<ReadVoxeme>& read) {
  if (!read) return read.error().text() + "\n";
  const auto& v = read->voxeme;
  std::string out = fmt::format("{} {}", name_of(v.entity), v.predicate);
  if (!v.lex_type.empty()) out += " : " + v.lex_type;
  out += "\n";
  const auto of = [](const Numbered& n) { return n.name + (n.number.empty() ? "" : "#" + n.number); };
  if (!v.head.name.empty()) out += "head " + of(v.head) + "\n";
  for (const auto& each : v.components) out += "component " + of(each) + "\n";
  if (!v.concavity.name.empty()) out += "concavity " + of(v.concavity) + "\n";
  for (const auto& each : v.rotational_symmetry) out += "rotation " + each + "\n";
  for (const auto& each : v.reflectional_symmetry) out += "reflection " + each + "\n";
  for (const auto& each : v.arguments) out += "argument " + each.name + " : " + each.type + "\n";
  for (const auto& each : v.body) out += "step " + print(each) + "\n";
  if (v.spread) out += fmt::format("spread {} {}\n", v.spread->least_m, v.spread->per_metre_m);
  for (const auto& each : v.intrinsic) out += "intrinsic " + of(each.name) + " = " + each.value + "\n";
  for (const auto& each : v.extrinsic) out += "extrinsic " + of(each.name) + " = " + each.value + "\n";
  for (const auto& each : v.affordances) out += "affords " + print(each) + "\n";
  if (!v.scale.empty()) out += "scale " + v.scale + "\n";
  if (v.movable) out += "movable\n";
  for (const auto& each : v.attributes) out += "attribute " + each + "\n";
  for (const auto& [path, value] : v.others) out += path + " = " + value + "\n";
  for (const auto& note : read->notes) out += "note " + note.text() + "\n";
  return out;
}

std::string told(const std::string& document) { return told(read_voxeme(document, "d.xml")); }

std::string with(const std::string& parts) {
  return "<VoxML><Entity Type=\"Object\"/><Lex><Pred>bowl</Pred></Lex>" + parts + "</VoxML>";
}

// In UTF-16 with its mark, as bytes.
std::string utf16(const std::string& ascii, bool little) {
  std::string text = little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) text += little ? std::string{c, '\0'} : std::string{'\0', c};
  return text;
}

}  // namespace

TEST_CASE("An object's voxeme is read as it is published") {
  CHECK(told(R"x(<?xml version="1.0" encoding="us-ascii"?>
<VoxML xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:xsd="http://www.w3.org/2001/XMLSchema">
  <Entity Type="Object" />
  <Lex> <Pred>jug</Pred> <Type>physobj*artifact</Type> </Lex>
  <Type>
    <Head>cylindroid[1]</Head>
    <Components>
      <Component Value="surface[1]" /> <!-- the outside -->
      <Component Value="spout" />
      <Component Value="leg[3]+" />
    </Components>
    <Concavity>Concave[2]</Concavity>
    <RotatSym>Y</RotatSym>
    <ReflSym>XY, YZ</ReflSym>
    <Args /> <Body /> <Scale />
  </Type>
  <Habitat>
    <Intrinsic> <Intr Name="UP[3]" Value="align(Y,E_y)" /> <Intr Name="CONSTR[3]" Value="Y([1]) &lt;&lt; Z([1])" /> </Intrinsic>
    <Extrinsic> <Extr Name="TOP[4]" Value="top(-Y)" /> </Extrinsic>
  </Habitat>
  <Afford_Str>
    <Affordances>
      <Affordance Formula="H[3]-&gt;[put(x, in([2]))]contain([2], x)" />
      <!--<Affordance Formula="H-&gt;[kick(x)]" />-->
      <Affordance Formula="H->[put([1], in(x))]contain(x, [1])]" />
    </Affordances>
  </Afford_Str>
  <Embodiment> <Scale>&lt;agent</Scale> <Movable>true</Movable> </Embodiment>
  <Attributes> <Attrs> <Attr Value="blue" /> </Attrs> </Attributes>
</VoxML>)x") == R"x(object jug : physobj*artifact
head cylindroid#1
component surface#1
component spout
component leg+#3
concavity Concave#2
rotation Y
reflection XY
reflection YZ
intrinsic UP#3 = align(Y,E_y)
intrinsic CONSTR#3 = Y([1]) << Z([1])
extrinsic TOP#4 = top(-Y)
affords H[3]->[put(x, in([2]))]contain([2], x)
affords H->[put([1], in(x))]contain(x, [1])
scale <agent
movable
attribute blue
)x");
}

TEST_CASE("A program's voxeme may begin with a comment, and have its steps in one text") {
  CHECK(told(R"x(<!-- to try out -->
<?xml version="1.0" encoding="us-ascii"?>
<!DOCTYPE VoxML [ <!ELEMENT VoxML ANY> ]>
<v:VoxML xmlns:v="urn:v">
  <v:Type>
    <v:Body>
      <!--<Subevent Value="at(y,<1; 2; 3>)" />-->
      <v:Subevent Value="def(loc(y),as('l1'));put(y,near(z))" />
      <v:Subevent><![CDATA[at(y,z)->ungrasp(x,y)]]></v:Subevent>
    </v:Body>
    <v:Args> <v:Arg Value="x:agent" /> <v:Arg Value="y:physobj[]" /> <v:Arg Value="z" /> </v:Args>
  </v:Type>
  <v:Lex> <v:Pred>swap</v:Pred> </v:Lex>
  <v:Entity Type="program" />
</v:VoxML>)x") == R"x(program swap
argument x : agent
argument y : physobj[]
argument z : 
step def(loc(y), as('l1'))
step put(y, near(z))
step if(at(y, z)):ungrasp(x, y)
)x");
}

TEST_CASE("Relations, attributes and functions keep what they say as text") {
  CHECK(
      told("<VoxML><Entity Type='Relation'/><Lex><Pred>left</Pred></Lex><Type><Class>config</Class>"
           "<Value>'c[sl][bl]'</Value><Constr>X(x) &lt; X(y)</Constr><Corresps><!--<A(x)>--><Corresp Value=\"z:'x'\"/>"
           "<Corresp Value='reflexive'/></Corresps></Type></VoxML>") ==
      "relation left\nType/Class = config\nType/Constr = X(x) < X(y)\nType/Corresps/Corresp = z:'x'; reflexive\n"
      "Type/Value = 'c[sl][bl]'\n");
  CHECK(told("<VoxML><Entity Type='Attribute'/><Lex><Pred>red</Pred></Lex><Type><Scale>nominal</Scale>"
             "<Arity>intransitive</Arity></Type></VoxML>") ==
        "attribute red\nType/Arity = intransitive\nType/Scale = nominal\n");
  CHECK(told("<VoxML><Entity Type='Function'/><Lex><Pred>the</Pred></Lex><Type><Referent>x</Referent>"
             "<Mapping>n:1</Mapping></Type></VoxML>") == "function the\nType/Mapping = n:1\nType/Referent = x\n");
}

TEST_CASE("What a document has beyond VoxML is kept and told with its line") {
  CHECK(told(with("\n<Weight Unit='kg'>2</Weight>\n<Afford_Str><Affordances>\n<Affordance Formula='H-&gt;[grasp(x'/>"
                  "<Affordance Formula='H-&gt;grasp(x) ='/></Affordances></Afford_Str>"
                  "<Type><Body>\n<Subevent "
                  "Value='if(x)'/></Body></Type><Embodiment><Movable>perhaps</Movable></Embodiment>")) ==
        R"x(object bowl
affords H->[grasp(x)]
Afford_Str/Affordances/Affordance = H->grasp(x) =
Type/Body/Subevent = if(x)
Weight = 2
Weight/Unit = kg
note d.xml:2: the attribute Unit of <Weight> is unknown
note d.xml:2: the element <Weight> is unknown
note d.xml:4: 'H->grasp(x) =' cannot be read: character 13: found '=', expected a name
note d.xml:5: 'if(x)' cannot be read: character 6: found the end, expected ':' and what happens then
note d.xml:5: found 'perhaps', expected true or false
)x");
}

TEST_CASE("What is no voxeme is refused with its line") {
  CHECK(told("") == "d.xml:1: not valid XML: No document element found\n");
  CHECK(told("<VoxML>\n<Lex></VoxML>") == "d.xml:2: not valid XML: Start-end tags mismatch\n");
  CHECK(told("\n<mujoco/>") == "d.xml:2: found the root <mujoco>, expected <VoxML>\n");
  CHECK(told("<VoxML><Lex><Pred>x</Pred></Lex></VoxML>") ==
        "d.xml:1: there is no Entity, expected <Entity Type=\"Object\" /> or another type\n");
  CHECK(told("<VoxML>\n\n<Entity Type='Thing'/></VoxML>") ==
        "d.xml:3: found the entity 'Thing', expected Object, Program, Attribute, Relation or Function\n");
  CHECK(told("<VoxML>\n\xE4</VoxML>") == "d.xml:2: found the byte 0xe4, expected XML in UTF-8\n");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  CHECK(told(with(deep)) == "d.xml:1: elements more than 100 deep\n");
}

TEST_CASE("A voxeme whose predicate is empty or missing has the name of its file") {
  for (const char* lex : {"<Lex><Pred/></Lex>", "<Lex>\n<Pred> </Pred></Lex>", ""}) {
    const auto read = read_voxeme(fmt::format("<VoxML><Entity Type='Object'/>{}</VoxML>", lex), "objects/jug.xml");
    REQUIRE(read.ok());
    CHECK(read->voxeme.predicate == "jug");
    REQUIRE(read->notes.size() == 1);
    CHECK(read->notes[0].text() ==
          "objects/jug.xml:1: there is no predicate in <Lex><Pred>; the file's name is taken: 'jug'");
  }
}

TEST_CASE("Documents are read in the encodings that they are published in") {
  const std::string plain = with("");
  CHECK(told(plain) == "object bowl\n");
  CHECK(told("\xEF\xBB\xBF" + plain) == "object bowl\n");
  CHECK(told(utf16("<?xml version='1.0' encoding='utf-16'?>" + plain, true)) == "object bowl\n");
  CHECK(told(utf16(plain, false)) == "object bowl\n");
  CHECK(told("<?xml version='1.0' encoding='ISO-8859-1'?>"
             "<VoxML><Entity Type='Object'/><Lex><Pred>sch\xFCssel</Pred></Lex></VoxML>") == "object schüssel\n");
  CHECK(looks_like_voxeme("<!-- <a> --><?xml version='1.0'?>\n<v:VoxML>"));
  CHECK(looks_like_voxeme(utf16(plain, true)));
  CHECK_FALSE(looks_like_voxeme("<mujoco>"));
  CHECK_FALSE(looks_like_voxeme("VoxML"));
}

TEST_CASE("A damaged document is read or refused, never more") {
  const std::string document = with(R"x(<Type><Head>a[1]</Head><Body><Subevent Value="while(a):b"/></Body></Type>
<Habitat><Intrinsic><Intr Name="UP[3]" Value="x"/></Intrinsic></Habitat><!-- c -->)x");
  law("damage", [document] {
    auto damaged = document;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
      damaged[*rc::gen::inRange<std::size_t>(0, damaged.size())] = *rc::gen::arbitrary<char>();
    damaged.resize(*rc::gen::inRange<std::size_t>(damaged.size() / 2, damaged.size() + 1));
    const auto read = read_voxeme(damaged, "d.xml");
    if (read)
      RC_ASSERT(!read->voxeme.predicate.empty());
    else
      RC_ASSERT(read.error().where.starts_with("d.xml:") && !read.error().sentence.empty());
  });
}

TEST_CASE("A folder's documents are read in the order of their paths, and later ones win") {
  TemporaryFolder folder;
  const auto path = folder.path().string();
  folder.file("a/one.xml", with("<Embodiment><Scale>agent</Scale></Embodiment>"));
  folder.file("b/one.xml", with("<Embodiment><Movable>true</Movable></Embodiment>"));
  folder.file("b/bad.xml", "<VoxML/>");
  folder.file("b/readme.md", "no document");
  const auto read = read_catalogue(path);
  CHECK(read.documents == 2);
  REQUIRE(read.problems.size() == 1);
  CHECK(read.problems[0].where == path + "/b/bad.xml:1");
  REQUIRE(read.notes.size() == 1);
  CHECK(read.notes[0].text() == fmt::format("{0}/b/one.xml: the object 'bowl' replaces that of {0}/a/one.xml", path));
  const auto* bowl = read.catalogue.for_object("bowl7", "bowl");
  REQUIRE(bowl);
  CHECK(bowl->movable);
  CHECK(bowl->scale.empty());
  CHECK(read.catalogue.for_object("bowl", "cup") == bowl);
  CHECK(read.catalogue.for_object("cup", "cup") == nullptr);
  CHECK(read.catalogue.find(Voxeme::Entity::program, "bowl") == nullptr);

  TemporaryFolder same;
  same.file("a/one.xml", with("<Embodiment><Scale>agent</Scale></Embodiment>"));
  CHECK(read_catalogue(same.path().string()).catalogue.digest() != read.catalogue.digest());
  same.file("b/one.xml", with("<Embodiment><Movable>true</Movable></Embodiment>"));
  CHECK(read_catalogue(same.path().string()).catalogue.digest() == read.catalogue.digest());
  CHECK(read_catalogue(path + "/none").documents == 0);
  CHECK(read_catalogue(path + "/none").catalogue.digest().empty());
}

TEST_CASE("the spread of a vector is read in metres, another value is a note") {
  CHECK(told(with("<Type><Spread Least='0.024' PerMetre='0.03'/></Type>")) == told(with("")) + "spread 0.024 0.03\n");
  CHECK(told(with("<Type><Spread Least='0.02'/></Type>")) == told(with("")) + "spread 0.02 0\n");
  CHECK(told(with("<Type><Spread Least='2 cm'/></Type>")) ==
        told(with("")) + "note d.xml:1: found '2 cm', expected metres, such as 0.024\n");
}
