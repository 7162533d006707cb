#include "composition/learning_file.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/located_json.h"
#include "term/substitution.h"

namespace continua {
namespace {

// As part of a JSON pointer (RFC 6901).
std::string escaped(const std::string& key) {
  std::string result;
  for (const char c : key) result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return result;
}

std::size_t count_while(const std::vector<Type>& types, std::size_t from, const Type& type) {
  std::size_t count = 0;
  while (from + count < types.size() && types[from + count] == type) ++count;
  return count;
}

// What is below the lambdas of a program.
bool is_list_of_acts(Term term) {
  while (term.kind() == Term::Kind::lambda) term = Term(term.body());
  return term.kind() == Term::Kind::list && !term.elements().empty() && term.elements().size() <= most_acts &&
         std::all_of(term.elements().begin(), term.elements().end(),
                     [](const Term& act) { return !act.is_null() && consistent(act.type(), Type::truth()); });
}

// Reads until the first problem.
class Reader {
 public:
  Reader(const LocatedJson& document, const Signature& names) : document_(document), names_(names) {}

  Result<Learned> read() {
    const Json& root = document_.root();
    if (!document_.duplicates().empty())
      fail(document_.duplicates().front().place,
           fmt::format("the key {} a second time in this object", in_quotes(document_.duplicates().front().key)));
    if (has_shape(root, "", "what was learned", {"learned", "gestures", "programs"}, "learned")) {
      if (root["learned"] != 1) fail("/learned", "found another version of the format, expected 1");
      read_programs(root);
      read_gestures(root);
    }
    if (error_) return *error_;
    return learned_;
  }

 private:
  // Programs may use one another: what their parameters are is found out first.
  void read_programs(const Json& root) {
    const auto texts = texts_of(root, "programs", "acts");
    for (const auto& [name, text] : texts) {
      if (names_.contains(name))
        fail("/programs/" + escaped(name), fmt::format("the name {} has another meaning", in_quotes(name)));
    }
    if (error_) return;
    for (const auto& [name, text] : texts) names_.insert_or_assign(name, Type::term());
    for (const bool types_are_known : {false, true})
      for (const auto& [name, text] : texts) {
        const auto at = "/programs/" + escaped(name) + "/acts";
        const auto term = read_term(text, at);
        if (!term) return;
        const Program program{*term};
        const auto types = program.parameters();
        const auto things = count_while(types, 0, Type::entity());
        const auto points = count_while(types, things, Type::location());
        if (things + points != types.size() || things > most_things || points > most_points || !is_list_of_acts(*term))
          return fail(at, fmt::format("found {}, expected acts such as \\x: e. \\v: loc. [grasp(x), put(x, v)]",
                                      in_quotes(text)));
        names_.insert_or_assign(name, program.type());
        if (!types_are_known) continue;
        if (const auto problem = learned_.learn_program(name, program)) return fail(at, problem->sentence);
      }
  }

  void read_gestures(const Json& root) {
    for (const auto& [name, text] : texts_of(root, "gestures", "means")) {
      const auto at = "/gestures/" + escaped(name) + "/means";
      const auto term = read_term(text, at);
      if (term && term->is_null()) fail(at, "found null, expected what the gesture means");
      if (term) learned_.gestures.emplace(name, *term);
    }
  }

  // Name and text of each member of root[kind].
  std::vector<std::pair<std::string, std::string>> texts_of(const Json& root, const char* kind, const char* key) {
    std::vector<std::pair<std::string, std::string>> texts;
    if (error_ || !root.contains(kind)) return texts;
    const std::string at = fmt::format("/{}", kind);
    if (!root[kind].is_object()) return fail(at, fmt::format("expected {}, an object", kind)), texts;
    for (const auto& [name, value] : root[kind].items()) {
      const auto pointer = at + "/" + escaped(name);
      if (name.empty()) fail(pointer, "found '', expected a name");
      if (!has_shape(value, pointer, "what is learned of a name", {key}, key)) return texts;
      if (!value[key].is_string()) return fail(pointer + "/" + key, "expected a term, a string"), texts;
      texts.emplace_back(name, value[key].get<std::string>());
    }
    return texts;
  }

  std::optional<Term> read_term(const std::string& text, const std::string& pointer) {
    auto known = names_;
    for (const auto& name : names_in(text)) known.emplace(name, Type::entity());
    const auto term = parse_term(text, known);
    if (term) return *term;
    constexpr std::string_view prefix = "column ";
    require(term.error().where.starts_with(prefix), "an error in a text names its column");
    fail(document_.place_in_text(pointer, std::stoul(term.error().where.substr(prefix.size())) - 1),
         term.error().sentence);
    return std::nullopt;
  }

  bool has_shape(const Json& json, const std::string& pointer, const char* what, const std::vector<std::string>& keys,
                 const char* required) {
    if (!json.is_object()) return fail(pointer, fmt::format("expected {}, an object", what)), false;
    for (const auto& [key, value] : json.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        fail(document_.key_place(pointer + "/" + escaped(key)),
             fmt::format("unknown key {} of {}{}", in_quotes(key), what, did_you_mean(key, keys)));
    if (!json.contains(required)) fail(pointer, fmt::format("there is no \"{}\" in {}", required, what));
    return !error_;
  }

  void fail(TextPlace place, std::string sentence) {
    if (!error_) error_ = document_.error(place, std::move(sentence));
  }
  void fail(const std::string& pointer, std::string sentence) { fail(document_.place(pointer), std::move(sentence)); }

  const LocatedJson& document_;
  Signature names_;
  Learned learned_;
  std::optional<Error> error_;
};

}  // namespace

Result<Learned> parse_learned(std::string_view text, const std::string& name, const Signature& names) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  return Reader(*document, names).read();
}

std::string print(const Program& program) {
  // As constants the variables print as their names, if nothing else is called so.
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
  for (const auto& [name, program] : learned.programs) programs[name] = {{"acts", print(program)}};
  const Json root{{"learned", 1}, {"gestures", std::move(gestures)}, {"programs", std::move(programs)}};
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace continua
