#include "continua/replay/commands/render.h"

#include <cmath>
#include <filesystem>

#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/pictures/contact_sheet.h"
#include "continua/replay/pictures/frame_cache.h"
#include "continua/replay/pictures/picture_size.h"
#include "replay/export/drawable_log.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

bool can_render() {
  const auto reason = cannot_render();
  if (reason) WARN("not tested: " << reason->sentence);
  return !reason;
}

RenderOptions options(const std::string& run, const std::string& output) {
  RenderOptions options;
  options.run = run;
  options.output = output;
  return options;
}

/// Width and height as the header of a PNG has them.
ImageSize png_size(const std::string& png) {
  if (png.size() < 24 || png.substr(1, 3) != "PNG") return {};
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(png[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

// Frames that show which instant and camera were asked for.
struct ToldFrames : RunFrames {
  Outcome unavailable() override { return missing ? Outcome(Error{"", "no EGL"}) : std::nullopt; }
  Outcome wrong_size(const std::string& size) override {
    return size == "big" ? Outcome(Error{"", "too big"}) : std::nullopt;
  }
  Result<std::string> png(const std::shared_ptr<const RunIndex>&, SimTime t, const std::string& size) override {
    if (t.seconds() > 5) return Error{"a:1", "no scene"};
    return std::to_string(t.us) + size;
  }
  bool missing = false;
};

}  // namespace

TEST_CASE("sizes of pictures are read") {
  CHECK(picture_size("640x360").value() == ImageSize{640, 360});
  CHECK(picture_size("16x4096").value() == ImageSize{16, 4096});
  for (const std::string wrong :
       {"", "640", "640x", "x360", "640x360x2", "15x360", "640x4097", "-640x360", "640 x 360"})
    CHECK(picture_size(wrong).error().sentence.find("; expected WIDTHxHEIGHT in pixels, each from 16 to 4096") > 0);
}

TEST_CASE("render says what it cannot do") {
  const TemporaryFolder folder;
  const auto log = folder.file("a.run.jsonl", drawable_log().text());
  auto no_scene = LogBuilder();
  no_scene.add("run", 0, {{"version", 1}});
  const auto bare = folder.file("bare.run.jsonl", no_scene.text());
  const auto fails = [](const RenderOptions& wanted) { return run_render(wanted) == exit_impossible; };
  CHECK(fails(options(log, folder.at("a.gif"))));
  CHECK(fails(options(folder.at("none.run.jsonl"), folder.at("a.png"))));
  CHECK(fails(options(bare, folder.at("a.png"))));
  for (const double at : {-0.1, 20.1, std::nan("")}) {
    auto wanted = options(log, folder.at("a.png"));
    wanted.at_s = at;
    CHECK(fails(wanted));
  }
  auto film_at = options(log, folder.at("a.mp4"));
  film_at.at_s = 1;
  CHECK(fails(film_at));
  auto odd = options(log, folder.at("a.mp4"));
  odd.size = "641x360";
  CHECK(fails(odd));
  auto small = options(log, folder.at("a.png"));
  small.size = "4x4";
  CHECK(fails(small));
  CHECK_FALSE(fs::exists(folder.at("a.png")));
  CHECK_FALSE(fs::exists(folder.at("a.mp4")));
  if (!can_render()) return;
  CHECK(fails(options(log, folder.at("no/such/a.png"))));
  CHECK(fails(options(log, folder.at("no/such/a.mp4"))));
  auto camera = options(log, folder.at("a.png"));
  camera.camera = "none";
  CHECK(fails(camera));
}

TEST_CASE("render draws an instant, a sheet and a folder") {
  if (!can_render()) return;
  const TemporaryFolder folder;
  const auto log = folder.file("a.run.jsonl", drawable_log().text());
  auto instant = options(log, folder.at("at.png"));
  instant.at_s = 2;
  instant.size = "320x180";
  CHECK(run_render(instant) == exit_done);
  CHECK(png_size(read_file(folder.at("at.png")).value()) == ImageSize{320, 180});
  instant.output = folder.at("plain.png");
  instant.text = false;
  CHECK(run_render(instant) == exit_done);
  CHECK(read_file(folder.at("plain.png")).value() != read_file(folder.at("at.png")).value());

  auto sheet = options(log, folder.at("sheet.png"));
  sheet.size = "160x90";
  CHECK(run_render(sheet) == exit_done);
  // Two moments side by side, with their captions.
  const auto size = png_size(read_file(folder.at("sheet.png")).value());
  CHECK(size.width > 320);
  CHECK(size.width < 360);
  CHECK(size.height > 90);
  CHECK(run_render(options(log, folder.at("deep/moments"))) == exit_done);
  CHECK(fs::exists(folder.at("deep/moments/01_2.0s.png")));
  CHECK(fs::exists(folder.at("deep/moments/02_3.5s.png")));
  CHECK(fs::exists(folder.at("deep/moments/sheet.png")));
}

TEST_CASE("render writes a film") {
  if (!can_render()) return;
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) {
    WARN("not tested: ffmpeg is not installed");
    return;
  }
  const TemporaryFolder folder;
  auto film = options(folder.file("a.run.jsonl", drawable_log().text()), folder.at("a.mp4"));
  film.size = "160x90";
  film.frames_per_second = 5;
  CHECK(run_render(film) == exit_done);
  CHECK(read_file(folder.at("a.mp4")).value().substr(4, 4) == "ftyp");
  CHECK_FALSE(fs::exists(folder.at("a.mp4.part")));
}

TEST_CASE("text is broken into lines that fit, long words too") {
  const Canvas canvas({10, 10}, {});
  const auto lines = canvas.wrapped(12, {{"Human: ", {}, true}, {"put the cup on the plate", {}, false}}, 120, 9);
  CHECK(lines.size() > 1);
  std::string all;
  for (const auto& line : lines) {
    CHECK(canvas.width_of(12, line) <= 120);
    for (const auto& run : line) all += run.text;
  }
  CHECK(all == "Human: put the cup on the plate");
  const auto word = canvas.wrapped(12, {{std::string(100, 'm'), {}, false}}, 120, 3);
  REQUIRE(word.size() == 3);
  CHECK(word.back().back().text == "…");
  CHECK(canvas.wrapped(12, {{"caf\xC3 \x01", {}, false}}, 1, 50).size() >= 4);
}

TEST_CASE("a frame is asked for by time and size") {
  const ScratchFolder folder;
  folder.write("a.run.jsonl", drawable_log().text());
  const auto frames = std::make_shared<ToldFrames>();
  InspectorApi api({folder.path()}, frames);
  struct Row {
    const char* target;
    int status;
    const char* part;
  };
  const std::vector<Row> rows = {
      {"/api/runs/a/frame?t=1.5", 200, "1500000"},       {"/api/runs/a/frame?t=0&size=64x64", 200, "064x64"},
      {"/api/runs/a/frame", 400, "t is missing"},        {"/api/runs/a/frame?t=x", 400, "is not a number"},
      {"/api/runs/a/frame?t=20.5", 400, "from 0 to 20"}, {"/api/runs/a/frame?t=nan", 400, ""},
      {"/api/runs/a/frame?t=-1", 400, "from 0 to 20"},   {"/api/runs/a/frame?t=1&size=big", 400, "size: too big"},
      {"/api/runs/a/frame?t=6", 422, "a:1: no scene"},   {"/api/runs/b/frame?t=1", 404, "no run"},
  };
  for (const auto& row : rows) {
    INFO(row.target);
    const auto answer = api.get(row.target);
    CHECK(answer.status == row.status);
    CHECK(answer.content_type == (row.status == 200 ? "image/png" : "application/json"));
    CHECK_THAT(answer.body, Contains(row.part));
  }
  frames->missing = true;
  CHECK(api.get("/api/runs/a/frame?t=1").status == 501);
  CHECK_THAT(api.get("/api/runs/a/frame?t=1").body, Contains("no EGL"));
  CHECK(InspectorApi({folder.path()}).get("/api/runs/a/frame?t=1").status == 501);
}

TEST_CASE("frames are drawn, and drawn anew when the run has changed") {
  if (!can_render()) return;
  const ScratchFolder folder;
  folder.write("a.run.jsonl", drawable_log().text());
  InspectorApi api({folder.path()}, drawn_frames());
  const auto target = "/api/runs/a/frame?t=3&size=64x48";
  const auto first = api.get(target);
  CHECK(first.status == 200);
  CHECK(png_size(first.body) == ImageSize{64, 48});
  CHECK(api.get(target).body == first.body);
  CHECK(api.get("/api/runs/a/frame?t=1&size=64x48").body != first.body);
  CHECK(png_size(api.get("/api/runs/a/frame?t=1").body) == ImageSize{640, 360});
  auto moved = drawable_log();
  moved.add("pose", 21, {{"bodies", {{"block1", {0.3, 0.2, 0.05, 1, 0, 0, 0}}}}});
  folder.write("a.run.jsonl", moved.text());
  CHECK(api.get("/api/runs/a/frame?t=21&size=64x48").body != first.body);
  CHECK(api.get(target).body == first.body);
}
