#include "continua/replay/export/badge_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace continua {
namespace {

constexpr double air = 1.5;  ///< between a badge and all else, in pixels
// Costs, in shares of a line's length: of a foreign line below the badge, of a place beside the line for each step.
constexpr double of_line_below = 0.3, of_step_aside = 2;
constexpr double aside_px = 5;
constexpr int most_aside = 8;

double length_of(const std::vector<PagePoint>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return length;
}

// Boxes and points of lines by the squares of the page that they are in, so that a place asks its own squares alone.
class Squares {
 public:
  void add(const PageBox& box) {
    each_square(box, [&](Square& square) { square.boxes.push_back(box); });
  }
  void add(const std::vector<PagePoint>& line, std::size_t number) {
    for (const auto& point : line)
      each_square({point, 0, 0}, [&](Square& square) { square.points.emplace_back(point, number); });
  }
  bool is_taken(const PageBox& box) {
    bool taken = false;
    each_square(box, [&](const Square& square) {
      taken = taken || std::any_of(square.boxes.begin(), square.boxes.end(), [&](auto& one) { return one.meets(box); });
    });
    return taken;
  }
  // How many lines but that of this number pass through the box.
  std::size_t lines_in(const PageBox& box, std::size_t own) {
    std::set<std::size_t> lines;
    each_square(box, [&](const Square& square) {
      for (const auto& [point, number] : square.points)
        if (number != own && box.meets({point, 0, 0})) lines.insert(number);
    });
    return lines.size();
  }

 private:
  struct Square {
    std::vector<PageBox> boxes;
    std::vector<std::pair<PagePoint, std::size_t>> points;
  };
  static constexpr double side_px = 32;

  template <typename Act>
  void each_square(const PageBox& box, const Act& act) {
    const auto [x, y] = box.centre;
    const auto index = [](double at) { return static_cast<int>(std::floor(at / side_px)); };
    for (int i = index(x - box.width / 2); i <= index(x + box.width / 2); ++i)
      for (int j = index(y - box.height / 2); j <= index(y + box.height / 2); ++j) act(squares_[{i, j}]);
  }

  std::map<std::pair<int, int>, Square> squares_;
};

class Places {
 public:
  Places(const std::vector<Badge>& badges, const std::vector<PageBox>& boxes,
         const std::vector<std::vector<PagePoint>>& others)
      : badges_(badges) {
    for (const auto& box : boxes) squares_.add(box);
    for (std::size_t i = 0; i < badges.size(); ++i) squares_.add(badges[i].line, i);
    for (std::size_t i = 0; i < others.size(); ++i) squares_.add(others[i], badges.size() + i);
  }

  BadgePlaces found() {
    BadgePlaces places{std::vector<PagePoint>(badges_.size()), true};
    // Short lines first: they have the fewest places.
    std::vector<std::size_t> order(badges_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::lround(length_of(badges_[a].line)) < std::lround(length_of(badges_[b].line));
    });
    for (const auto badge : order) {
      best_ = {};
      for (int aside = 0; aside <= most_aside && best_.cost > of_step_aside * aside; ++aside) look_at(badge, aside);
      places.centres[badge] = best_.centre.value_or(badges_[badge].line[badges_[badge].line.size() / 2]);
      places.apart = places.apart && best_.centre;
      squares_.add(PageBox{places.centres[badge], badges_[badge].width, badges_[badge].height});
    }
    return places;
  }

 private:
  struct Best {
    std::optional<PagePoint> centre;
    double cost = 1e9;
  };

  // All places of a badge that are so many steps beside its line.
  void look_at(std::size_t badge, int aside) {
    const auto& [line, width, height] = badges_[badge];
    const auto middle_place = line.size() / 2;
    for (std::size_t step = 0; step < line.size(); ++step) {
      // From the middle outward: middle, middle - 1, middle + 1, …
      const auto i = step % 2 == 1 ? middle_place - (step + 1) / 2 : middle_place + step / 2;
      const auto &before = line[i == 0 ? 0 : i - 1], &after = line[std::min(i + 1, line.size() - 1)];
      const double dx = after.x - before.x, dy = after.y - before.y, length = std::max(std::hypot(dx, dy), 1e-6);
      for (const double side : {1.0, -1.0}) {
        const double shift = side * aside * aside_px;
        const PageBox box{{line[i].x - dy / length * shift, line[i].y + dx / length * shift}, width, height};
        const double middle = std::abs(static_cast<double>(2 * i + 1) / static_cast<double>(line.size()) - 1) / 2;
        consider(badge, box, middle + of_step_aside * aside);
        if (aside == 0) break;
      }
    }
  }

  void consider(std::size_t badge, const PageBox& box, double cost) {
    if (cost >= best_.cost) return;
    const PageBox wide{box.centre, box.width + 2 * air, box.height + 2 * air};
    if (squares_.is_taken(wide)) return;
    cost += of_line_below * static_cast<double>(squares_.lines_in(wide, badge));
    if (cost < best_.cost) best_ = {box.centre, cost};
  }

  const std::vector<Badge>& badges_;
  Squares squares_;
  Best best_;
};

}  // namespace

bool PageBox::meets(const PageBox& other) const {
  return std::abs(centre.x - other.centre.x) < (width + other.width) / 2 &&
         std::abs(centre.y - other.centre.y) < (height + other.height) / 2;
}

BadgePlaces badge_places(const std::vector<Badge>& badges, const std::vector<PageBox>& boxes,
                         const std::vector<std::vector<PagePoint>>& others) {
  return Places(badges, boxes, others).found();
}

}  // namespace continua
