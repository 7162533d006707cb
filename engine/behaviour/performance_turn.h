// One turn of an act under way: from its progress so far to the next step for the body.
#pragma once

#include <optional>
#include <string>

#include "continua/behaviour/performance.h"

namespace continua {

/// Positions of the world's things, by name.
std::map<std::string, Vec3> places_of(const WorldSnapshot& world);

class PerformanceTurn {
 public:
  /// All must outlive the turn.
  PerformanceTurn(const Catalogue* catalogue, const Circumstances& circumstances, ActUnderWay& act)
      : catalogue_(catalogue), circumstances_(circumstances), act_(act) {}

  /// Begins the act's program. The places that was(…) and originally(…) mean are `earlier`.
  void begin(const EarlierPlaces& earlier);
  /// The next step, its command without id; nothing at the end of the act, whose outcome is in `end`.
  std::optional<ActStep> step();

 private:
  using Frame = ProgramFrame;

  void perform(const Term& program, bool documented);
  void perform_event(const Expression& event);
  void push(Frame frame);
  void define(const Expression& event);
  void repeat(const Expression& event);
  std::optional<Bindings> bind(const Voxeme& voxeme, const Term& program, bool documented);
  Term resolved(const Term& term, const EarlierPlaces& earlier) const;
  Term fixed_place(const Term& thing, const Term& place) const;

  void advance();
  void advance_loop(const Subevent& loop);
  std::optional<ActStep> own_step();
  std::optional<ActStep> let_go();
  bool prepare(Frame& frame);
  const Term* there_already(const Voxeme& voxeme, const Bindings& bindings) const;
  std::vector<std::string> grasp_parts(const ObjectState& object) const;
  std::optional<Goal> next_goal(const std::string& object) const;
  Expression event_of(const Subevent& subevent) const;
  Term of_body(const Term& program, bool documented) const;
  std::optional<bool> decided(const Expression& condition, const Bindings& bindings);
  ActStep new_step(Term program) { return {act_.end.act.number, ++act_.steps, std::move(program), {}, {}}; }
  void fail(Reason reason);
  Reason too_long() const;

  const WorldSnapshot& world() const { return circumstances_.world(); }

  const Catalogue* catalogue_;
  const Circumstances& circumstances_;
  ActUnderWay& act_;
};

}  // namespace continua
