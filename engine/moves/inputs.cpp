#include "continua/moves/inputs.h"

#include <utility>

namespace continua {
namespace {

Term entities(const std::vector<std::string>& names) {
  std::vector<Term> objects;
  for (const auto& name : names) objects.push_back(Term::entity(name));
  return Term::list(std::move(objects), Type::entity());
}

Term texts(const std::vector<std::string>& words) {
  std::vector<Term> terms;
  for (const auto& word : words) terms.push_back(Term::text(word));
  return Term::list(std::move(terms), Type::text_type());
}

}  // namespace

Term point_term(const Vec3& p_W) { return Term::point(p_W.x(), p_W.y(), p_W.z()); }

Input to_input(const InputEvent& event, int serial) {
  Input input;
  input.serial = serial;
  input.symbol = symbol_of(event);
  if (const auto place = place_of(event)) input.target = point_term(*place);
  if (event.modality == Modality::speech) input.said = Term::text(event.text);
  input.confidence = event.confidence;
  input.now_s = event.t.seconds();
  return input;
}

void carry(const Move& move, Input& input) {
  if (!move.kind.empty()) input.move = Term::text(move.kind);
  std::vector<std::string> referents;
  for (const auto& referent : move.reference.referents) referents.push_back(referent.object);
  input.referents = entities(referents);
  input.unknown = texts(move.unknown);
  input.repaired = texts(move.repaired);
  input.left_out = texts(move.left_out);
  if (move.readings.empty()) return;
  input.reading = move.readings[move.chosen].term;
  input.meaning = move.meaning;
  input.named = Term::list(move.nouns, Type::function(Type::entity(), Type::truth()));
  std::vector<Term> choices, wanted;
  for (const auto& gap : move.interpretation.gaps) {
    choices.push_back(entities(gap.choices));
    wanted.push_back(Term::text(gap.words));
  }
  input.choices = Term::list(std::move(choices), Type::list(Type::entity()));
  input.wanted = Term::list(std::move(wanted), Type::text_type());
}

}  // namespace continua
