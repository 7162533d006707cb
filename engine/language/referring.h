// Finds the meaning of a single phrase: noun phrases by refer(), pro-forms by their source (said, shown or present).
// A part of the interpretation (language/interpretation.h).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "continua/language/demonstratives.h"
#include "continua/language/interpretation.h"

namespace continua {

/// The values of a phrase, one or those of a plural; or the gap that tells why there are none.
struct Meant {
  std::vector<Term> values;
  bool plural = false;  ///< all values are meant together
  std::optional<Gap> gap;
  Resolution resolution;           ///< its value is null if there is a gap
  std::vector<Resolution> within;  ///< of things inside the phrase that are pointed at by themselves
  std::string there;               ///< for a pointed place: the object that stands there, or empty
};

class Referring {
 public:
  Referring(const Reading& reading, const std::vector<std::string>& words, Context context, const Meanings& meanings)
      : reading_(reading), words_(words), context_(std::move(context)), meanings_(meanings) {}

  /// Whether `term` is a pro-form (`other` excepted), or a noun phrase D(\x. …) without any of `open`, the variables
  /// around it.
  bool is_phrase(const Term& term, const std::vector<Term>& open) const;
  /// `occurrence`: the number of this use among the uses of the term, in the order of their words. REQUIRES
  /// is_phrase().
  Meant meant(const Term& phrase, std::size_t occurrence) const;

  /// Whether the term is a noun ("red cup"), of type e -> t, and not a command that lacks its argument. The head of a
  /// noun can be computed; the head of a command cannot.
  bool is_noun(const Term& term) const;
  Meant meant_by_noun(const Term& noun) const;

  /// The application of [[point]] by which this showing of the context came about; nothing if that is not told.
  std::optional<Application> pointing(std::size_t showing) const;

  /// The command names this object: "it" means another one if there is one.
  void named(const std::string& object);
  /// The command uses this object's place as its goal: "it" means another object.
  void not_it(const std::string& object);
  /// A new command begins: these objects are now in focus, the last first.
  void focus_on(const std::vector<std::string>& objects);

 private:
  const Determiner* determiner(const Term& term) const;
  const Proform* proform(const Term& term) const;
  Meant by_determiner(const Term& phrase, const Term& noun, Determiner determiner, std::size_t occurrence) const;
  std::optional<Term> kind_without_things(const Term& condition, const Determiner& determiner,
                                          const Context& context) const;
  static std::string words_of_kind(const Term& kind, const std::string& words);
  std::optional<Meant> by_showings(const Term& phrase, const Term& condition, const Determiner& determiner,
                                   std::string noun, std::size_t occurrence) const;
  Meant undefined(const Term& phrase, const Determiner& determiner, std::size_t occurrence) const;
  Meant by_proform(const Term& phrase, const Proform& proform, std::size_t occurrence) const;
  Meant chosen(const Term& phrase, Reference reference, const Determiner& determiner, std::string noun,
               const Context& context, std::size_t occurrence) const;
  std::optional<Term> single_value(const Proform& proform, const Type& type, const Context& context) const;
  /// Possible meanings of "one", the likeliest first; any thing if there is no topic.
  std::vector<Term> topics() const;
  Reference found(const Term& condition, const Determiner& determiner, Context context) const;
  std::optional<WordSpan> span_of(const Term& phrase, std::size_t occurrence) const;
  std::string words_of(const Term& phrase, std::size_t occurrence) const;
  std::optional<std::size_t> showing_of(const Term& phrase, std::size_t occurrence) const;
  bool shows_another(const Term& phrase, std::size_t occurrence) const;
  std::size_t uses_before(const Term& phrase, std::size_t word) const;
  std::vector<Phrase> shown_inside(const WordSpan& span) const;
  std::vector<Phrase> antecedents_in(const Term& condition, const WordSpan& span) const;
  Term with_shown(const Term& phrase, Term condition, std::size_t occurrence, std::vector<Resolution>& within) const;
  Context context_of(const Term& phrase, std::size_t occurrence) const;

  const Reading& reading_;
  const std::vector<std::string>& words_;
  Context context_;
  const Meanings& meanings_;
  std::vector<std::string> named_;  // objects that the command has named so far
};

}  // namespace continua
