// The meaning of a phrase of a reading: noun phrases by refer(), pro-forms by words, pointing or presence. A part of
// the interpretation (language/interpretation.h).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "continua/language/interpretation.h"

namespace continua {

/// The values of a phrase: one, or the several of a plural; or the reason why there are none.
struct Meant {
  std::vector<Term> values;
  bool plural = false;  ///< all values are meant together
  std::optional<Gap> gap;
  Resolution resolution;  ///< its value is null where there are several, or none
  std::string there;      ///< of a place that was pointed at: the object that stands there, or empty
};

class Referring {
 public:
  Referring(const Reading& reading, const std::vector<std::string>& words, Context context, const Meanings& meanings)
      : reading_(reading), words_(words), context_(std::move(context)), meanings_(meanings) {}

  /// Is it a noun phrase D(\x. …), a noun without determiner, or a pro-form? Not where it depends on one of `open`,
  /// the variables around it.
  bool is_phrase(const Term& term, const std::vector<Term>& open) const;
  /// `occurrence`: which of those that are said with this term, in the order of their words. REQUIRES is_phrase().
  Meant meant(const Term& phrase, std::size_t occurrence) const;

  /// Whether the term is true or false of objects (a noun, "red cup"): its head computes something, so it is no command
  /// that lacks an argument.
  bool is_noun(const Term& term) const;
  Meant meant_by_noun(const Term& noun) const;

  /// The command names this object, so that "it" rather means another one.
  void named(const std::string& object);
  /// Something goes where this object stands, so that "it" means another one.
  void not_it(const std::string& object);
  /// A new command begins: these objects are being talked about from now on, the last first.
  void focus_on(const std::vector<std::string>& objects);

 private:
  const Determiner* determiner(const Term& term) const;
  const Proform* proform(const Term& term) const;
  Meant by_determiner(const Term& phrase, const Term& condition, Determiner determiner, std::size_t occurrence) const;
  Meant undefined(const Term& phrase, const Determiner& determiner, std::size_t occurrence) const;
  Meant by_proform(const Term& phrase, const Proform& proform, std::size_t occurrence) const;
  Meant chosen(const Term& phrase, Reference reference, const Determiner& determiner, std::string noun,
               const Context& context, std::size_t occurrence) const;
  std::optional<Term> single_value(const Proform& proform, const Type& type, const Context& context) const;
  /// The nouns that "one" can stand for, the likeliest first; any thing where nothing was named.
  std::vector<Term> topics() const;
  Term with_topic(const Term& condition, const Term& topic) const;
  bool describes(const Term& condition) const;
  Reference found(const Term& condition, const Determiner& determiner, Context context) const;
  std::optional<WordSpan> span_of(const Term& phrase, std::size_t occurrence) const;
  std::string words_of(const Term& phrase, std::size_t occurrence) const;
  std::optional<std::size_t> showing_of(const Term& phrase, std::size_t occurrence) const;
  Context context_of(const Term& phrase, std::size_t occurrence) const;

  const Reading& reading_;
  const std::vector<std::string>& words_;
  Context context_;
  const Meanings& meanings_;
  std::vector<std::string> named_;  // by the command so far
};

}  // namespace continua
