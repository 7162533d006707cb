// Records of a run log about the human and the trace: inputs and their meanings, lessons, expectations.
#pragma once

#include <fmt/format.h>

#include "continua/replay/log/brief_words.h"
#include "continua/replay/log/fields.h"

namespace continua::log {

struct Input {
  OrNull<std::int64_t> line;
  Json event;
  OrNull<std::string> symbol;
  std::optional<std::int64_t> supersedes;

  static constexpr Kind kind{.name = "input",
                             .when = "An event was read, or an act has ended: the machine knows that end as an input.",
                             .decision = Decision::yes,
                             .stop = Stop::unless_of_sample,
                             .brief_adds = "“” pointing observed"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("line", &Input::line, Says::where, "Line of the trace; null for an act.");
    use("event", &Input::event, Says::what,
        "The event as read, without `t`; of an act {`kind`: `act`, `act`, `program`, `status`}.",
        {.in_brief = true, .leaves_out = {"t", "until", "act", "row"}});
    use("symbol", &Input::symbol, Says::how, "The input symbol that it became, or null.");
    use("supersedes", &Input::supersedes, Says::aside,
        "Of speech: the record of the words heard before it that were not final.", {.form = "record"});
  }
  std::string brief() const;
};

/// A pointing, as the fusion of words and gestures uses it.
struct Deixis {
  std::vector<double> place;
  double from_s = 0, until_s = 0;
  OrNull<std::string> hand;
  bool gesture = false;
  double spread_m = 0;
  std::int64_t samples = 0, left_out = 0;
  std::optional<double> distance_m;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("place", &Deixis::place, Says::what, "The place on the table, [x, y] in frame W.", {.form = "metres"});
    use("from", &Deixis::from_s, Says::where, "Its beginning.", {.form = "seconds"});
    use("until", &Deixis::until_s, Says::where, "Its end.", {.form = "seconds"});
    use("hand", &Deixis::hand, Says::what, "`left` or `right`; null where the trace does not say.");
    use("gesture", &Deixis::gesture, Says::what,
        "Whether the place is a gesture's own target; else it was found in samples.");
    use("spread_m", &Deixis::spread_m, Says::where, "Spread of the samples around the place.", {.form = "metres"});
    use("samples", &Deixis::samples, Says::where, "Number of its samples.");
    use("left_out", &Deixis::left_out, Says::where, "Number of samples in its time that were not believed.");
    use("distance_m", &Deixis::distance_m, Says::where,
        "Distance from the hand to the place; left out where no ray tells it.", {.form = "metres"});
  }
};

/// Words and the pointing that goes with them.
struct BoundPointing {
  std::string words;
  Deixis deixis;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("words", &BoundPointing::words, Says::what, "The words that the pointing goes with.");
    use("deixis", &BoundPointing::deixis, Says::what, "The pointing.");
  }
};

struct Percept {
  double waited_s = 0;
  std::vector<BoundPointing> bound;
  std::optional<std::string> joined;
  std::optional<bool> assured;
  std::vector<std::int64_t> because;

  static constexpr Kind kind{
      .name = "percept",
      .when = "An input is attended to together with pointings or earlier words, had to wait, or was asked about.",
      .decision = Decision::yes,
      .brief_adds = ": pointed at, nothing is pointed at, it was meant, after s"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("waited_s", &Percept::waited_s, Says::where, "Time since the input began.",
        {.form = "seconds", .in_brief = true});
    use("bound", &Percept::bound, Says::what, "The pointings, each with its words.", {.in_brief = true});
    use("joined", &Percept::joined, Says::what, "The words of all inputs that make one utterance.", {.in_brief = true});
    use("assured", &Percept::assured, Says::what,
        "True: it was not sure, it was asked about, and the human has said that it was meant.", {.in_brief = true});
    use("because", &Percept::because, Says::aside, "The inputs that contributed.", {.form = "record"});
  }
  std::string brief() const;
};

/// A lambda of a meaning for which no value was found.
struct Missing {
  std::string type, why;
  std::vector<std::string> choices;
  std::string words;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("type", &Missing::type, Says::how, "Type of the missing value.");
    use("why", &Missing::why, Says::how, "`unsaid`, `several` or `none`.");
    use("choices", &Missing::choices, Says::how, "For `several`: the objects meant, the likeliest first.");
    use("words", &Missing::words, Says::how, "The noun without its determiner; empty if unsaid.");
  }
};

/// An object that a noun phrase does not mean.
struct RuledOut {
  std::string object, reason;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("object", &RuledOut::object, Says::how, "Name of the object.");
    use("reason", &RuledOut::reason, Says::how, "The reason, a sentence.");
  }
};

/// The meaning given to a noun phrase or pro-form.
struct Resolution {
  std::string phrase, words, value, by;
  std::optional<std::vector<std::string>> referents;
  std::optional<std::vector<double>> weights;
  std::optional<std::vector<RuledOut>> ruled_out;
  std::optional<std::string> sides;
  std::optional<Margin> margin;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("phrase", &Resolution::phrase, Says::how, "The phrase.", {.form = "term"});
    use("words", &Resolution::words, Says::how, "Its words.");
    use("value", &Resolution::value, Says::how, "Its meaning here and now.", {.form = "term"});
    use("by", &Resolution::by, Says::how, "`words`, `focus`, `pointed`, `topic` or `presence`.");
    use("referents", &Resolution::referents, Says::how,
        "Of a noun phrase: the objects that it can mean, the likeliest first.");
    use("weights", &Resolution::weights, Says::how, "The weights of these objects.");
    use("ruled_out", &Resolution::ruled_out, Says::how, "The objects that it cannot mean.");
    use("sides", &Resolution::sides, Says::how,
        "`rough` or `loose`: how \"left of\" and its like had to be taken; left out when exact.");
    use("margin", &Resolution::margin, Says::aside, "How near the choice of objects was, or null.");
  }
};

/// One way to read the words.
struct Parse {
  std::string reading, type, category, move;
  double cost = 0;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("reading", &Parse::reading, Says::how, "What the words say.", {.form = "term"});
    use("type", &Parse::type, Says::how, "Its type.");
    use("category", &Parse::category, Says::how, "Its category.");
    use("move", &Parse::move, Says::how, "The move that it would be.");
    use("cost", &Parse::cost, Says::how, "Its cost; the cheapest comes first.");
  }
};

/// A sense of a word that parses are made of.
struct Sense {
  std::string words;
  std::optional<std::string> category, term;
  double cost = 0;
  std::optional<std::vector<std::int64_t>> parses;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("words", &Sense::words, Says::how, "The words.");
    use("category", &Sense::category, Says::how, "Their category; left out where they were passed over.");
    use("term", &Sense::term, Says::how, "Their meaning.", {.form = "term"});
    use("cost", &Sense::cost, Says::how, "The cost of this sense.");
    use("parses", &Sense::parses, Says::how, "Ranks of the parses that have it; left out where all have.");
  }
};

/// The comparison of a gesture's shape with taught ones.
struct ShapeMatch {
  std::string verdict;
  std::optional<std::string> nearest;
  std::optional<double> distance;
  std::optional<std::string> rival;
  std::optional<double> rival_distance;
  std::int64_t of_other_length = 0;
  std::string reason;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("verdict", &ShapeMatch::verdict, Says::what,
        "`named` (taught under its name), `recognised`, `too far`, `contested` (like two things) or `nothing "
        "known`.");
    use("nearest", &ShapeMatch::nearest, Says::what, "The taught gesture with the nearest exemplar.");
    use("distance", &ShapeMatch::distance, Says::how, "The distance of that exemplar.");
    use("rival", &ShapeMatch::rival, Says::how, "The nearest taught gesture with another meaning.");
    use("rival_distance", &ShapeMatch::rival_distance, Says::how, "The distance of its exemplar.");
    use("of_other_length", &ShapeMatch::of_other_length, Says::how,
        "Number of exemplars of another length, which are not compared.");
    use("reason", &ShapeMatch::reason, Says::aside, "The same as a sentence.");
  }
};

struct Reading {
  OrNull<std::string> move;
  std::optional<std::string> words, reading, category, meaning, type;
  std::optional<std::vector<Missing>> missing;
  std::optional<std::vector<Resolution>> resolved;
  std::optional<std::int64_t> rank;
  std::optional<std::vector<Parse>> parses;
  std::optional<std::vector<Sense>> entries;
  std::optional<std::vector<std::string>> rules, referents;
  std::optional<std::vector<double>> weights;
  std::optional<std::vector<RuledOut>> ruled_out;
  std::optional<std::string> sides;
  std::optional<Margin> margin;
  std::optional<std::vector<std::string>> unknown, unused, repaired;
  std::optional<ShapeMatch> shape;
  std::vector<std::int64_t> because;
  std::optional<std::int64_t> alternative;
  std::optional<double> confidence;
  std::optional<bool> taken;

  static constexpr Kind kind{.name = "reading",
                             .when =
                                 "An input was taken to mean something; an utterance gives one record for each of "
                                 "its moves, and an n-best list one for each alternative, the taken one last.",
                             .decision = Decision::yes,
                             .brief_adds = "not understood: nothing or"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("move", &Reading::move, Says::what,
        "`V`, `N`, `P`, `y`, `n`, `δ`, `ω`, `α` or another of the lexicon's; null: nothing was understood.",
        {.in_brief = true});
    use("words", &Reading::words, Says::what, "Of speech: the words.", {.in_brief = true});
    use("reading", &Reading::reading, Says::how, "Of speech: what the words say.", {.form = "term"});
    use("category", &Reading::category, Says::how, "Of speech: the category of the reading.");
    use("meaning", &Reading::meaning, Says::what, "Of speech: what the words mean here and now.",
        {.form = "term", .in_brief = true});
    use("type", &Reading::type, Says::how, "Of speech: the type of `meaning`.");
    use("missing", &Reading::missing, Says::how, "The lambdas of `meaning`, one element each.");
    use("resolved", &Reading::resolved, Says::aside, "What noun phrases and pro-forms were taken to mean.");
    use("rank", &Reading::rank, Says::how, "Place of the reading among `parses`, from 0.");
    use("parses", &Reading::parses, Says::how, "All ways to read the words, the cheapest first.");
    use("entries", &Reading::entries, Says::aside, "The senses of words that the parses are made of.");
    use("rules", &Reading::rules, Says::aside, "The unary rules of the lexicon that the reading takes.");
    use("referents", &Reading::referents, Says::what,
        "The objects that the last noun phrase, or the pointing, can mean, the likeliest first.", {.in_brief = true});
    use("weights", &Reading::weights, Says::aside, "Of a pointing: the weights of `referents`.");
    use("ruled_out", &Reading::ruled_out, Says::how, "Of a pointing: the objects that it cannot mean.");
    use("sides", &Reading::sides, Says::how, "As in `resolved`.");
    use("margin", &Reading::margin, Says::aside, "Of a pointing: how near the choice of objects was, or null.");
    use("unknown", &Reading::unknown, Says::how, "Words that the lexicon does not have.");
    use("unused", &Reading::unused, Says::how, "Words that belong to no move.");
    use("repaired", &Reading::repaired, Says::how,
        "Unknown words that were read as words of the scene which resemble them; `entries` has these.");
    use("shape", &Reading::shape, Says::how,
        "Of a gesture with `features` that no catalogue has: how its shape compares with taught ones.");
    use("because", &Reading::because, Says::aside, of_sources, {.form = "record"});
    use("alternative", &Reading::alternative, Says::how,
        "Of an n-best list: its place in the list; 0 is the event's own text.");
    use("confidence", &Reading::confidence, Says::how, "Of an n-best list: the weight of the alternative.");
    use("taken", &Reading::taken, Says::what, "Of an n-best list: whether the dialogue went on with it.");
  }
  std::string brief() const;
};

struct Learned {
  std::string of, name, value;
  std::vector<std::int64_t> because;

  static constexpr Kind kind{
      .name = "learned", .when = "The human taught something.", .decision = Decision::yes, .brief_adds = "="};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("of", &Learned::of, Says::what, "`gesture` or `word`.", {.in_brief = true});
    use("name", &Learned::name, Says::what, "Name of the gesture, or the word.", {.in_brief = true});
    use("value", &Learned::value, Says::what,
        "The meaning of a gesture; the acts of a word, below lambdas for the objects that they need.",
        {.form = "term", .in_brief = true});
    use("because", &Learned::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const { return fmt::format("{} {} = {}", of, name, value); }
};

struct Forgotten {
  std::string of, name, value;
  std::vector<std::int64_t> because;

  static constexpr Kind kind{.name = "forgotten",
                             .when = "Something that was taught is forgotten.",
                             .decision = Decision::yes,
                             .brief_adds = "="};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("of", &Forgotten::of, Says::what, "`gesture` or `word`.", {.in_brief = true});
    use("name", &Forgotten::name, Says::what, "Name of the gesture, or the word.", {.in_brief = true});
    use("value", &Forgotten::value, Says::what, "What it meant.", {.form = "term", .in_brief = true});
    use("because", &Forgotten::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const { return fmt::format("{} {} = {}", of, name, value); }
};

struct Observed {
  std::int64_t line = 0;
  std::string channel, content;

  static constexpr Kind kind{.name = "observed",
                             .when = "Another agent did something, as the trace says. It is never an input.",
                             .stop = Stop::never,
                             .repeats_event = true};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("line", &Observed::line, Says::where, "Line of the trace.");
    use("channel", &Observed::channel, Says::what, "`speech`, `gesture` or `action`.", {.in_brief = true});
    use("content", &Observed::content, Says::what, "The words, or the term.", {.in_brief = true});
  }
  std::string brief() const { return joined({channel, content}); }
};

struct Expect {
  std::int64_t line = 0;
  bool met = false;
  Json expected, found;

  static constexpr Kind kind{.name = "expect",
                             .when = "An expectation of the trace was checked.",
                             .decision = Decision::yes,
                             .brief_adds = "met: not met: expected ; found ,"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("line", &Expect::line, Says::where, "Line of the trace.");
    use("met", &Expect::met, Says::how, "Whether it holds.", {.in_brief = true});
    use("expected", &Expect::expected, Says::what, "The fields of the event.", {.in_brief = true});
    use("found", &Expect::found, Says::how, "The values of the same fields here.", {.in_brief = true});
  }
  std::string brief() const;
};

struct Mark {
  std::int64_t line = 0;
  std::string text;

  static constexpr Kind kind{.name = "mark",
                             .when = "The experimenter marked this moment, as the trace says. It is never an input.",
                             .repeats_event = true};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("line", &Mark::line, Says::where, "Line of the trace.");
    use("text", &Mark::text, Says::what, "The mark's words.", {.in_brief = true});
  }
  std::string brief() const { return text; }
};

using RecordsOfInput = Kinds<Input, Percept, Reading, Learned, Forgotten, Observed, Expect, Mark>;

}  // namespace continua::log
