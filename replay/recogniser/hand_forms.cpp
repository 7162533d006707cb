#include "continua/replay/recogniser/hand_forms.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "continua/core/read_document.h"

namespace continua {
namespace {

constexpr Finger fingers[] = {{"thumb", 2, 3, 4, 17},
                              {"index", 5, 6, 8, 0},
                              {"middle", 9, 10, 12, 0},
                              {"ring", 13, 14, 16, 0},
                              {"little", 17, 18, 20, 0}};
constexpr double most_measure = 100;

// How far the finger's tip is from the palm, as a multiple of its joint's distance.
double stretch(const Finger& finger, const HandPoints& points) {
  return (points[finger.tip] - points[finger.from]).norm() / (points[finger.joint] - points[finger.from]).norm();
}

// The part of the finger's direction that goes up, from -1 to 1.
double up(const Finger& finger, const HandPoints& points) {
  return -(points[finger.tip] - points[finger.knuckle]).normalized().y();
}

struct Measure {
  const char* name;
  double (*of)(const Finger& finger, const HandPoints& points);
};
constexpr Measure kinds[] = {{"stretch", stretch}, {"up", up}};

// "thumb.stretch", "thumb.up", "index.stretch", …
std::vector<std::string> measure_names() {
  std::vector<std::string> names;
  for (const auto& finger : fingers)
    for (const auto& kind : kinds) names.push_back(fmt::format("{}.{}", finger.name, kind.name));
  return names;
}

double value_of(std::size_t measure, const HandPoints& points) {
  return kinds[measure % std::size(kinds)].of(fingers[measure / std::size(kinds)], points);
}

const Finger* read_finger(const Item& item) {
  std::vector<std::string> names;
  for (const auto& finger : fingers) names.emplace_back(finger.name);
  const auto name = item.one_of(names, "a finger");
  const auto found =
      std::find_if(std::begin(fingers), std::end(fingers), [&](const Finger& one) { return one.name == name; });
  return name && found != std::end(fingers) ? &*found : nullptr;
}

HandForm read_form(const NamedItem& named) {
  HandForm form;
  form.name = named.key;
  if (!named.item.expect_object("a form", {"about", "points_with", "measures"})) return form;
  if (const auto pointer = named.item.member("points_with"); pointer.exists()) form.pointer = read_finger(pointer);
  static const auto names = measure_names();
  for (const auto& [key, item] : named.item.required("measures", "bounds of measures").members("bounds of measures")) {
    const auto at = std::find(names.begin(), names.end(), key);
    if (at == names.end()) item.problem_at_key(item.unknown("measure", key, names));
    const auto bounds = item.elements("the least and the most, [number, number]");
    if (bounds.size() != 2) item.problem("expected the least and the most, [number, number]");
    if (at == names.end() || bounds.size() != 2) continue;
    const double least = bounds[0].number("a number", 0, -most_measure, most_measure);
    form.bounds.push_back({static_cast<std::size_t>(at - names.begin()), least,
                           bounds[1].number("a number that is not less", most_measure, least, most_measure)});
  }
  return form;
}

HandPoints read_points(const Item& item) {
  HandPoints points;
  for (const auto& one : item.elements("the points of a hand")) {
    const auto numbers = one.elements("a point [x, y, z]");
    if (numbers.size() != 3) one.problem("expected a point [x, y, z]");
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 3); ++i)
      point[static_cast<Eigen::Index>(i)] = numbers[i].number("metres", 0, -most_measure, most_measure);
    points.push_back(point);
  }
  if (points.size() != points_of_hand)
    item.problem(fmt::format("found {} points; expected the {} of a hand", points.size(), points_of_hand));
  return points;
}

void check_example(const Item& item, const HandForms& forms) {
  if (!item.expect_object("an example", {"about", "form", "hand"})) return;
  const auto wanted = item.required("form", "the name of a form, or null");
  const auto points = read_points(item.required("hand", "the points of a hand"));
  if (!wanted.exists() || points.size() != points_of_hand) return;
  const auto* found = forms.find(points);
  if (const Json form = found ? Json(found->name) : Json(); form != wanted.json())
    wanted.problem(fmt::format("its form is {}, expected {}", compact(form), compact(wanted.json())));
}

HandForms forms_of(const Item& root) {
  std::vector<HandForm> forms;
  if (!root.expect_object("forms of a hand", {"hand_forms", "about", "forms", "examples"})) return HandForms({});
  root.expect_version("hand_forms", 1);
  for (const auto& named : root.required("forms", "forms by their names").members("forms by their names"))
    forms.push_back(read_form(named));
  HandForms all(std::move(forms));
  if (const auto examples = root.member("examples"); examples.exists())
    for (const auto& example : examples.elements("examples")) check_example(example, all);
  return all;
}

}  // namespace

const HandForm* HandForms::find(const HandPoints& points) const {
  if (points.size() != points_of_hand) return nullptr;
  const auto fits = [&](const HandForm& form) {
    return std::all_of(form.bounds.begin(), form.bounds.end(), [&](const HandForm::Bound& bound) {
      const double value = value_of(bound.measure, points);
      return value >= bound.least && value <= bound.most;
    });
  };
  const auto found = std::find_if(forms_.begin(), forms_.end(), fits);
  return found == forms_.end() ? nullptr : &*found;
}

Result<HandForms> read_hand_forms(std::string_view text, const std::string& path) {
  return parsed_document(text, path, forms_of);
}

std::vector<Error> hand_form_problems(std::string_view text, const std::string& path) {
  return problems_of_document(text, path, forms_of);
}

}  // namespace continua
