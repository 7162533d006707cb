#include "continua/behaviour/performance.h"

#include <algorithm>
#include <utility>

#include "continua/behaviour/performance_turn.h"
#include "continua/behaviour/planner.h"

namespace continua {
namespace {

using Status = ActReport::Status;

bool moves_arm(Capability what) { return effect_of(what) != ActEffect::announced; }

bool stops(const Term& program, Perspective perspective) {
  const auto command = plan(program, false, perspective);
  return command && command->what == Capability::stop;
}

// Records where the things that moved had been before the act.
void remember_places(const ActUnderWay& act, const WorldSnapshot& world, EarlierPlaces& earlier) {
  for (const auto& object : world.objects) {
    const auto before = act.before.find(object.name);
    if (before == act.before.end() || (object.p_WO - before->second).norm() <= contact_m) continue;
    const auto& place = act.places_before.at(object.name);
    earlier.was[object.name] = place;
    earlier.originally.emplace(object.name, place);
  }
}

ActUnderWay under_way(AskedAct act, const WorldSnapshot& world) {
  ActUnderWay doing;
  doing.end.act = std::move(act);
  doing.held_before = world.held;
  doing.before = places_of(world);
  for (const auto& object : world.objects) doing.places_before.emplace(object.name, place_term(object, world));
  return doing;
}

}  // namespace

void Performer::begin(Performance& performance, AskedAct act) const {
  performance.stopping = performance.stopping || stops(act.program, perspective_);
  performance.waiting.emplace_back(std::move(act));
}

std::optional<AvatarCommand> Performer::begin(Performance& performance, AvatarCommand gesture) const {
  gesture.id = ++performance.commands;
  if (performance.idle() || !moves_arm(gesture.what)) return gesture;
  performance.waiting.emplace_back(std::move(gesture));
  return std::nullopt;
}

std::optional<PerformanceEvent> Performer::next(Performance& performance, const WorldSnapshot& world) const {
  if (performance.stopping) give_up(performance, world);
  if (!performance.given_up.empty()) {
    ActEnd end = std::move(performance.given_up.front());
    performance.given_up.erase(performance.given_up.begin());
    return end;
  }
  if (!performance.doing) {
    if (performance.waiting.empty()) return std::nullopt;
    auto waiting = std::move(performance.waiting.front());
    performance.waiting.erase(performance.waiting.begin());
    if (auto* gesture = std::get_if<AvatarCommand>(&waiting)) return GestureCommand{std::move(*gesture)};
    performance.doing = under_way(std::get<AskedAct>(std::move(waiting)), world);
    const Circumstances circumstances(perspective_, world, performance.doing->brought);
    PerformanceTurn(catalogue_, circumstances, *performance.doing).begin(performance.earlier);
  }
  ActUnderWay& doing = *performance.doing;
  if (doing.accepted && !doing.begun && !doing.ending) {
    doing.begun = true;
    return ActBegun{doing.end.act};
  }
  if (doing.in_flight) return std::nullopt;
  const Circumstances circumstances(perspective_, world, doing.brought);
  if (auto step = PerformanceTurn(catalogue_, circumstances, doing).step()) {
    if (step->command) doing.in_flight = step->command->id = ++performance.commands;
    return *std::move(step);
  }
  // Movements while the body comes to a stop belong to the stopped act.
  if (!stops(doing.end.act.program, perspective_)) remember_places(doing, world, performance.earlier);
  ActEnd end = std::move(doing.end);
  performance.doing.reset();
  return end;
}

// Cancels everything before the last stop.
void Performer::give_up(Performance& performance, const WorldSnapshot& world) const {
  performance.stopping = false;
  const auto stop = [&](ActEnd end) {
    end.status = Status::stopped;
    performance.given_up.push_back(std::move(end));
  };
  if (performance.doing) {
    remember_places(*performance.doing, world, performance.earlier);
    stop(std::move(performance.doing->end));
    performance.doing.reset();
  }
  const auto is_stop = [&](const auto& waiting) {
    const auto* asked = std::get_if<AskedAct>(&waiting);
    return asked && stops(asked->program, perspective_);
  };
  auto& waiting = performance.waiting;
  const auto last = std::find_if(waiting.rbegin(), waiting.rend(), is_stop).base() - 1;
  for (auto each = waiting.begin(); each != last; ++each)
    if (auto* asked = std::get_if<AskedAct>(&*each)) stop(ActEnd{.act = std::move(*asked)});
  waiting.erase(waiting.begin(), last);
}

void Performer::reported(Performance& performance, const ActReport& report) const {
  if (!performance.doing || performance.doing->in_flight != report.id) return;
  ActUnderWay& doing = *performance.doing;
  doing.accepted = true;
  if (report.status == Status::started) return;
  doing.in_flight.reset();
  if (doing.ending) return;
  ActEnd& end = doing.end;
  if (report.position_error_m > 0) end.position_error_m = report.position_error_m;
  if (report.yaw_error != 0) end.yaw_error = report.yaw_error;
  if (!report.reason.empty()) end.reason = report.reason;
  end.touches = report.touches;
  end.moved_aside.insert(end.moved_aside.end(), report.moved_aside.begin(), report.moved_aside.end());
  end.retries.insert(end.retries.end(), report.retries.begin(), report.retries.end());
  if (report.status == Status::done) return;
  end.status = report.status;
  doing.ending = true;
}

}  // namespace continua
