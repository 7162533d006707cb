// A machine ready to run: checked, with resolved names. automaton/FORMAT.md describes the file and each part.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "continua/automaton/beliefs.h"
#include "continua/automaton/choice.h"
#include "continua/automaton/configuration.h"
#include "continua/automaton/input.h"
#include "continua/automaton/symbol_set.h"
#include "continua/term/term_text.h"

namespace continua {

/// A parameter that a trace may set. Terms of the machine use it like a definition of that name.
struct Parameter {
  std::string name;
  Term value;  ///< a truth value, a number or a text
  /// Earlier values by the time until which they were in force: 2018-02-05T15:00.
  std::map<std::string, Term, std::less<>> until;
};

struct Slot {
  std::string name;
  Type type;
  bool persists = false;  ///< mirrors something physical: flush keeps it
};

/// The initial value of a slot or register of the type: the empty list, or null.
Term empty_value(const Type& type);

struct Register {
  std::string name;
  Type type;
  Term initial;
  bool cleared_by_flush = false, cleared_by_pop_until = false;  ///< such an operation sets it to `initial`
};

/// A slot and the term that fills it; nullopt is the JSON null, which clears it.
struct Content {
  std::size_t slot = 0;
  std::optional<Term> term;
};

/// A change of the stack.
struct Operation {
  enum class Kind { none, push, push_each, pop, rewrite, rewrite_each, flush, pop_until };
  Kind kind = Kind::none;
  std::vector<Content> contents;  ///< push, rewrite; lists of values for …_each; cleared slots for flush
  bool keeps_stack = false;       ///< rewrite: null: only ε-transitions are tried
  std::size_t count = 1;          ///< pop
  StateIndex state = 0;           ///< pop_until
  std::string source;             ///< its text in the file, compact JSON, for the log

  /// After a rewrite the ε-transitions of the state are tried in any case.
  bool is_rewrite() const { return kind == Kind::rewrite || kind == Kind::rewrite_each; }
};

/// Text with terms to fill in: literals[0] holes[0] literals[1] …; one literal more than holes.
struct Template {
  std::vector<std::string> literals;
  std::vector<Term> holes;
};

struct Effect;

/// Variants of one utterance; there is at least one.
struct SayCase {
  std::optional<Term> when;
  std::vector<Template> variants;
};
/// The first case whose condition holds is said; if none holds, nothing.
struct Say {
  std::vector<SayCase> cases;
};
struct Gesture {
  Term term;
};
struct Act {
  Term term;
};
struct Remember {
  std::vector<std::pair<std::size_t, Term>> registers;
};
/// The kinds of lessons: the meaning of a gesture, the acts of a word, the things that a noun is said of.
enum class Lesson { gesture, word, noun };
std::string name_of(Lesson lesson);

struct Learn {
  Lesson of = Lesson::gesture;
  Term name;           ///< a text
  Term value;          ///< the meaning of the gesture, the acts of the word as a list, or the noun's condition, e -> t
  bool fixed = false;  ///< of a word: its acts keep their objects
};
struct Forget {
  std::optional<Lesson> of;  ///< nullopt: all that was learned
  Term name;                 ///< a text
};
/// Attends to an input that waits, as if it were sure.
struct Attend {
  Term number;  ///< a number: an element of Input::doubted, or 0 for the present input
};
struct Rewrite {
  Operation operation;
};
struct Group {
  std::vector<Effect> effects;
};

/// An effect of a transition, or of entering a state.
struct Effect {
  std::optional<Term> when;
  std::variant<Say, Gesture, Act, Remember, Learn, Forget, Attend, Rewrite, Group> what;
};

struct Gate {
  Term when;
  StateIndex otherwise = 0;
  Operation operation;
};

struct State {
  std::string name;
  bool accepting = false;
  std::optional<Gate> gate;
  std::vector<Effect> enter;
  bool passing = false;  ///< in the middle of a move: no word ends here
};

struct Transition {
  std::string id;
  std::vector<StateIndex> from;
  std::optional<SymbolSet> on;  ///< nullopt: ε
  std::string on_text;          ///< the text of `on` in the file, for people
  std::optional<Term> when;
  StateIndex to = 0;
  Operation operation;
  int rank = 0;       ///< it applies only where none of a higher rank does
  double weight = 1;  ///< how likely it is among those of its rank
  std::vector<Effect> effects;
};

/// The state of the dialogue that observed moves of another avatar imply. The operations are performed in order; `when`
/// and all their contents are evaluated in the configuration before the input.
struct Implied {
  std::size_t number = 0;  ///< in the file, from 1
  std::optional<Term> when;
  StateIndex to = 0;
  std::vector<Operation> operations;
};

/// Words for terms of one shape. All lambdas bind the pattern's variables, in order.
struct Wording {
  std::vector<Type> variables;
  Term pattern;  ///< body of the `of` lambda; its free variables are the pattern's
  std::optional<Term> when;
  Template say;
};

/// Inputs, and the state that they lead to.
struct RunExample {
  std::vector<std::string> inputs;
  StateIndex ends = 0;
};

/// A word, and whether the machine accepts it in the classical sense.
struct WordExample {
  std::vector<std::string> word;
  bool accepted = true;
  bool by_empty_stack = false;  ///< else by final state
};

using Example = std::variant<RunExample, WordExample>;

/// The transitions that leave a state, each list in file order.
struct Exits {
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view symbol) const { return std::hash<std::string_view>()(symbol); }
  };
  std::vector<std::size_t> epsilon;
  /// For each symbol that some transition names: all transitions that take it, also by prefix.
  std::unordered_map<std::string, std::vector<std::size_t>, Hash, std::equal_to<>> by_name;
  std::vector<std::size_t> by_prefix;  ///< transitions that may take a symbol that no transition names

  /// The transitions that take the symbol; nullptr if no transition names it.
  const std::vector<std::size_t>* on(std::string_view symbol) const {
    const auto found = by_name.find(symbol);
    return found == by_name.end() ? nullptr : &found->second;
  }
};

/// The source of a name's value in the machine's terms (FORMAT.md).
struct Binding {
  enum class From { slot, memory, definition, in_state, input, carried, confidence, now, looked_at };
  From from = From::slot;
  std::size_t index = 0;  ///< of the slot or register
  Term definition;
  Term Input::*carried = nullptr;
};

/// A kind of the human's moves: its name (a terminal of the paper's Table 1, such as δ) and its inputs.
struct MoveKind {
  std::string name;
  SymbolSet inputs;
};

/// The context in which speech is understood, besides the world: terms over slots and registers.
struct ContextTerms {
  std::optional<Term> focus;    ///< e*: objects being talked about, the most salient first
  std::optional<Term> among;    ///< e*: the objects of the question
  std::optional<Term> topic;    ///< (e -> t)*: the nouns that "one" can stand for, the likeliest first
  std::optional<Term> handled;  ///< e*: objects that the avatar acted on, the latest first
  /// loc*: places that were pointed at without words, the latest first. Each pointing has two halves, the things there
  /// and the place; a half is listed until it is used.
  std::optional<Term> shown_things, shown_places;
};

/// Time windows of fusion, in seconds (perception/fusion.h).
struct FusionTimes {
  double before_s = 2, after_s = 1, lateness_s = 0, pause_s = 0, together_s = 0;
};

/// The confidences below which inputs are confirmed and ignored.
struct Thresholds {
  SymbolSet inputs;
  double confirm = 0, ignore = 0;
};

/// The salience of looks: seconds times confidence, halved with each half-life after the look.
struct GazeTimes {
  double half_life_s = 2, least = 0.2;  ///< objects of less salience do not count
};

struct Machine {
  std::string name;
  std::string document;  ///< the file, compact JSON
  StateIndex start = 0;
  Choice choice = Choice::likeliest;
  bool epsilon_always = true;  ///< false: ε-transitions are tried only after a rewrite
  bool rewrite_below = false;
  bool repeats_utterances = true;
  double minimum_confidence = 0;
  std::vector<Thresholds> confidence;  ///< the first that contains an input counts
  double near_tie = 0;                 ///< alternatives whose confidences differ by less are asked about
  std::optional<GazeTimes> gaze;       ///< nullopt: nothing is ever looked at
  std::string perspective;             ///< "human", "avatar" or empty

  std::vector<Parameter> parameters;
  std::vector<Slot> slots;
  Symbol bottom;  ///< the symbol at the bottom of every stack
  std::vector<Register> memory;
  std::vector<State> states;
  std::vector<Transition> transitions;
  std::unordered_map<Name, Binding, Name::Hash> bindings;
  std::vector<Exits> exits;                          ///< one for each state
  std::vector<std::optional<std::size_t>> landmark;  ///< for each state its number, if some pop_until names it
  std::size_t landmarks = 0;
  std::map<std::string, Term, std::less<>> definitions;
  std::map<std::string, std::map<std::string, Term, std::less<>>, std::less<>> tables;
  std::vector<Implied> implied;  ///< the first row whose condition holds counts
  std::vector<Wording> wordings;
  BeliefTable beliefs;
  std::string lexicon;                ///< lexicon for speech; empty: words are only symbols
  std::string gestures;               ///< catalogue for gestures; empty: they are only symbols
  std::string phrases;                ///< file of phrases, besides the utterances of the machine file; empty: none
  std::string phrase_document;        ///< that file, compact JSON
  std::optional<FusionTimes> fusion;  ///< nullopt: no event waits for another
  ContextTerms context;
  std::vector<MoveKind> moves;
  SymbolSet ignored;  ///< inputs that are not offered to transitions
  Signature programs;
  std::vector<Example> examples;

  std::map<std::string, std::size_t, std::less<>> slot_index, register_index;

  /// Whether the input set of some transition names the symbol.
  bool knows_input(std::string_view symbol) const;
  /// The thresholds of an input; nullptr if it has none.
  const Thresholds* thresholds_of(std::string_view symbol) const;
  /// Fills `bindings`, `exits`, `landmark` and `landmarks` once everything else is complete.
  void index();
};

/// Calls `visit` with every operation: of transitions, gates and effects.
void visit_operations(const Machine& machine, const std::function<void(const Operation&)>& visit);

}  // namespace continua
