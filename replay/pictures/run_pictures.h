// Pictures of a run from its log: the scene at an instant, with the pointing, the words and the time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/replay/log/run_index.h"
#include "continua/replay/pictures/canvas.h"
#include "continua/replay/pictures/run_motion.h"
#include "continua/replay/pictures/run_story.h"
#include "continua/replay/pictures/subtitles.h"
#include "continua/simulation/renderer.h"

namespace continua {

struct PictureOptions {
  ImageSize size{960, 540};
  std::string camera = {};  ///< RenderView::camera
  bool text = true;         ///< whether subtitles, clock and state are written into the picture
};

class RunPictures {
 public:
  /// Errors: the log has no scene or one that cannot be drawn without its files, there is no such camera (all with a
  /// place); pictures cannot be drawn on this machine (without a place).
  static Result<RunPictures> open(const RunIndex& run, const PictureOptions& options);

  const RunStory& story() const { return story_; }
  const RunMotion& motion() const { return motion_; }
  const std::vector<Subtitle>& subtitles() const { return subtitles_; }

  /// The run at `t`; `jumping` says in the picture that a film passes over time here.
  Canvas at(SimTime t, bool jumping = false);
  /// The scene alone, with where people point.
  const Image& scene_at(SimTime t);

 private:
  RunPictures(Renderer renderer, const PictureOptions& options) : renderer_(std::move(renderer)), options_(options) {}
  std::vector<RenderMark> marks_at(SimTime t) const;
  void write_subtitles(Canvas& canvas, SimTime t) const;
  void write_clock(Canvas& canvas, SimTime t, bool jumping) const;

  Renderer renderer_;
  PictureOptions options_;
  RunMotion motion_;
  RunStory story_;
  std::vector<Subtitle> subtitles_;
  // The last picture, for as long as nothing moves.
  std::map<std::string, Pose> drawn_poses_;
  std::vector<RenderMark> drawn_marks_;
  Image drawn_;
};

/// "1:02.5"
std::string clock_text(SimTime t);

/// The colour of a speaker's name and of where he points.
Colour colour_of(Speaker speaker);

}  // namespace continua
