// A run log with a scene that can be drawn: a block that is pointed at, asked about and moved.
#pragma once

#include <string>

#include "replay/inspector/inspector_log.h"

namespace continua {

inline LogBuilder drawable_log() {
  const std::string mjcf =
      "<mujoco><worldbody><body name='table'><geom name='table_top' type='box' size='.5 .4 .01' pos='0 0 -.01'/></body>"
      "<body name='block1' pos='.2 .1 .05'><freejoint/><geom type='box' size='.05 .05 .05' rgba='1 0 0 1'/></body>"
      "</worldbody></mujoco>";
  const Json table{0, 0, 0, 1, 0, 0, 0}, block{0.2, 0.1, 0.05, 1, 0, 0, 0};
  LogBuilder log;
  log.add("run", 0, {{"version", 1}, {"scene", {{"mjcf", mjcf}, {"bodies", {{"table", table}, {"block1", block}}}}}});
  const auto said =
      log.add("input", 1, {{"line", 2}, {"event", {{"kind", "speech"}, {"text", "Put it there."}, {"until", 2}}}});
  const auto shown = log.add(
      "input", 1.5,
      {{"line", 3},
       {"event",
        {{"kind", "gesture"}, {"name", "point"}, {"phase", "stroke"}, {"target", {-0.2, -0.1}}, {"until", 2}}}});
  log.add("transition", 2, {{"id", "go"}, {"to", "Ready"}}, static_cast<int>(said));
  log.add("utterance", 2, {{"text", "Okay."}, {"because", {said, shown}}});
  const auto act = [&](double t, Json fields) { log.add("act", t, fields); };
  act(2, {{"act", 1}, {"program", "put(block1, <-0.2, -0.1, 0>)"}, {"status", "asked"}});
  act(2, {{"act", 1}, {"program", "put(block1, <-0.2, -0.1, 0>)"}, {"status", "started"}});
  log.add("pose", 2.4, {{"bodies", {{"block1", {0.0, 0.0, 0.1, 1, 0, 0, 0}}}}});
  log.add("pose", 2.44, {{"bodies", {{"block1", {-0.2, -0.1, 0.05, 1, 0, 0, 0}}}}});
  act(3.5, {{"act", 1}, {"program", "put(block1, <-0.2, -0.1, 0>)"}, {"status", "done"}});
  log.add("end", 20, {{"counts", Json::object()}});
  return log;
}

}  // namespace continua
