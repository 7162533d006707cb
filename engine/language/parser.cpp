#include "continua/language/parser.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "continua/core/words.h"
#include "continua/language/segment.h"

namespace continua {
namespace {

// The treatment of unknown words.
enum class Unknown {
  left_out,
  names,     // of what the human is about to name
  renamed,   // the same, and known words may be such names too
  repaired,  // to words that are spelt or heard almost like them, left out where there is none
};

WordEntry joined(WordEntry entry, WordEntry more) {
  std::move(more.senses.begin(), more.senses.end(), std::back_inserter(entry.senses));
  return entry;
}

// Which of the words belong to an entry that is said there as a whole: "minute" does in "wait a minute" alone.
std::vector<bool> known_words(const std::vector<SpokenWord>& spoken, const Vocabulary& vocabulary) {
  std::vector<bool> known(spoken.size());
  for (std::size_t begin = 0; begin < spoken.size(); ++begin) {
    Vocabulary::Walk walk(vocabulary);
    for (auto end = begin; end < spoken.size() && !walk.is_over(); ++end) {
      if (!walk.step(spoken[end].text).empty())
        std::fill_n(known.begin() + static_cast<std::ptrdiff_t>(begin), end + 1 - begin, true);
      if (spoken[end].ends_after) break;
    }
  }
  return known;
}

// Collects the words of an utterance, and reads them segment by segment.
class Hearing {
 public:
  // `passed_over`: the number of a word that counts as unknown though it is not.
  Hearing(const Vocabulary& vocabulary, Unknown unknown, std::optional<std::size_t> passed_over = {})
      : vocabulary_(vocabulary), unknown_(unknown), passed_over_(passed_over) {}

  Utterance read(const std::vector<SpokenWord>& spoken) {
    const auto known = known_words(spoken, vocabulary_);
    for (std::size_t i = 0; i < spoken.size(); ++i) {
      const auto& word = spoken[i];
      if (word.comma)
        add_comma();
      else if (utterance_.words.size() == passed_over_)
        pass_over(word.text);
      else
        add_word(word.text, known[i]);
      if (word.ends_after) {
        end_segment();
        end_sentence();
      }
    }
    end_segment();
    if (utterance_.ends.empty() || utterance_.ends.back() < utterance_.words.size()) end_sentence();
    return std::move(utterance_);
  }

 private:
  void add_comma() {
    if (!words_.empty()) add({",", false, {}});
    after_name_ = false;
  }

  void pass_over(const std::string& text) {
    utterance_.unknown.push_back(utterance_.words.size());
    utterance_.words.push_back(text);
    if (!words_.empty()) words_.back().before_unknown = true;
    after_name_ = false;
  }

  void add_word(const std::string& text, bool is_known) {
    utterance_.words.push_back(text);
    const auto place = utterance_.words.size() - 1;
    auto number = vocabulary_.as_number(text);
    const bool known = is_known || !number.senses.empty();
    const bool name = !known && (unknown_ == Unknown::names || unknown_ == Unknown::renamed);
    const auto meant = known || unknown_ != Unknown::repaired ? std::nullopt : vocabulary_.resembling(text);
    if (meant) {
      add({meant->word, false, {}});
      utterance_.repaired.push_back(place);
      if (!meant->sure) utterance_.guessed.push_back(place);
    } else if (known) {
      if (unknown_ == Unknown::renamed)
        number = joined(std::move(number), vocabulary_.as_name(text, vocabulary_.means(text)));
      add({text, false, std::move(number)});
    } else {
      utterance_.unknown.push_back(place);
      if (name) add_name(text);
      if (!name && !words_.empty()) words_.back().before_unknown = true;
    }
    after_name_ = name;
  }

  // Neighbouring unknown words are one name.
  void add_name(const std::string& text) {
    if (!after_name_) return add({text, false, vocabulary_.as_name(text, false)});
    words_.back().text += " " + text;
    words_.back().name = vocabulary_.as_name(words_.back().text, false);
    utterance_.unknown.pop_back();
  }

  void add(Chart::Word word) {
    words_.push_back(std::move(word));
    positions_.push_back(utterance_.words.size() - 1);
  }

  void end_segment() {
    if (!words_.empty()) read_segment(words_, positions_, vocabulary_, utterance_);
    words_.clear();
    positions_.clear();
    after_name_ = false;
  }

  void end_sentence() { utterance_.ends.push_back(utterance_.words.size()); }

  const Vocabulary& vocabulary_;
  Unknown unknown_;
  std::optional<std::size_t> passed_over_;
  Utterance utterance_;
  std::vector<Chart::Word> words_;  // of the segment
  std::vector<std::size_t> positions_;
  bool after_name_ = false;
};

// Without words that are said twice in a row, as speakers do who start again: "on the, on the plate".
std::vector<SpokenWord> without_repeats(const std::vector<SpokenWord>& spoken) {
  constexpr std::size_t longest_repeat = 4;  // words
  const auto is_comma = [&](std::size_t at) { return at < spoken.size() && spoken[at].comma; };
  std::vector<SpokenWord> heard;
  for (std::size_t at = 0; at < spoken.size();) {
    // The place of the words that repeat the `count` words from `at` on; none if there are no such words.
    const auto repeated_at = [&](std::size_t count) -> std::optional<std::size_t> {
      const auto to = at + count + (is_comma(at + count) ? 1 : 0);
      for (std::size_t i = 0; i < count; ++i) {
        if (to + i >= spoken.size()) return std::nullopt;
        const auto& word = spoken[at + i];
        if (word.text != spoken[to + i].text || word.ends_after || word.comma) return std::nullopt;
      }
      return to;
    };
    std::optional<std::size_t> again;
    for (auto count = longest_repeat; count > 0 && !again; --count) again = repeated_at(count);
    if (!again) heard.push_back(spoken[at]);
    at = again.value_or(at + 1);
  }
  return heard;
}

// With the apostrophes that people leave out: "dont" is "don't".
std::vector<SpokenWord> with_apostrophes(std::vector<SpokenWord> spoken, const Vocabulary& vocabulary) {
  for (auto& word : spoken)
    for (const auto& [without, with] : vocabulary.lexicon().apostrophes) {
      if (!word.text.ends_with(without)) continue;
      auto written = word.text.substr(0, word.text.size() - without.size()) + with;
      if (vocabulary.knows(written)) word.text = std::move(written);
    }
  return spoken;
}

// With a word of its own for each contracted one: "the cup's empty" is "the cup is empty".
std::vector<SpokenWord> without_contractions(const std::vector<SpokenWord>& spoken, const Vocabulary& vocabulary) {
  std::vector<SpokenWord> heard;
  for (const auto& word : spoken) {
    const auto& all = vocabulary.lexicon().contracted;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) {
      return word.text.size() > each.first.size() && word.text.ends_with(each.first);
    });
    heard.push_back(word);
    if (found == all.end() || !vocabulary.entries(word.text).empty()) continue;
    auto& shorter = heard.back();
    shorter.text.resize(word.text.size() - found->first.size());
    shorter.ends_after = shorter.half = false;
    heard.push_back({found->second, false, word.ends_after, word.half, word.quoted});
  }
  return heard;
}

bool has_words_of(const std::vector<SpokenWord>& a, const std::vector<SpokenWord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const SpokenWord& each, const SpokenWord& other) { return each.text == other.text; });
}

// Fragments that lack something, as the first "take" of "take, take the cup" does.
std::size_t open_fragments(const Utterance& utterance) {
  return static_cast<std::size_t>(
      std::count_if(utterance.fragments.begin(), utterance.fragments.end(), [](const Fragment& fragment) {
        return !fragment.readings.empty() && fragment.readings.front().term.type().kind() == Type::Kind::function;
      }));
}

// With commas in place of half ends: "to tidy means: take the knife" is one sentence.
std::vector<SpokenWord> without_half_ends(const std::vector<SpokenWord>& spoken) {
  std::vector<SpokenWord> heard;
  for (auto word : spoken) {
    const bool half = std::exchange(word.half, false);
    if (half) word.ends_after = false;
    heard.push_back(std::move(word));
    if (half) heard.push_back({",", true});
  }
  return heard;
}

bool is_in_fragment(std::size_t word, const Utterance& utterance) {
  return std::any_of(utterance.fragments.begin(), utterance.fragments.end(), [&](const Fragment& fragment) {
    return word >= fragment.words.begin && word < fragment.words.end;
  });
}

// Unknown words become names if each of them finds a place in a fragment.
bool takes_names(const Utterance& named) {
  return std::all_of(named.unknown.begin(), named.unknown.end(),
                     [&](std::size_t word) { return is_in_fragment(word, named); });
}

bool holds_any(const std::vector<std::size_t>& places, WordSpan span) {
  return std::any_of(places.begin(), places.end(),
                     [&](std::size_t place) { return place >= span.begin && place < span.end; });
}

// Leaves of the fragments within the sentence only the longest, the first of equals, if words of it were lost.
void keep_longest(WordSpan sentence, Utterance& utterance) {
  if (!holds_any(utterance.unknown, sentence) && !holds_any(utterance.unused, sentence)) return;
  const auto is_within = [&](const Fragment& fragment) {
    return fragment.words.begin >= sentence.begin && fragment.words.end <= sentence.end;
  };
  auto& all = utterance.fragments;
  const auto first = std::find_if(all.begin(), all.end(), is_within);
  const auto last = std::find_if_not(first, all.end(), is_within);
  if (first == last) return;
  const auto longest = std::max_element(
      first, last, [](const Fragment& a, const Fragment& b) { return a.words.size() < b.words.size(); });
  for (auto each = first; each != last; ++each)
    for (auto word = each->words.begin; each != longest && word < each->words.end; ++word)
      if (!holds_any(utterance.unused, {word, word + 1}) && !holds_any(utterance.unknown, {word, word + 1}))
        utterance.unused.push_back(word);
  std::sort(utterance.unused.begin(), utterance.unused.end());
  Fragment kept = std::move(*longest);
  all.insert(all.erase(first, last), std::move(kept));
}

// Takes the half ends out beside which words were lost: "Bob said to us: take the knife" is one sentence, of which only
// the end was understood.
void join_halves(const std::vector<SpokenWord>& spoken, Utterance& utterance) {
  std::vector<std::size_t> halves;
  std::size_t count = 0;
  for (const auto& word : spoken) {
    if (!word.comma) ++count;
    if (word.half) halves.push_back(count);
  }
  const auto is_lost = [&](WordSpan span) {
    return holds_any(utterance.unknown, span) || holds_any(utterance.unused, span);
  };
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < utterance.ends.size(); ++i) {
    const auto begin = kept.empty() ? 0 : kept.back();
    const bool is_half = std::binary_search(halves.begin(), halves.end(), utterance.ends[i]);
    const bool is_last = i + 1 == utterance.ends.size();
    if (is_last || !is_half || !is_lost({begin, utterance.ends[i + 1]})) kept.push_back(utterance.ends[i]);
  }
  utterance.ends = std::move(kept);
}

// The words in quotation marks, unless all are.
std::vector<std::size_t> quoted_in(const std::vector<SpokenWord>& spoken) {
  std::vector<std::size_t> quoted;
  std::size_t count = 0;
  for (const auto& word : spoken) {
    if (word.comma) continue;
    if (word.quoted) quoted.push_back(count);
    ++count;
  }
  return quoted.size() < count ? quoted : std::vector<std::size_t>();
}

std::size_t lost_words(const Utterance& utterance) { return utterance.unknown.size() + utterance.unused.size(); }

// Passes over one of the words that fit nowhere, if the words around it go together so: "the heavy cup", where "heavy"
// is said of states.
Utterance without_unused(Utterance utterance, const std::vector<SpokenWord>& spoken, const Vocabulary& vocabulary) {
  constexpr std::size_t most_tries = 4;
  const auto mode = utterance.repaired.empty() ? Unknown::left_out : Unknown::repaired;
  const auto badness = [](const Utterance& one) { return std::pair(lost_words(one), one.fragments.size()); };
  const auto tried = utterance.unused;
  for (std::size_t i = 0; i < std::min(most_tries, tried.size()); ++i)
    if (auto again = Hearing(vocabulary, mode, tried[i]).read(spoken);
        badness(again) < badness(utterance) && is_in_fragment(tried[i], again))
      utterance = std::move(again);
  return utterance;
}

// Unknown words are names if they can be, else words that they resemble. Known words are names if nothing is lost then.
Utterance read(const std::vector<SpokenWord>& spoken, const Vocabulary& vocabulary) {
  Utterance utterance = Hearing(vocabulary, Unknown::left_out).read(spoken);
  if (!utterance.unknown.empty()) {
    auto named = Hearing(vocabulary, Unknown::names).read(spoken);
    if (!vocabulary.lexicon().unknown.empty() && takes_names(named)) {
      named.unknown.clear();
      utterance = std::move(named);
    } else if (auto repaired = Hearing(vocabulary, Unknown::repaired).read(spoken); !repaired.repaired.empty()) {
      utterance = std::move(repaired);
    }
  }
  const bool whole = lost_words(utterance) == 0 && utterance.fragments.size() < 2;
  if (whole || vocabulary.lexicon().taken.empty()) return utterance;
  auto renamed = Hearing(vocabulary, Unknown::renamed).read(spoken);
  if (!takes_names(renamed) || !renamed.unused.empty()) return utterance;
  if (lost_words(utterance) == 0 && renamed.fragments.size() >= utterance.fragments.size()) return utterance;
  renamed.unknown.clear();
  return renamed;
}

}  // namespace

Utterance read(std::string_view text, const Vocabulary& vocabulary) {
  bool cut = false;
  const auto spoken = words_of(text, most_words, &cut);
  auto best = spoken;
  Utterance utterance = read(spoken, vocabulary);
  // "the plate's": a contraction is likelier than a slip, so that repaired words count as lost here.
  const auto doubtful = [](const Utterance& one) { return lost_words(one) + one.repaired.size(); };
  const auto hear = [&](const std::vector<SpokenWord>& heard) {
    if (doubtful(utterance) == 0 || has_words_of(heard, spoken)) return;
    if (auto again = read(heard, vocabulary); doubtful(again) < doubtful(utterance)) {
      utterance = std::move(again);
      best = heard;
    }
  };
  const auto written = with_apostrophes(spoken, vocabulary);
  hear(written);
  hear(without_repeats(written));
  hear(without_contractions(written, vocabulary));
  hear(without_contractions(without_repeats(written), vocabulary));
  if (const auto once = without_repeats(written); once.size() != written.size())
    if (auto again = read(once, vocabulary);
        doubtful(again) <= doubtful(utterance) && open_fragments(again) < open_fragments(utterance)) {
      utterance = std::move(again);
      best = once;
    }
  if (std::any_of(spoken.begin(), spoken.end(), [](const auto& word) { return word.half; }))
    if (auto whole = read(without_half_ends(spoken), vocabulary);
        lost_words(whole) == 0 && (lost_words(utterance) > 0 || whole.fragments.size() < utterance.fragments.size()))
      utterance = std::move(whole);
  utterance = without_unused(std::move(utterance), best, vocabulary);
  join_halves(best, utterance);
  utterance.quoted = quoted_in(best);
  std::size_t begin = 0;
  for (const auto end : std::vector(utterance.ends)) {
    keep_longest({begin, end}, utterance);
    begin = end;
  }
  utterance.cut = cut;
  return utterance;
}

}  // namespace continua
