#include "continua/replay/recogniser/speech_grammar.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "continua/language/parser.h"
#include "continua/language/vocabulary.h"

namespace continua {
namespace {

// Sentences of an example that are read: the others are its synonyms, which other examples have too.
constexpr std::size_t most_read = 2;
// Longer entries are turns of phrase, of which a lexicon may have thousands: they would fill the grammar, and be heard
// in place of what was said.
constexpr std::size_t longest_entry = 2;
// A word that examples have so much less often than the commonest of its category is a rare one, or slang.
constexpr double least_share = 0.02;

/// A step of a pattern: a category, or words that are passed over.
struct Step {
  bool is_category = false;
  std::string text;
  auto operator<=>(const Step&) const = default;
};
using Pattern = std::vector<Step>;

// A token of JSGF that needs no quotation marks, and no comma, which nobody says.
bool is_token(std::string_view word) {
  return !word.empty() && word.find_first_of(" ,;=|*+<>()[]{}/\\\".:") == std::string_view::npos;
}

// The lexicon without the values of attributes that nothing in the world has.
std::shared_ptr<const Lexicon> of_world(const Lexicon& lexicon, const WorldSnapshot& world) {
  auto own = std::make_shared<Lexicon>(lexicon);
  for (auto& attribute : own->attributes)
    std::erase_if(attribute.values, [&](const std::vector<std::string>& group) {
      return std::none_of(world.objects.begin(), world.objects.end(), [&](const ObjectState& object) {
        const auto value = object.attributes.find(attribute.name);
        return value != object.attributes.end() && std::find(group.begin(), group.end(), value->second) != group.end();
      });
    });
  return own;
}

// The pattern of a sentence that is understood as one move, as a whole.
std::optional<Pattern> pattern_of(const Utterance& read, const SpeechGrammarOptions& options) {
  if (read.fragments.size() != 1 || !read.unknown.empty() || !read.unused.empty() || !read.repaired.empty())
    return std::nullopt;
  const auto& reading = read.fragments.front().readings.front();
  if (options.is_taken && !options.is_taken(reading.move)) return std::nullopt;
  Pattern pattern;
  std::size_t words = 0;
  for (const auto& sense : reading.senses) {
    const auto parts = parts_of_entry(sense.words);
    words += parts.size();
    if (!std::all_of(parts.begin(), parts.end(), is_token)) return std::nullopt;
    pattern.push_back({!sense.category.empty(), sense.category.empty() ? sense.words : sense.category});
  }
  return words == read.words.size() ? std::optional(pattern) : std::nullopt;
}

// How many examples of a lexicon have each pattern and each word.
struct Counts {
  std::map<Pattern, double> patterns;
  std::map<std::string, std::map<std::string, double>> words;  // by category
};

Counts counts_of(const std::shared_ptr<const Lexicon>& lexicon, const std::vector<LexiconExample>& examples,
                 WorldSnapshot world, const SpeechGrammarOptions& options) {
  world.objects.insert(world.objects.end(), lexicon->sample.begin(), lexicon->sample.end());
  const Vocabulary vocabulary(lexicon, world);
  Counts counts;
  for (const auto& example : examples)
    for (std::size_t i = 0; i < std::min(example.say.size(), most_read); ++i) {
      const auto utterance = read(example.say[i], vocabulary);
      const auto pattern = pattern_of(utterance, options);
      if (!pattern) continue;
      ++counts.patterns[*pattern];
      for (const auto& sense : utterance.fragments.front().readings.front().senses)
        ++counts.words[sense.category][sense.words];
    }
  return counts;
}

// The values that things of the world have, as words.
std::set<std::string> values_of(const WorldSnapshot& world, const Lexicon& lexicon) {
  std::set<std::string> values;
  for (const auto& object : world.objects)
    for (auto [name, value] : object.attributes) {
      std::replace(value.begin(), value.end(), '_', ' ');
      values.insert(value);
      const auto plural =
          std::find_if(lexicon.plurals.begin(), lexicon.plurals.end(),
                       [&value = value](const auto& endings) { return value.ends_with(endings.first); });
      if (plural != lexicon.plurals.end())
        values.insert(value.substr(0, value.size() - plural->first.size()) + plural->second);
    }
  return values;
}

// The words of each category with their weights: how often examples have them. Values of the world's things count as
// often as the commonest word, where that is their usual use: "plate", but not "blue" for a thing.
std::map<std::string, std::map<std::string, double>> weighted_words(const Vocabulary& vocabulary,
                                                                    const WorldSnapshot& world, const Counts& counts) {
  const auto values = values_of(world, vocabulary.lexicon());
  std::map<std::string, std::map<std::string, double>> weighted;
  for (const auto& words : vocabulary.words())
    for (const auto* sense : Vocabulary::senses(vocabulary.entries(words))) {
      const auto known = counts.words.find(sense->category.text());
      if (known == counts.words.end()) continue;
      const auto& [category, of_category] = *known;
      const auto most = std::max_element(of_category.begin(), of_category.end(), [](const auto& a, const auto& b) {
                          return a.second < b.second;
                        })->second;
      const auto count = of_category.find(words);
      const double weight = values.contains(words) && sense->cost == 0 ? most
                            : count == of_category.end()               ? 0
                                                                       : count->second;
      if (weight >= least_share * most) weighted[category][words] = weight;
    }
  return weighted;
}

class GrammarWriter {
 public:
  using Words = std::map<std::string, double>;

  GrammarWriter(std::map<std::string, Words> words, const SpeechGrammarOptions& options)
      : options_(options), words_(std::move(words)) {}

  /// Adds it, unless one of its steps has no words.
  bool add(const Pattern& pattern, double weight) {
    for (const auto& step : pattern)
      if (said(step).empty()) return false;
    auto* place = &root_;
    for (const auto& step : pattern) {
      place = &place->next[step];
      place->weight += weight;
    }
    place->is_end = true;
    return true;
  }

  SpeechGrammar write(std::size_t patterns) {
    std::map<std::string, std::string> rules;
    const auto sentences = alternatives(root_, rules);
    grammar_.patterns = patterns;
    grammar_.text = fmt::format("#JSGF V1.0 UTF-8;\ngrammar {};\n", options_.name);
    grammar_.text += fmt::format("public <sentence> = {};\n", sentences.empty() ? "<VOID>" : sentences);
    for (const auto& [category, rule] : rules) {
      std::vector<std::string> all;
      for (const auto& [words, weight] : said({true, category})) all.push_back(fmt::format("/{:g}/ {}", weight, words));
      grammar_.text += fmt::format("{} = {};\n", rule, fmt::join(all, " | "));
    }
    return std::move(grammar_);
  }

 private:
  struct Place {
    std::map<Step, Place> next;
    double weight = 0;
    bool is_end = false;
  };

  bool is_pronounced(std::string_view entry) {
    const auto words = parts_of_entry(entry);
    bool all = words.size() <= longest_entry;
    for (const auto word : words) {
      if (!all) break;
      if (!is_token(word)) return false;
      if (!options_.is_pronounced || options_.is_pronounced(word)) continue;
      grammar_.unpronounced.emplace(word);
      all = false;
    }
    return all;
  }

  // The words of a step that can be said.
  Words said(const Step& step) {
    auto all = step.is_category ? words_[step.text] : Words{{step.text, 1}};
    std::erase_if(all, [this](const auto& each) { return !is_pronounced(each.first); });
    return all;
  }

  // Patterns that begin alike are written as one as far as they do, so a recogniser looks at their beginning once.
  std::string alternatives(const Place& place, std::map<std::string, std::string>& rules) {
    std::vector<std::string> all;
    for (const auto& [step, next] : place.next) {
      const auto words = said(step);
      for (const auto& [entry, weight] : words)
        for (const auto word : parts_of_entry(entry)) grammar_.words.emplace(word);
      auto text = words.begin()->first;
      if (words.size() > 1) text = rules.emplace(step.text, fmt::format("<c{}>", rules.size() + 1)).first->second;
      const auto rest = alternatives(next, rules);
      if (!rest.empty()) text += next.is_end ? fmt::format(" [ {} ]", rest) : fmt::format(" ( {} )", rest);
      all.push_back(place.next.size() > 1 ? fmt::format("/{:g}/ {}", next.weight, text) : text);
    }
    return fmt::format("{}", fmt::join(all, " | "));
  }

  const SpeechGrammarOptions& options_;
  std::map<std::string, Words> words_;  // by category
  Place root_;
  SpeechGrammar grammar_;
};

}  // namespace

Result<SpeechGrammar> speech_grammar(const std::shared_ptr<const Lexicon>& lexicon, const WorldSnapshot& world,
                                     const SpeechGrammarOptions& options) {
  const auto all = load_examples(*lexicon);
  if (!all) return all.error();
  const auto counts = counts_of(lexicon, *all, world, options);
  std::vector<std::pair<double, Pattern>> ranked;
  for (const auto& [pattern, examples] : counts.patterns) ranked.emplace_back(examples, pattern);
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) {
    return std::pair(b.first, a.second.size()) < std::pair(a.first, b.second.size());
  });
  const Vocabulary vocabulary(of_world(*lexicon, world), world);
  GrammarWriter writer(weighted_words(vocabulary, world, counts), options);
  std::size_t kept = 0;
  for (const auto& [examples, pattern] : ranked) {
    if (kept == options.patterns) break;
    kept += writer.add(pattern, examples);
  }
  return writer.write(kept);
}

}  // namespace continua
