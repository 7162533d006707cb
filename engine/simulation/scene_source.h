// A scene's MJCF as one text with inclusions in their place, for run logs. Each line remembers its file, so that errors
// name the file and not the expansion.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

class SceneSource {
 public:
  /// Reads `path` and all inclusions; the file of `<include file="…"/>` is sought in the folder of the including file.
  /// Errors: a file is missing, empty, not MJCF, or includes itself; there are more inclusions in all than
  /// most_inclusions, or more text than most_bytes; a size that MuJoCo is to allocate is beyond all use.
  static constexpr int most_inclusions = 1000;
  static constexpr std::size_t most_bytes = std::size_t{16} << 20;
  static Result<SceneSource> read(const std::string& path);

  const std::string& path() const { return path_; }
  /// One complete MJCF document.
  const std::string& text() const { return text_; }

  /// "file:line" of a line of text(), counted from 1; the scene's own path if there is no such line.
  std::string where(int line) const;

  /// "file:line" of the last tag of that name with the attribute; the scene's own path if there is none.
  std::string where(std::string_view tag, std::string_view attribute) const;

  /// The same scene with more elements at its end. Lines keep their numbers.
  SceneSource with(std::string_view elements) const;

  /// text()[begin, end) becomes `text`, with as many line ends.
  struct Change {
    std::size_t begin = 0, end = 0;
    std::string text;
  };
  /// The same scene with changes, which do not overlap. Lines keep their numbers.
  SceneSource with_changes(std::vector<Change> changes) const;

  /// The keyframes that were left out: the numbers of `qpos` as written.
  struct Keyframe {
    std::string where, name, qpos;
  };
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }

  /// The same scene without the body of that name and its children. Lines keep their numbers.
  SceneSource without_body(std::string_view name) const;

 private:
  struct Line {
    std::string file;
    int number = 0;
  };

  Outcome expand(const std::string& file, std::vector<std::string>& open_files);
  Outcome check_sizes() const;
  /// Keyframes of an arm that others wrote are as long as that arm, which MuJoCo refuses in a scene with objects. The
  /// arm begins at `arm_home`, or as one of them if the scene tells so (told_avatar.h).
  void drop_keyframes();

  std::string path_, text_;
  int inclusions_ = 0;
  std::vector<Line> lines_;  // of text_
  std::vector<Keyframe> keyframes_;
};

}  // namespace continua
