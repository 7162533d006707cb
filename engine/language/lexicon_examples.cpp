// The example sentences of a lexicon, checked against the readings that the lexicon expects.
#include <fmt/format.h>

#include "continua/language/lexicon_reader.h"
#include "continua/language/parser.h"
#include "continua/language/reduction.h"
#include "continua/language/spellings.h"
#include "continua/term/read_type.h"

namespace continua {
namespace {

// The words of a lexicon that outlives them, in a scene of its sample: a copy of it would take as long as its examples.
Vocabulary vocabulary_of(const Lexicon& lexicon) {
  WorldSnapshot world;
  world.objects = lexicon.sample;
  return Vocabulary(std::shared_ptr<const Lexicon>(std::shared_ptr<void>(), &lexicon), world);
}

// The types of the arguments that a reading's term lacks, the outermost first.
std::vector<Type> missing_of(const Reading& reading, const Lexicon& lexicon) {
  std::vector<Type> missing;
  const auto category = Category::parse(reading.category, lexicon.atoms).value();
  for (const auto* each = &category; !each->is_atom(); each = &each->result())
    missing.push_back(type_of(each->argument(), lexicon.atoms));
  return missing;
}

std::string listed(const std::vector<std::string>& texts) {
  std::string all;
  for (const auto& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all.empty() ? "nothing" : all;
}

std::string listed(const std::vector<Term>& terms) {
  std::vector<std::string> texts;
  for (const auto& term : terms) texts.push_back(print(with_nice_variables(term)));
  return listed(texts);
}

std::string listed(const std::vector<Type>& types) {
  std::vector<std::string> texts;
  for (const auto& type : types) texts.push_back(type.text());
  return listed(texts);
}

// The first difference between an example and its reading, as a sentence; empty if they are equal.
std::string fault(const LexiconExample& example, const Utterance& utterance, const Lexicon& lexicon) {
  std::vector<Term> first;
  for (const auto& fragment : utterance.fragments) first.push_back(fragment.readings.front().term);
  std::vector<std::string> unknown;
  for (const auto at : utterance.unknown) unknown.push_back(utterance.words[at]);
  if (unknown != example.unknown)
    return fmt::format("unknown words: {}, expected {}", listed(unknown), listed(example.unknown));
  if (!utterance.unused.empty()) return fmt::format("'{}' fits nowhere", utterance.words[utterance.unused.front()]);
  if (example.fragments)
    return first == *example.fragments
               ? ""
               : fmt::format("fragments: {}, expected {}", listed(first), listed(*example.fragments));
  if (first.size() != 1) return fmt::format("fragments: {}, expected one", listed(first));
  const auto& readings = utterance.fragments.front().readings;
  if (example.reading && first.front() != *example.reading)
    return fmt::format("read as {}, expected {}", listed(first), listed(std::vector{*example.reading}));
  if (example.readings) {
    std::vector<Term> all;
    for (const auto& reading : readings) all.push_back(reading.term);
    if (all != *example.readings)
      return fmt::format("readings: {}, expected {}", listed(all), listed(*example.readings));
  }
  if (example.move && readings.front().move != *example.move)
    return fmt::format("the move {}, expected {}", readings.front().move, *example.move);
  if (example.missing) {
    const auto missing = missing_of(readings.front(), lexicon);
    if (missing != *example.missing)
      return fmt::format("missing: {}, expected {}", listed(missing), listed(*example.missing));
  }
  return "";
}

Term read_example_term(const Item& item, const Signature& names) {
  const auto text = item.text("a term");
  if (!item.is_text()) return Term();
  const auto term = parse_term(text, names);
  if (term) return normal(*term);
  problem_with_quote(item, term.error());
  return Term();
}

std::optional<std::vector<Term>> read_example_terms(const Item& list, const Signature& names) {
  if (!list.exists()) return std::nullopt;
  std::vector<Term> terms;
  for (const auto& item : list.elements("terms")) terms.push_back(read_example_term(item, names));
  return terms;
}

LexiconExample read_example(const Item& item, const Signature& names) {
  LexiconExample example;
  example.where = item.where();
  constexpr const char* sentences = "a sentence or a list of some";
  const auto say = item.required("say", sentences);
  for (const auto& text : say.is_list() ? say.texts("sentences") : std::vector{say.text(sentences)})
    for (auto& sentence : spellings(text)) example.say.push_back(std::move(sentence));
  if (const auto reading = item.member("reading"); reading.exists())
    example.reading = read_example_term(reading, names);
  example.readings = read_example_terms(item.member("readings"), names);
  example.fragments = read_example_terms(item.member("fragments"), names);
  if (item.member("none").truth(false)) example.fragments.emplace();
  if (const auto move = item.member("move"); move.exists()) example.move = move.text("a move");
  if (const auto missing = item.member("missing"); missing.exists()) {
    example.missing.emplace();
    for (const auto& type : missing.elements("types")) example.missing->push_back(read_type(type));
  }
  example.unknown = item.member("unknown").texts("words");
  if (!example.reading && !example.readings && !example.fragments)
    item.problem(R"(there is none of "reading", "readings", "fragments" and "none"; expected one of them)");
  return example;
}

}  // namespace

void LexiconReader::read_sample() {
  for (const auto& [attribute, item] : members_of("sample", "attributes with their values"))
    for (const auto& value : item.texts("values")) {
      ObjectState object;
      object.name = fmt::format("thing{}", lexicon_.sample.size() + 1);
      object.attributes.emplace(attribute, value);
      lexicon_.sample.push_back(std::move(object));
    }
}

std::vector<LexiconExample> read_examples(const std::vector<LocatedJson>& documents, const Lexicon& lexicon,
                                          DocumentReader& reader) {
  const auto vocabulary = vocabulary_of(lexicon);
  std::vector<LexiconExample> examples;
  for (const auto& document : documents)
    for (const auto& item : reader.root(document).member("examples").elements("examples"))
      if (item.expect_object(
              "an example", {"say", "reading", "readings", "fragments", "none", "move", "missing", "unknown", "about"}))
        examples.push_back(read_example(item, vocabulary.names()));
  return examples;
}

std::vector<Error> check_examples(const std::vector<LexiconExample>& examples, const Lexicon& lexicon) {
  const auto vocabulary = vocabulary_of(lexicon);
  std::vector<Error> errors;
  for (const auto& example : examples)
    for (const auto& sentence : example.say)
      if (const auto wrong = fault(example, continua::read(sentence, vocabulary), lexicon); !wrong.empty())
        errors.push_back({example.where, fmt::format("'{}': {}", sentence, wrong)});
  return errors;
}

}  // namespace continua
