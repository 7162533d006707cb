#include "continua/simulation/renderer.h"

#include "support/catch.h"

using namespace continua;

namespace {

const std::string two_blocks = R"(<mujoco>
  <visual><headlight ambient="0.6 0.6 0.6" diffuse="0.4 0.4 0.4" specular="0 0 0"/></visual>
  <worldbody>
    <camera name="far" pos="0 0 9" fovy="10"/>
    <body name="table"><geom name="table_top" type="box" size="0.5 0.4 0.01" pos="0 0 -0.01" rgba="1 1 1 1"/></body>
    <body name="red" pos="0.3 0.2 0.05"><freejoint/><geom type="box" size="0.05 0.05 0.05" rgba="1 0 0 1"/></body>
    <body name="green" pos="-0.3 -0.2 0.05"><freejoint/><geom type="box" size="0.05 0.05 0.05" rgba="0 1 0 1"/></body>
  </worldbody></mujoco>)";

constexpr ImageSize size{160, 120};

bool can_render() {
  const auto reason = cannot_render();
  if (reason) WARN("not tested: " << reason->sentence);
  return !reason;
}

Renderer renderer(const RenderView& view = {"top"}, const RenderScene& scene = {two_blocks}) {
  auto opened = Renderer::open(scene, size, view);
  if (!opened) FAIL(opened.error().text());
  return std::move(opened).value();
}

/// The pixels with one channel far above the others: their number and their middle.
struct Spot {
  int pixels = 0;
  double column = 0, row = 0;
  int lowest_row = 0;
};
Spot spot(const Image& image, int channel) {
  Spot found;
  for (int row = 0; row < image.size.height; ++row)
    for (int column = 0; column < image.size.width; ++column) {
      const unsigned char* pixel = &image.rgb[static_cast<std::size_t>(3 * (row * image.size.width + column))];
      if (pixel[channel] < 80 + pixel[(channel + 1) % 3] || pixel[channel] < 80 + pixel[(channel + 2) % 3]) continue;
      ++found.pixels;
      found.column += column;
      found.row += row;
      found.lowest_row = row;
    }
  found.column /= std::max(found.pixels, 1);
  found.row /= std::max(found.pixels, 1);
  return found;
}
enum Channel { red, green, blue };

Pose at(double x, double y, double z) { return {{x, y, z}, Eigen::Quaterniond::Identity()}; }

}  // namespace

TEST_CASE("from above, bodies are where they stand or are put") {
  if (!can_render()) return;
  auto above = renderer();
  struct Row {
    std::map<std::string, Pose> poses;
    bool right, far;
  };
  const std::vector<Row> rows = {{{}, true, true},
                                 {{{"red", at(-0.3, 0.2, 0.05)}}, false, true},
                                 {{{"red", at(-0.3, -0.1, 0.05)}}, false, false},
                                 {{{"red", at(0.3, -0.1, 0.05)}, {"none", at(0, 0, 0)}}, true, false}};
  for (const auto& row : rows) {
    const auto found = spot(above.draw(row.poses), red);
    CHECK(found.pixels > 100);
    CHECK((found.column > size.width / 2) == row.right);
    CHECK((found.row < size.height / 2) == row.far);
  }
}

TEST_CASE("bodies begin where the scene is said to begin") {
  if (!can_render()) return;
  auto above = renderer({"top"}, {two_blocks, ".", {{"red", at(-0.3, 0.2, 0.05)}}});
  CHECK(spot(above.draw({}), red).column < size.width / 2);
  CHECK(spot(above.draw({{"red", at(0.3, 0.2, 0.05)}}), red).column > size.width / 2);
  CHECK(spot(above.draw({}), red).column < size.width / 2);
}

TEST_CASE("a picture has its size, and the same is drawn in the same way") {
  if (!can_render()) return;
  auto one = renderer();
  const auto first = one.draw({});
  CHECK(first.size == size);
  CHECK(first.rgb.size() == static_cast<std::size_t>(3 * size.width * size.height));
  auto other = renderer();
  one.draw({{"red", at(0, 0, 0.3)}});
  CHECK(one.draw({}).rgb == first.rgb);
  CHECK(other.draw({}).rgb == first.rgb);
}

TEST_CASE("marks are drawn where they point, with a ray where it begins somewhere") {
  if (!can_render()) return;
  auto above = renderer();
  const std::array<float, 3> colour{0, 0, 1};
  const auto pixels = [&](const RenderMark& mark) { return spot(above.draw({}, {mark}), blue); };
  CHECK(spot(above.draw({}), blue).pixels == 0);
  const auto disc = pixels({{0.3, -0.2, 0}, "", std::nullopt, false, colour});
  CHECK(disc.pixels > 5);
  CHECK(disc.column > size.width / 2);
  CHECK(disc.row > size.height / 2);
  CHECK(pixels({{0.3, -0.2, 0}, "", Vec3(0, -0.4, 0.3), false, colour}).pixels > disc.pixels + 20);
  const auto on_red = pixels({{0.3, -0.2, 0}, "red", std::nullopt, false, colour});
  CHECK(on_red.pixels > 5);
  CHECK(on_red.row < size.height / 2);
  // This scene has no hand that a ray could begin at.
  CHECK(pixels({{0.3, -0.2, 0}, "", std::nullopt, true, colour}).pixels == disc.pixels);
}

TEST_CASE("from every side all is in the picture, and below it room is left") {
  if (!can_render()) return;
  for (const std::string camera : {"", "front", "left", "right", "back", "top"}) {
    INFO(camera);
    auto side = renderer({camera, 0.3});
    const auto image = side.draw({});
    CHECK(spot(image, red).pixels > 40);
    CHECK(spot(image, green).pixels > 40);
    CHECK(std::max(spot(image, red).lowest_row, spot(image, green).lowest_row) < 0.72 * size.height);
  }
  CHECK(spot(renderer({"front"}).draw({}), red).column > size.width / 2);
  CHECK(spot(renderer({"back"}).draw({}), red).column < size.width / 2);
  CHECK(spot(renderer({"far"}).draw({}), red).pixels > 20);
}

TEST_CASE("a scene that cannot be drawn, and a camera that is none, are told") {
  if (!can_render()) return;
  const auto error = [](const RenderScene& scene, const std::string& camera) {
    const auto opened = Renderer::open(scene, size, {camera});
    REQUIRE_FALSE(opened.ok());
    return opened.error().text();
  };
  CHECK(error({two_blocks, ".", {}, "a.run.jsonl:1"}, "fron") ==
        "a.run.jsonl:1: the scene has no camera 'fron' (did you mean 'front'?); expected one of front, left, right, "
        "back, "
        "top, far");
  CHECK(error({"<mujoco", ".", {}, "here"}, "").find("here: MuJoCo does not take this scene") == 0);
  const std::string with_mesh =
      "<mujoco><asset><mesh name='m' file='m.stl'/></asset><worldbody><geom type='mesh' "
      "mesh='m'/></worldbody></mujoco>";
  CHECK(error({with_mesh, ".", {}, "here"}, "").find("m.stl") != std::string::npos);
}
