// The sentences that a lexicon brings, and whether they are read as it says.
#include <fmt/format.h>

#include "language/lexicon_reader.h"
#include "language/parser.h"
#include "language/reduction.h"

namespace continua {
namespace {

WorldSnapshot scene_of(const Lexicon& lexicon) {
  WorldSnapshot world;
  world.objects = lexicon.sample;
  return world;
}

// What a reading's term still takes beside what words of its kind always take.
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

// What is wrong with the reading of an example, or nothing.
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

}  // namespace

void LexiconReader::read_sample() {
  each_section("sample", [&](const Item& section) {
    each_member(section, "attributes with their values", [&](const std::string& attribute, const Item& item) {
      for (const auto& value : texts_of(item, "values")) {
        ObjectState object;
        object.name = fmt::format("thing{}", lexicon_.sample.size() + 1);
        object.attributes.emplace(attribute, value);
        lexicon_.sample.push_back(std::move(object));
      }
    });
  });
}

void LexiconReader::read_examples() {
  const Vocabulary vocabulary(std::make_shared<const Lexicon>(lexicon_), scene_of(lexicon_));
  each_section("examples", [&](const Item& section) {
    each_element(section, "examples", [&](const Item& item) { read_example(item, vocabulary.names()); });
  });
}

void LexiconReader::read_example(const Item& item, const Signature& names) {
  if (!expect_object(item, "an example",
                     {"say", "reading", "readings", "fragments", "none", "move", "missing", "unknown", "about"}))
    return;
  LexiconExample example;
  example.where = item.document->where(item.pointer);
  const auto say = required(item, "say", "a sentence or a list of some");
  if (say.json && say.json->is_array())
    example.say = texts_of(say, "sentences");
  else
    example.say = {text_of(say, "a sentence or a list of some")};
  const auto term = [&](const Item& text) -> Term {
    if (!text.json->is_string()) return text_of(text, "a term"), Term();
    const auto read = parse_term(text.json->get<std::string>(), names);
    if (read) return normal(*read);
    return problem_in_text(text, read.error()), Term();
  };
  const auto terms = [&](const char* key) -> std::optional<std::vector<Term>> {
    const auto list = member(item, key);
    if (!list.json) return std::nullopt;
    std::vector<Term> all;
    each_element(list, "terms", [&](const Item& each) { all.push_back(term(each)); });
    return all;
  };
  if (const auto reading = member(item, "reading"); reading.json) example.reading = term(reading);
  example.readings = terms("readings");
  example.fragments = terms("fragments");
  if (truth_of(member(item, "none"), false)) example.fragments.emplace();
  if (const auto move = member(item, "move"); move.json) example.move = text_of(move, "a move");
  if (const auto missing = member(item, "missing"); missing.json) {
    example.missing.emplace();
    each_element(missing, "types", [&](const Item& each) { example.missing->push_back(read_type(each)); });
  }
  example.unknown = texts_of(member(item, "unknown"), "words");
  if (!example.reading && !example.readings && !example.fragments)
    problem(item, R"(there is none of "reading", "readings", "fragments" and "none"; expected one of them)");
  lexicon_.examples.push_back(std::move(example));
}

std::vector<Error> check_examples(const Lexicon& lexicon) {
  const Vocabulary vocabulary(std::make_shared<const Lexicon>(lexicon), scene_of(lexicon));
  std::vector<Error> errors;
  for (const auto& example : lexicon.examples)
    for (const auto& sentence : example.say)
      if (const auto wrong = fault(example, continua::read(sentence, vocabulary), lexicon); !wrong.empty())
        errors.push_back({example.where, fmt::format("'{}': {}", sentence, wrong)});
  return errors;
}

}  // namespace continua
