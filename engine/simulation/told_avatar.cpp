#include "continua/simulation/told_avatar.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/angles.h"
#include "continua/core/located_json.h"
#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/avatar_guess.h"
#include "continua/simulation/mjcf_tags.h"

namespace continua {

namespace {

constexpr std::array pad_names = {"pad_left", "pad_right"};

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// Nothing if a part is no number.
std::optional<std::vector<double>> numbers_of(const std::vector<std::string>& parts) {
  std::vector<double> numbers;
  for (const auto& part : parts) {
    double number = 0;
    const auto [end, wrong] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (wrong != std::errc() || end != part.data() + part.size()) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

std::string text_of(const Pose& X_AB) {
  const Vec3& p = X_AB.p_WB;
  const auto& q = X_AB.R_WB;
  return fmt::format("pos=\"{:.9g} {:.9g} {:.9g}\" quat=\"{:.9g} {:.9g} {:.9g} {:.9g}\"", p.x() + 0.0, p.y() + 0.0,
                     p.z() + 0.0, q.w() + 0.0, q.x() + 0.0, q.y() + 0.0, q.z() + 0.0);
}

std::vector<std::string> names_of(const mjModel& model, mjtObj type, std::ptrdiff_t count) {
  std::vector<std::string> names;
  for (int id = 0; id < count; ++id)
    if (const char* name = mj_id2name(&model, type, id)) names.push_back(name);
  return names;
}

/// The tags of a body, MuJoCo's numbers in the order of the text.
struct BodyTags {
  Tag open;
  std::size_t end = 0;  // of the whole element
  std::vector<Tag> geoms;
};

std::vector<BodyTags> bodies_of(std::string_view text) {
  std::vector<BodyTags> bodies(1);  // the world
  std::vector<std::size_t> around = {0};
  for (auto tag = next_tag(text, 0); tag; tag = next_tag(text, tag->end)) {
    if (tag->name == "body") {
      if (!tag->self_closing) around.push_back(bodies.size());
      bodies.push_back({*tag, tag->end, {}});
    } else if (tag->name == "/body" && around.size() > 1) {
      bodies[around.back()].end = tag->end;
      around.pop_back();
    } else if (tag->name == "geom") {
      bodies[around.back()].geoms.push_back(*tag);
    }
  }
  return bodies;
}

/// Turns one text `avatar` into elements.
class Teller {
 public:
  Teller(const SceneSource& source, const mjModel& model, const Tag& tag)
      : source_(source), text_(source.text()), model_(model), tag_(tag), bodies_(bodies_of(text_)) {
    where_ = source.where(line_of(text_, tag.begin));
  }

  Result<ToldAvatar> tell() {
    const auto lines = std::count(text_.data() + tag_.begin, text_.data() + tag_.end, '\n');
    changes_.push_back({tag_.begin, tag_.end, std::string(static_cast<std::size_t>(lines), '\n')});
    for (const auto part : {&Teller::read_words, &Teller::find_hand, &Teller::find_pads, &Teller::find_grip,
                            &Teller::find_home, &Teller::find_base})
      if (auto wrong = (this->*part)()) return *wrong;
    return ToldAvatar{source_.with_changes(changes_).with(added_), guesses_};
  }

 private:
  Error wrong(const std::string& sentence) const { return {where_, sentence}; }

  Error no_such(const std::string& word, const std::string& kind, const std::string& name,
                const std::vector<std::string>& known) const {
    return wrong(fmt::format("{}: the scene has no {} '{}'{}", word, kind, name, did_you_mean(name, known)));
  }

  std::string place_of(int body) const {
    return source_.where(line_of(text_, bodies_[static_cast<std::size_t>(body)].open.begin));
  }

  void guess(int body, const std::string& sentence) {
    guesses_.push_back(fmt::format("{}: guessed: {}", place_of(body), sentence));
  }

  std::string body_name(int body) const { return name_of(model_, mjOBJ_BODY, body); }

  Outcome read_words() {
    const std::vector<std::string> known = {"hand", "pads", "grip", "home", "base"};
    for (const auto& word : words_of(value_of(text_, tag_, "data").value_or(""))) {
      const std::size_t equals = word.find('=');
      const auto name = word.substr(0, equals);
      if (std::find(known.begin(), known.end(), name) == known.end())
        return wrong(fmt::format("'{}' is no word about an avatar{}; expected {}=…", name, did_you_mean(name, known),
                                 fmt::join(known, "=…, ")));
      const auto values = equals == std::string::npos ? std::vector<std::string>() : parts_of(word.substr(equals + 1));
      if (values.empty()) return wrong(fmt::format("'{}' has no value; expected {}=…", name, name));
      told_[name] = values;
    }
    // Composites and their like make bodies that the text does not have.
    if (static_cast<int>(bodies_.size()) != model_.nbody)
      return wrong(fmt::format("an avatar cannot be told in a scene of {} elements <body> that make {} bodies",
                               bodies_.size() - 1, model_.nbody - 1));
    return {};
  }

  Outcome find_hand() {
    const int grip = id_of(model_, mjOBJ_SITE, grip_name);
    if (grip >= 0) hand_ = model_.site_bodyid[grip];
    const auto told = told_.find("hand");
    if (told == told_.end()) return {};
    hand_ = id_of(model_, mjOBJ_BODY, told->second[0]);
    if (hand_ < 1) return no_such("hand", "body", told->second[0], names_of(model_, mjOBJ_BODY, model_.nbody));
    return {};
  }

  Outcome find_pads() {
    std::array<int, 2> bodies{};
    for (int side = 0; side < 2; ++side) pads_[side] = id_of(model_, mjOBJ_GEOM, pad_names[side]);
    const auto told = told_.find("pads");
    if (told == told_.end() && pads_[0] >= 0 && pads_[1] >= 0) return {};
    if (told != told_.end()) {
      if (told->second.size() != 2) return wrong("pads: expected the names of two geoms or bodies, pads=LEFT,RIGHT");
      for (int side = 0; side < 2; ++side) {
        const auto& name = told->second[side];
        pads_[side] = id_of(model_, mjOBJ_GEOM, name);
        bodies[side] = pads_[side] < 0 ? id_of(model_, mjOBJ_BODY, name) : model_.geom_bodyid[pads_[side]];
        if (bodies[side] < 1) return no_such("pads", "geom or body", name, names_of(model_, mjOBJ_BODY, model_.nbody));
      }
    } else if (const auto fingers = guess_fingers(model_, std::max(0, hand_))) {
      bodies = *fingers;
      pads_ = {-1, -1};
      for (const int body : bodies)
        guess(body, fmt::format("body '{}' is a finger, on a slide joint", body_name(body)));
    } else {
      return wrong("no two fingers on slide joints of one body are seen; expected pads=LEFT,RIGHT, geoms or bodies");
    }
    return name_pads(bodies);
  }

  Outcome name_pads(const std::array<int, 2>& bodies) {
    if (bodies[0] == bodies[1]) return wrong("pads: both are of one body; expected two fingers");
    for (int side = 0; side < 2; ++side) {
      const int body = bodies[side];
      if (pads_[side] < 0) {
        const auto pad = guess_pad(model_, body, bodies[1 - side]);
        if (!pad) return wrong(fmt::format("pads: body '{}' has no geom that can touch things", body_name(body)));
        pads_[side] = *pad;
        guess(model_.geom_bodyid[*pad], fmt::format("geom {} of body '{}' is the pad that presses",
                                                    *pad - model_.body_geomadr[model_.geom_bodyid[*pad]] + 1,
                                                    body_name(model_.geom_bodyid[*pad])));
      }
      name_geom(pads_[side], pad_names[side]);
    }
    return {};
  }

  void name_geom(int geom, const std::string& name) {
    const int body = model_.geom_bodyid[geom];
    const Tag& tag =
        bodies_[static_cast<std::size_t>(body)].geoms[static_cast<std::size_t>(geom - model_.body_geomadr[body])];
    const auto old = attribute_of(text_, tag, "name");
    if (!old) {
      const std::size_t at = tag.begin + std::string_view("<geom").size();
      return changes_.push_back({at, at, fmt::format(" name=\"{}\"", name)});
    }
    for (auto other = next_tag(text_, 0); other; other = next_tag(text_, other->end))
      for (const char* attribute : {"name", "geom", "geom1", "geom2"}) {
        const auto found = attribute_of(text_, *other, attribute);
        const bool is_it = std::string_view(attribute) != "name" || other->begin == tag.begin;
        if (found && is_it && found->value == old->value) changes_.push_back({found->begin, found->end, name});
      }
  }

  Outcome find_grip() {
    const auto told = told_.find("grip");
    const int there = id_of(model_, mjOBJ_SITE, grip_name);
    if (there >= 0 && told == told_.end()) return {};
    if (there >= 0) return wrong("grip: the scene has a site 'grip' already");
    const int carrier = carrier_of(model_, model_.geom_bodyid[pads_[0]], model_.geom_bodyid[pads_[1]]);
    if (hand_ < 0) {
      hand_ = carrier;
      if (hand_ < 1) return wrong("the pads have no hand in common; expected hand=BODY, which carries both");
      guess(hand_, fmt::format("body '{}' is the hand, which carries both fingers", body_name(hand_)));
    }
    if (carrier_of(model_, carrier, hand_) != hand_)
      return wrong(fmt::format("hand: body '{}' does not carry both pads", body_name(hand_)));
    Pose X_HT = guess_grip(model_, hand_, pads_);
    if (told == told_.end()) {
      guess(hand_, fmt::format("the grip is between the pads, at ({:.4f}, {:.4f}, {:.4f}) of body '{}'", X_HT.p_WB.x(),
                               X_HT.p_WB.y(), X_HT.p_WB.z(), body_name(hand_)));
    } else if (auto wrong = read_grip(told->second, X_HT)) {
      return wrong;
    }
    const Tag& open = bodies_[static_cast<std::size_t>(hand_)].open;
    changes_.push_back({open.end, open.end, fmt::format("<site name=\"{}\" {}/>", grip_name, text_of(X_HT))});
    return {};
  }

  /// The place of the grip in the hand, as told; the axes are seen from the fingers.
  Outcome read_grip(const std::vector<std::string>& told, Pose& X_HT) const {
    if (const auto place = numbers_of(told); place && place->size() == 3) {
      X_HT.p_WB = {(*place)[0], (*place)[1], (*place)[2]};
      return {};
    }
    const int site = told.size() == 1 ? id_of(model_, mjOBJ_SITE, told[0]) : -1;
    if (told.size() != 1) return wrong("grip: expected a site, or its place in the hand, grip=X,Y,Z");
    if (site < 0) return no_such("grip", "site", told[0], names_of(model_, mjOBJ_SITE, model_.nsite));
    if (model_.body_weldid[model_.site_bodyid[site]] != model_.body_weldid[hand_])
      return wrong(fmt::format("grip: site '{}' moves against body '{}'", told[0], body_name(hand_)));
    const DataOwner data(mj_makeData(&model_));
    mj_kinematics(&model_, data.get());
    const Pose X_WH{vec_of(data->xpos + 3 * hand_), quat_of(data->xquat + 4 * hand_)};
    X_HT.p_WB = (inverse(X_WH) * Pose{vec_of(data->site_xpos + 3 * site), {}}).p_WB;
    return {};
  }

  Outcome find_home() {
    const auto told = told_.find("home");
    const bool there = id_of(model_, mjOBJ_NUMERIC, "arm_home") >= 0;
    if (there && told == told_.end()) return {};
    if (there) return wrong("home: the scene has numbers 'arm_home' already");
    const auto hinges = hinges_to(model_, hand_);
    std::optional<std::vector<double>> angles;
    if (told != told_.end()) angles = numbers_of(told->second);
    if (!angles) {
      const auto& keys = source_.keyframes();
      const std::string name = told == told_.end() ? "home" : told->second[0];
      const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto& one) { return one.name == name; });
      if (key == keys.end() && told != told_.end())
        return wrong(fmt::format("home: no keyframe '{}', and no angles of {} hinges", name, hinges.size()));
      if (key == keys.end()) {
        guess(hand_, "the arm is at home where its joints are zero; better told: home=ANGLE,…");
        return {};
      }
      angles = angles_of(*key, hinges);
      if (!angles)
        return Error{key->where, fmt::format("the keyframe has no number for each of {} hinges", hinges.size())};
      if (told == told_.end())
        guesses_.push_back(fmt::format("{}: guessed: keyframe '{}' is the arm's posture at home", key->where, name));
    }
    if (angles->size() != hinges.size())
      return wrong(fmt::format("home: {} angles; the arm has {} hinges", angles->size(), hinges.size()));
    added_ = fmt::format("<custom><numeric name=\"arm_home\" data=\"{}\"/></custom>", fmt::join(*angles, " "));
    return {};
  }

  /// The hinges' part of a keyframe of the arm's own file, which is about the arm alone.
  std::optional<std::vector<double>> angles_of(const SceneSource::Keyframe& key, const std::vector<int>& hinges) const {
    const auto numbers = numbers_of(words_of(key.qpos));
    if (!numbers || hinges.empty()) return std::nullopt;
    const int first = model_.jnt_qposadr[hinges.front()];
    std::vector<double> angles;
    for (const int hinge : hinges) {
      const auto at = static_cast<std::size_t>(model_.jnt_qposadr[hinge] - first);
      if (at >= numbers->size()) return std::nullopt;
      angles.push_back((*numbers)[at]);
    }
    return angles;
  }

  /// Puts the arm's outermost body into a body at the told place.
  Outcome find_base() {
    const auto told = told_.find("base");
    if (told == told_.end()) return {};
    const auto numbers = numbers_of(told->second);
    if (!numbers || numbers->size() < 3 || numbers->size() > 4)
      return wrong("base: expected a place in metres and a turn in degrees, base=X,Y,Z,TURN");
    int root = hand_;
    while (model_.body_parentid[root] > 0) root = model_.body_parentid[root];
    const double turn = numbers->size() == 4 ? (*numbers)[3] * rad_per_deg : 0;
    const Pose X_WA{{(*numbers)[0], (*numbers)[1], (*numbers)[2]},
                    Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3::UnitZ()))};
    const auto& tags = bodies_[static_cast<std::size_t>(root)];
    changes_.push_back(
        {tags.open.begin, tags.open.begin, fmt::format("<body name=\"avatar_base\" {}>", text_of(X_WA))});
    changes_.push_back({tags.end, tags.end, "</body>"});
    return {};
  }

  const SceneSource& source_;
  const std::string& text_;
  const mjModel& model_;
  const Tag tag_;
  const std::vector<BodyTags> bodies_;
  std::string where_, added_;
  std::map<std::string, std::vector<std::string>> told_;
  std::vector<SceneSource::Change> changes_;
  std::vector<std::string> guesses_;
  int hand_ = -1;
  std::array<int, 2> pads_{};
};

}  // namespace

Result<ToldAvatar> with_told_avatar(const SceneSource& source, const mjModel& model) {
  for (auto tag = next_tag(source.text(), 0); tag; tag = next_tag(source.text(), tag->end))
    if (tag->name == "text" && value_of(source.text(), *tag, "name") == "avatar")
      return Teller(source, model, *tag).tell();
  return ToldAvatar{source, {}};
}

}  // namespace continua
