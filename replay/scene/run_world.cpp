#include "continua/replay/scene/run_world.h"

#include <algorithm>

#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_words.h"

namespace continua {
namespace {

constexpr std::size_t most = 5000;  // changes, samples, acts in one window

// Whether `list` is `count` numbers.
bool is_numbers(const Json& list, std::size_t count) {
  return list.is_array() && list.size() == count &&
         std::all_of(list.begin(), list.end(), [](const Json& one) { return one.is_number(); });
}

// Vertices and faces as the log has them: triples, and of faces the numbers of vertices.
bool is_mesh(const Json& mesh) {
  const auto& vertices = member_of(mesh, "vertices");
  const auto& faces = member_of(mesh, "faces");
  if (!is_numbers(vertices, vertices.size()) || !vertices.is_array() || vertices.size() % 3 != 0) return false;
  if (!faces.is_array() || faces.size() % 3 != 0) return false;
  const auto count = vertices.size() / 3;
  return std::all_of(faces.begin(), faces.end(),
                     [&](const Json& face) { return face.is_number_unsigned() && face.get<std::size_t>() < count; });
}

// A geom as the log has it, as far as a viewer needs it; null where it cannot be drawn.
Json geom_json(const Json& geom) {
  const auto& body = member_of(geom, "body");
  const auto& type = member_of(geom, "type");
  if (!body.is_string() || !type.is_string() || !is_numbers(member_of(geom, "size"), 3)) return nullptr;
  Json drawn{{"body", body}, {"type", type}, {"size", geom["size"]}};
  const auto or_else = [&](const char* key, Json otherwise) {
    const auto& found = member_of(geom, key);
    drawn[key] = is_numbers(found, otherwise.size()) ? found : std::move(otherwise);
  };
  or_else("rgba", {0.5, 0.5, 0.5, 1});
  or_else("pos", {0, 0, 0});
  or_else("quat", {1, 0, 0, 0});
  if (const auto& mesh = member_of(geom, "mesh"); is_mesh(mesh)) drawn["mesh"] = mesh;
  return drawn;
}

Json poses_json(const BodyPoses& poses) {
  Json bodies = Json::object();
  for (const auto& [name, pose] : poses) bodies.get_ref<Json::object_t&>().emplace_back(name, pose);
  return bodies;
}

Json point_or_null(const std::optional<Point>& point) { return point ? Json(*point) : Json(); }
Json name_or_null(const std::string& name) { return name.empty() ? Json() : Json(name); }

// The instant of `times` up to which no more than `most` of them lie, if there are more and it lies after `from`.
std::optional<SimTime> full_at(std::vector<SimTime> times, SimTime from) {
  if (times.size() <= most) return std::nullopt;
  std::nth_element(times.begin(), times.begin() + most - 1, times.end());
  const auto t = times[most - 1];
  return t > from ? std::optional(t) : std::nullopt;
}

}  // namespace

Result<Json> run_scene(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  const auto& scene = member_of(*header, "scene");
  if (!member_of(scene, "bodies").is_object())
    return Error{run.where(0), "the log carries no scene with the poses of its bodies: nothing to show"};
  BodyPoses bodies;
  for (const auto& [name, numbers] : scene["bodies"].items())
    if (const auto pose = pose_in(numbers)) bodies.emplace(name, *pose);
  Json geoms = Json::array();
  if (const auto& all = member_of(scene, "geoms"); all.is_array())
    for (const auto& geom : all)
      if (auto drawn = geom_json(geom); !drawn.is_null()) geoms.push_back(std::move(drawn));
  const RunWords words(text_of(scene, "mjcf"));
  Json titles = Json::object();
  for (const auto& [name, pose] : bodies)
    if (auto title = words.thing(name); title != name) titles[name] = std::move(title);
  return Json{{"geoms", std::move(geoms)}, {"bodies", poses_json(bodies)}, {"titles", std::move(titles)}};
}

Result<std::shared_ptr<RunWorld>> RunWorld::read(std::shared_ptr<const RunIndex> run) {
  const auto& header = run->header();
  if (!header) return header.error();
  auto pointings = read_pointings(*run);
  if (!pointings) return pointings.error();
  auto acts = read_acts(*run, bodies_of(*header));
  if (!acts) return acts.error();
  const std::shared_ptr<RunWorld> world(
      new RunWorld(std::move(run), RunWords(text_of(member_of(*header, "scene"), "mjcf"))));
  world->pointings_ = std::move(*pointings);
  world->acts_ = std::move(*acts);
  return world;
}

std::optional<Point> RunWorld::place_of(const std::string& body, SimTime t) {
  const auto poses = poses_.at(t);
  const auto found = poses.find(body);
  if (found == poses.end()) return std::nullopt;
  return Point{found->second[0], found->second[1], found->second[2]};
}

std::optional<Point> RunWorld::target_of(const RunAct& act) {
  if (act.place || act.beside.empty()) return act.place;
  return act.done && !act.object.empty() ? place_of(act.object, act.until) : place_of(act.beside, act.from);
}

Json RunWorld::pointing_json(const RunPointing& pointing, SimTime from, SimTime to) {
  Json samples = Json::array();
  std::optional<Point> origin;
  const auto later = [](SimTime t, const RunPointing::Sample& sample) { return t < sample.t; };
  auto sample = std::upper_bound(pointing.samples.begin(), pointing.samples.end(), from, later);
  if (sample != pointing.samples.begin()) --sample;
  for (; sample != pointing.samples.end() && sample->t <= to && samples.size() <= most; ++sample) {
    auto target = sample->at.target;
    if (!pointing.on_body.empty()) target = place_of(pointing.on_body, sample->t).value_or(target);
    if (!origin) origin = sample->at.origin;
    samples.push_back({sample->t.seconds(), target[0], target[1], target[2]});
  }
  return {{"who", pointing.avatar ? "avatar" : "human"},
          {"hand", pointing.hand},
          {"from", pointing.from.seconds()},
          {"to", pointing.until.seconds()},
          {"n", pointing.records.front()},
          {"origin", point_or_null(origin)},
          {"samples", std::move(samples)}};
}

Json RunWorld::window(SimTime from, SimTime to) {
  const auto changes = poses_.changes(from, to, most);
  auto until = changes.next.value_or(to);
  std::vector<SimTime> samples, begun;
  for (const auto& pointing : pointings_)
    for (const auto& sample : pointing.samples)
      if (sample.t > from && sample.t <= until) samples.push_back(sample.t);
  until = std::min(until, full_at(std::move(samples), from).value_or(until));
  for (const auto& act : acts_)
    if (act.from <= until && act.until >= from) begun.push_back(act.from);
  until = std::min(until, full_at(std::move(begun), from).value_or(until));

  Json answer{{"from", from.seconds()}, {"to", until.seconds()}, {"start", poses_json(poses_.at(from))}};
  auto& moved = answer["changes"] = Json::array();
  for (const auto& change : changes.list)
    if (change.t <= until) moved.push_back({change.t.seconds(), poses_json(change.bodies)});
  auto& pointing = answer["pointing"] = Json::array();
  for (const auto& one : pointings_)
    if (one.from <= until && one.until >= from && pointing.size() < most)
      pointing.push_back(pointing_json(one, from, until));
  auto& acts = answer["acts"] = Json::array();
  for (const auto& act : acts_)
    if (act.from <= until && act.until >= from && acts.size() < most)
      acts.push_back({{"n", act.n},
                      {"act", act.act},
                      {"program", act.program},
                      {"told", words_.term(act.program)},
                      {"status", act.status},
                      {"from", act.from.seconds()},
                      {"to", act.until.seconds()},
                      {"object", name_or_null(act.object)},
                      {"target", point_or_null(target_of(act))}});
  if (until < to) answer["next"] = until.seconds();
  return answer;
}

}  // namespace continua
