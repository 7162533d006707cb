#include "continua/replay/pictures/run_pictures.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr SimTime linger{500'000};      // that a mark stays after the pointing
constexpr double subtitle_part = 0.13;  // of a picture's height
// Where the human's hand is when the log does not say: before the table, lifted, on its own side.
Vec3 human_hand_W(const std::string& hand) { return {hand == "left" ? -0.24 : 0.24, -0.6, 0.3}; }

constexpr Colour white{1, 1, 1}, behind_text{0.08, 0.09, 0.11, 0.72}, pale{0.78, 0.81, 0.85};

bool same(const Pose& a, const Pose& b) { return a.p_WB == b.p_WB && a.R_WB.coeffs() == b.R_WB.coeffs(); }

bool same(const std::map<std::string, Pose>& a, const std::map<std::string, Pose>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& one, const auto& other) {
           return one.first == other.first && same(one.second, other.second);
         });
}

bool same(const std::vector<RenderMark>& a, const std::vector<RenderMark>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RenderMark& one, const RenderMark& other) {
    return one.to_W == other.to_W && one.on_body == other.on_body && one.from_W == other.from_W &&
           one.from_hand == other.from_hand && one.rgb == other.rgb;
  });
}

// The page's --human and --avatar, on the light scene rather than on the dark ground of text.
std::array<float, 3> mark_colour(Speaker speaker) {
  return speaker == Speaker::human ? std::array{0.04F, 0.39F, 0.66F} : std::array{0.80F, 0.50F, 0.02F};
}

}  // namespace

std::string clock_text(SimTime t) {
  const auto tenths = (t.us + 50'000) / 100'000;
  return fmt::format("{}:{:02}.{}", tenths / 600, tenths / 10 % 60, tenths % 10);
}

Colour colour_of(Speaker speaker) {
  return speaker == Speaker::human ? Colour{0.42, 0.71, 0.94} : Colour{0.90, 0.70, 0.29};
}

Result<RunPictures> RunPictures::open(const RunIndex& run, const PictureOptions& options) {
  auto motion = RunMotion::read(run);
  if (!motion) return motion.error();
  auto story = read_story(run);
  if (!story) return story.error();
  // A log carries its scene's text but not the files that it may name, such as meshes; those are sought in the log's
  // folder.
  const auto folder = std::filesystem::absolute(run.path()).parent_path().string();
  auto renderer = Renderer::open({motion->mjcf(), folder, motion->at_start(), run.where(0)}, options.size,
                                 {options.camera, options.text ? subtitle_part : 0});
  if (!renderer) return renderer.error();
  RunPictures pictures(std::move(renderer).value(), options);
  pictures.motion_ = std::move(motion).value();
  pictures.story_ = std::move(story).value();
  pictures.subtitles_ = subtitles_of(pictures.story_);
  return pictures;
}

std::vector<RenderMark> RunPictures::marks_at(SimTime t) const {
  std::vector<RenderMark> marks;
  for (const auto& pointing : story_.pointings) {
    if (t < pointing.from || t > pointing.until + linger) continue;
    const bool followed = std::any_of(story_.pointings.begin(), story_.pointings.end(), [&](const auto& other) {
      return other.speaker == pointing.speaker && other.hand == pointing.hand && other.from > pointing.from &&
             other.from <= t;
    });
    if (followed) continue;
    const auto later = std::upper_bound(pointing.samples.begin(), pointing.samples.end(), t,
                                        [](SimTime time, const auto& sample) { return time < sample.t; });
    const auto& sample = later == pointing.samples.begin() ? *later : *std::prev(later);
    const bool human = pointing.speaker == Speaker::human;
    RenderMark mark{sample.target_W, pointing.on_body, sample.from_W, !human, mark_colour(pointing.speaker)};
    if (human && !mark.from_W) mark.from_W = human_hand_W(pointing.hand);
    marks.push_back(mark);
  }
  return marks;
}

const Image& RunPictures::scene_at(SimTime t) {
  auto poses = motion_.at(t);
  auto marks = marks_at(t);
  if (drawn_.rgb.empty() || !same(poses, drawn_poses_) || !same(marks, drawn_marks_)) {
    drawn_ = renderer_.draw(poses, marks);
    drawn_poses_ = std::move(poses);
    drawn_marks_ = std::move(marks);
  }
  return drawn_;
}

Canvas RunPictures::at(SimTime t, bool jumping) {
  Canvas canvas(scene_at(t));
  if (!options_.text) return canvas;
  write_subtitles(canvas, t);
  write_clock(canvas, t, jumping);
  return canvas;
}

void RunPictures::write_subtitles(Canvas& canvas, SimTime t) const {
  const double height = canvas.size().height, width = canvas.size().width;
  const double letters = std::max(height / 27, 9.0), line_height = 1.45 * letters;
  std::vector<std::vector<TextRun>> lines;
  for (const auto& subtitle : shown_at(subtitles_, t)) {
    const char* who = subtitle.speaker == Speaker::human ? "Human: " : "Avatar: ";
    for (auto& line :
         canvas.wrapped(letters, {{who, colour_of(subtitle.speaker), true}, {subtitle.text, white}}, 0.9 * width, 2))
      lines.push_back(std::move(line));
  }
  double y = height - 0.5 * letters - (static_cast<double>(lines.size()) - 0.5) * line_height;
  for (const auto& line : lines) {
    const double length = canvas.width_of(letters, line);
    const double x = (width - length) / 2, padding = 0.5 * letters;
    canvas.box(x - padding, y - line_height / 2, length + 2 * padding, line_height, 0.3 * letters, behind_text);
    canvas.text(x, y, letters, line);
    y += line_height;
  }
}

void RunPictures::write_clock(Canvas& canvas, SimTime t, bool jumping) const {
  const double letters = std::max(canvas.size().height / 36.0, 8.0), line_height = 1.5 * letters;
  std::vector<std::vector<TextRun>> lines;
  lines.push_back({{clock_text(t) + (jumping ? " »" : ""), white, true}});
  if (const auto state = state_at(story_.states, t); !state.empty()) lines.back().push_back({"  " + state, pale});
  if (const auto act = state_at(story_.doing, t); !act.empty()) {
    for (auto& line : canvas.wrapped(letters, {{act, white}}, 0.6 * canvas.size().width, 1))
      lines.push_back(std::move(line));
  }
  double width = 0;
  for (const auto& line : lines) width = std::max(width, canvas.width_of(letters, line));
  const double margin = 0.6 * letters;
  canvas.box(margin, margin, width + 1.2 * letters, line_height * static_cast<double>(lines.size()) + 0.4 * letters,
             0.3 * letters, behind_text);
  double y = margin + 0.2 * letters + line_height / 2;
  for (const auto& line : lines) {
    canvas.text(margin + 0.6 * letters, y, letters, line);
    y += line_height;
  }
}

}  // namespace continua
