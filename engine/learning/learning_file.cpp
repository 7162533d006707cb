#include "continua/learning/learning_file.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "continua/core/document_reader.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

std::size_t count_while(const std::vector<Type>& types, std::size_t from, const Type& type) {
  std::size_t count = 0;
  while (from + count < types.size() && types[from + count] == type) ++count;
  return count;
}

// Whether the body of a program, below its lambdas, is a list of one to `most_acts` acts.
bool is_list_of_acts(Term term) {
  while (term.kind() == Term::Kind::lambda) term = Term(term.body());
  return term.kind() == Term::Kind::list && !term.elements().empty() && term.elements().size() <= most_acts &&
         std::all_of(term.elements().begin(), term.elements().end(),
                     [](const Term& act) { return !act.is_null() && consistent(act.type(), Type::truth()); });
}

// A taught name and the text of its term.
struct Taught {
  std::string name;
  Item entry, term;
  std::string text;
};

class LearningReader {
 public:
  LearningReader(const DocumentReader& document, const Signature& names) : document_(document), names_(names) {}

  Learned read(const Item& root) {
    if (!root.expect_object("what was learned", {"learned", "gestures", "programs", "nouns"})) return learned_;
    root.expect_version("learned", 1);
    // Terms may use every taught name: if the names have problems, terms are not read.
    const auto programs = taught(root.member("programs"), "programs", {"acts", "word"});
    const auto gestures = taught(root.member("gestures"), "gestures", {"means", "shapes"});
    if (document_.sound()) read_programs(programs);
    if (document_.sound()) read_gestures(gestures);
    if (document_.sound()) read_nouns(taught(root.member("nouns"), "nouns", {"means"}));
    return learned_;
  }

 private:
  // The entries of the section that have a term; the first of their keys names the term.
  std::vector<Taught> taught(const Item& section, const char* what, const std::vector<std::string>& keys) {
    std::vector<Taught> all;
    for (const auto& [name, entry] : section.members(what)) {
      if (name.empty()) entry.problem_at_key("found '', expected a name");
      if (!entry.expect_object("what is learned of a name", keys)) continue;
      const auto term = entry.required(keys.front(), "a term");
      if (const auto text = term.name("a term"); !text.empty()) all.push_back({name, entry, term, text});
    }
    return all;
  }

  // Programs may use one another: a first pass finds the types of their parameters.
  void read_programs(const std::vector<Taught>& programs) {
    for (const auto& each : programs)
      if (names_.contains(each.name))
        each.entry.problem(fmt::format("the name {} has another meaning", in_quotes(each.name)));
    if (!document_.sound()) return;
    for (const auto& each : programs) names_.insert_or_assign(each.name, Type::term());
    for (const bool types_are_known : {false, true})
      for (const auto& each : programs)
        if (!read_program(each, types_are_known)) return;
  }

  // Returns false after a problem, because programs that use this one cannot be read then.
  bool read_program(const Taught& taught, bool types_are_known) {
    const auto term = read_term(taught);
    if (!term) return false;
    const auto word = taught.entry.member("word");
    const Program program{*term, word.exists() ? word.name("the word that was taught") : ""};
    const auto types = program.parameters();
    const auto things = count_while(types, 0, Type::entity());
    const auto points = count_while(types, things, Type::location());
    if (things + points != types.size() || things > most_things || points > most_points || !is_list_of_acts(*term))
      return taught.term.mismatch("acts such as \\x: e. \\v: loc. [grasp(x), put(x, v)]");
    names_.insert_or_assign(taught.name, program.type());
    if (!types_are_known) return true;
    const auto problem = learned_.learn_program(taught.name, program);
    if (problem) taught.term.problem(problem->sentence);
    return !problem;
  }

  void read_gestures(const std::vector<Taught>& gestures) {
    for (const auto& each : gestures) {
      const auto term = read_term(each);
      if (term && term->is_null()) each.term.problem("found null, expected what the gesture means");
      if (term) learned_.gestures.emplace(each.name, *term);
      for (const auto& shape : each.entry.member("shapes").elements("shapes")) read_shape(each.name, shape);
    }
  }

  void read_shape(const std::string& gesture, const Item& shape) {
    std::vector<double> numbers;
    for (const auto& number : shape.elements("numbers")) {
      if (number.json().is_number())
        numbers.push_back(number.json().get<double>());
      else
        number.mismatch("a number");
    }
    if (numbers.empty())
      shape.mismatch("a list of one number or more");
    else
      learned_.learn_shape(gesture, Shape(std::move(numbers)));
  }

  void read_nouns(const std::vector<Taught>& nouns) {
    static const auto condition = Type::function(Type::entity(), Type::truth());
    for (const auto& each : nouns) {
      const auto term = read_term(each);
      if (term && !consistent(term->type(), condition)) each.term.mismatch("a condition such as \\x. x = block1");
      if (term && consistent(term->type(), condition)) learned_.nouns.emplace(each.name, *term);
    }
  }

  // A name that is not declared is an object, perhaps of another scene.
  std::optional<Term> read_term(const Taught& taught) {
    auto known = names_;
    for (const auto& name : names_in(taught.text)) known.emplace(name, Type::entity());
    auto term = parse_term(taught.text, known);
    if (term) return *std::move(term);
    taught.term.problem_in_text(term.error());
    return std::nullopt;
  }

  const DocumentReader& document_;
  Signature names_;
  Learned learned_;
};

}  // namespace

Result<Learned> parse_learned(std::string_view text, const std::string& name, const Signature& names) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  DocumentReader reader;
  auto learned = LearningReader(reader, names).read(reader.root(*document));
  if (!reader.sound()) return reader.problems().front();
  return learned;
}

std::string print(const Program& program) {
  // The variables are printed as constants, with names that nothing else in the text has.
  std::string text;
  Term body = program.acts;
  while (body.kind() == Term::Kind::lambda) {
    const std::string hint = body.name().empty() ? "x" : body.name();
    std::string name = hint;
    for (int i = 1; contains(body, Term::entity(name)) || text.find("\\" + name + ":") != std::string::npos; ++i)
      name = fmt::format("{}{}", hint, i);
    text += fmt::format("\\{}: {}. ", name, body.variable_type().text());
    body = instantiate(body.body(), Term::constant(name, body.variable_type()));
  }
  return text + print(body);
}

std::string print_learned(const Learned& learned) {
  Json gestures = Json::object(), programs = Json::object();
  for (const auto& [name, meaning] : learned.gestures) gestures[name] = {{"means", print(meaning)}};
  for (const auto& [name, exemplars] : learned.shapes)
    for (const auto& shape : exemplars) gestures[name]["shapes"].push_back(shape.numbers());
  for (const auto& [name, program] : learned.programs) {
    programs[name] = {{"acts", print(program)}};
    if (!program.word.empty()) programs[name]["word"] = program.word;
  }
  Json root{{"learned", 1}, {"gestures", std::move(gestures)}, {"programs", std::move(programs)}};
  for (const auto& [name, condition] : learned.nouns) root["nouns"][name] = {{"means", print(condition)}};
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace continua
