// Records of a run log about the avatar: its words and gestures, its acts, and the places of bodies.
#pragma once

#include <fmt/format.h>

#include "continua/replay/log/brief_words.h"
#include "continua/replay/log/fields.h"

namespace continua::log {

struct Utterance {
  std::string text;
  std::vector<std::int64_t> because;

  static constexpr Kind kind{.name = "utterance",
                             .when = "The avatar speaks. Words equal to the last are neither said again nor logged.",
                             .decision = Decision::yes,
                             .brief_adds = "“”"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("text", &Utterance::text, Says::what, "The words.", {.in_brief = true});
    use("because", &Utterance::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const { return fmt::format("“{}”", text); }
};

/// The avatar's; the human's gestures are inputs.
struct AvatarGesture {
  std::string gesture;
  std::vector<std::int64_t> because;

  static constexpr Kind kind{
      .name = "gesture", .when = "The avatar gestures or looks somewhere.", .decision = Decision::yes};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("gesture", &AvatarGesture::gesture, Says::what, "The avatar gesture.", {.form = "term", .in_brief = true});
    use("because", &AvatarGesture::because, Says::aside, of_sources, {.form = "record"});
  }
  std::string brief() const { return gesture; }
};

/// The result of an act, or of a step of one.
struct ActResult {
  std::optional<double> position_error_m, yaw_error;
  std::optional<std::string> reason, code;
  std::optional<std::vector<std::string>> objects, touches, moved_aside, retries;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("position_error_m", &ActResult::position_error_m, Says::aside, "Distance from the goal.", {.form = "metres"});
    use("yaw_error", &ActResult::yaw_error, Says::aside, "Turn from the goal.", {.form = "radians"});
    use("reason", &ActResult::reason, Says::aside, "The reason why it went otherwise, a sentence in English.");
    use("code", &ActResult::code, Says::aside, "The code of that reason, such as `too_wide` or `slipped`.");
    use("objects", &ActResult::objects, Says::aside,
        "The objects and participants that the reason is about, the most important first.");
    use("touches", &ActResult::touches, Says::aside,
        "Objects, and `table`, that the handled object touches in the end.");
    use("moved_aside", &ActResult::moved_aside, Says::aside, "Other objects that had to make room, in order.");
    use("retries", &ActResult::retries, Says::aside, "The reasons why earlier attempts failed, in order.");
  }
};

/// Status of an act that has not begun.
inline constexpr std::string_view asked = "asked";

struct Act {
  std::int64_t act = 0;
  std::string program = {}, status = {};
  std::optional<std::int64_t> step = {};
  std::optional<std::vector<std::int64_t>> because = {};
  std::optional<ActResult> result = {};

  static constexpr Kind kind{.name = "act",
                             .when =
                                 "An act is asked for, or its state changed; with `step`, the state of a step that "
                                 "the body does itself. The `cause` of all but the first is the first.",
                             .decision = Decision::outcome};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("act", &Act::act, Says::where, "Running number of the act, from 1.");
    use("program", &Act::program, Says::what, "The act, or the step: `move(cup, on(plate))`.",
        {.form = "term", .in_brief = true});
    use("status", &Act::status, Says::what,
        "`asked`, `started`, `done`, `missed`, `dropped`, `blocked`, `unreachable`, `unstable` (the object moved "
        "again within a second) or `stopped` (given up). A step that needs no doing is `done` alone.",
        {.in_brief = true});
    use("step", &Act::step, Says::where, "Running number of the step within the act, from 1.");
    use("because", &Act::because, Says::aside, "When asked for: the records that it came of.", {.form = "record"});
    use("result", &Act::result, Says::aside, "When it has ended: how it went.");
  }
  std::string brief() const { return joined({status, program}); }
};

/// [x, y, z, qw, qx, qy, qz] in frame W, metres.
using PoseNumbers = std::array<double, 7>;

struct Pose {
  Named<PoseNumbers> bodies;

  static constexpr Kind kind{.name = "pose", .when = "Bodies moved.", .stop = Stop::never, .brief_adds = "bodies"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("bodies", &Pose::bodies, Says::what, "{body: [x, y, z, qw, qx, qy, qz]} in frame W.",
        {.form = "metres", .in_brief = true});
  }
  std::string brief() const { return fmt::format("{} bodies", bodies.size()); }
};

struct Rest {
  double from_s = 0, to_s = 0;

  static constexpr Kind kind{.name = "rest",
                             .when = "Physics was not stepped, since nothing moved. Written at the end of the rest.",
                             .stop = Stop::never,
                             .brief_adds = "– s"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("from", &Rest::from_s, Says::where, "Its beginning.", {.form = "seconds", .in_brief = true});
    use("to", &Rest::to_s, Says::where, "Its end.", {.form = "seconds", .in_brief = true});
  }
  std::string brief() const { return fmt::format("{} – {} s", number_text(from_s), number_text(to_s)); }
};

using RecordsOfAvatar = Kinds<Utterance, AvatarGesture, Act, Pose, Rest>;

}  // namespace continua::log
