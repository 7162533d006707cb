#include "continua/replay/commands/render.h"

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/commands/instant_option.h"
#include "continua/replay/pictures/contact_sheet.h"
#include "continua/replay/pictures/film_clock.h"
#include "continua/replay/pictures/film_writer.h"
#include "continua/replay/pictures/key_moments.h"
#include "continua/replay/pictures/picture_size.h"
#include "continua/replay/pictures/run_pictures.h"
#include "continua/replay/terminal/progress.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>

namespace continua {
namespace fs = std::filesystem;
namespace {

enum class Output { picture, film, folder };

constexpr ImageSize of_film{1280, 720}, of_picture{960, 540}, of_several{400, 300};

Result<Output> output_of(const std::string& path) {
  const auto ending = fs::path(path).extension().string();
  std::error_code ignored;
  if (fs::is_directory(path, ignored) || path.ends_with('/') || ending.empty()) return Output::folder;
  if (ending == ".png") return Output::picture;
  if (ending == ".mp4") return Output::film;
  return Error{path, fmt::format("found the ending {}; expected .png, .mp4 or a folder", in_quotes(ending))};
}

volatile std::sig_atomic_t interrupted = 0;

// While it lives, Ctrl-C lets the film be taken away in good order.
class Interruptible {
 public:
  Interruptible() : was_(std::signal(SIGINT, [](int) { interrupted = 1; })) {}
  ~Interruptible() { std::signal(SIGINT, was_); }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  void (*was_)(int);
};

FilmClock clock_of(const RunPictures& pictures, bool real_time) {
  std::vector<std::pair<SimTime, SimTime>> busy;
  for (const auto t : pictures.motion().moved()) busy.emplace_back(t, t);
  for (const auto& pointing : pictures.story().pointings) busy.emplace_back(pointing.from, pointing.until);
  for (const auto& subtitle : pictures.subtitles()) busy.emplace_back(subtitle.from, subtitle.until);
  return {std::move(busy), pictures.story().end, real_time};
}

Result<std::string> write_film(RunPictures& pictures, const RenderOptions& options, ImageSize size) {
  const auto clock = clock_of(pictures, options.real_time);
  const double rate = options.frames_per_second;
  const auto frames = static_cast<std::size_t>(std::ceil(clock.film_end().seconds() * rate)) + 1;
  const Interruptible while_filming;
  auto film = FilmWriter::open(options.output, size, options.frames_per_second);
  if (!film) return film.error();
  Progress progress(1);
  Outcome problem;
  for (std::size_t i = 0; i < frames && !problem; ++i) {
    const auto film_t = std::min(SimTime::from_seconds(static_cast<double>(i) / rate), clock.film_end());
    const auto [t, jumping] = clock.at(film_t);
    problem = film->add(pictures.at(t, jumping).bgrx());
    progress.show(0, static_cast<double>(i + 1) / static_cast<double>(frames));
    if (interrupted) problem = Error{options.output, "interrupted; no film is left"};
  }
  progress.clear();
  if (!problem) problem = film->finish();
  if (problem) return *problem;
  return fmt::format("{:.1f} s of film, {} frames", static_cast<double>(frames) / rate, frames);
}

Result<std::string> write_moments(RunPictures& pictures, const RenderOptions& options, Output output) {
  if (output == Output::folder) {
    std::error_code problem;
    fs::create_directories(options.output, problem);
    if (problem || !fs::is_directory(options.output))
      return Error{options.output, "is no folder and cannot become one"};
  }
  const auto moments = key_moments(pictures.story());
  std::vector<Image> images;
  Progress progress(1);
  for (const auto& moment : moments) {
    images.push_back(pictures.scene_at(moment.t));
    progress.show(0, static_cast<double>(images.size()) / static_cast<double>(moments.size()));
    if (output != Output::folder) continue;
    const auto name = fmt::format("{:02}_{:.1f}s.png", images.size(), moment.t.seconds());
    if (auto problem = write_file((fs::path(options.output) / name).string(), pictures.at(moment.t).png())) {
      progress.clear();
      return *problem;
    }
  }
  progress.clear();
  const auto sheet = output == Output::folder ? (fs::path(options.output) / "sheet.png").string() : options.output;
  if (auto problem = write_file(sheet, contact_sheet(moments, images).png())) return *problem;
  return counted(moments.size(), "key moment");
}

Result<std::string> write_instant(RunPictures& pictures, const RenderOptions& options) {
  const auto t = SimTime::from_seconds(*options.at_s);
  if (auto problem = write_file(options.output, pictures.at(t).png())) return *problem;
  return "the instant " + clock_text(t);
}

Result<std::string> render(const RenderOptions& options) {
  const auto output = output_of(options.output);
  if (!output) return output.error();
  if (options.at_s && *output != Output::picture)
    return Error{options.output, "--at gives one picture; expected a file that ends in .png"};
  const auto usual = *output == Output::film ? of_film : options.at_s ? of_picture : of_several;
  auto size = options.size.empty() ? Result<ImageSize>(usual) : picture_size(options.size);
  if (!size) return Error{"--size", size.error().sentence};
  if (*output == Output::film && (size->width % 2 != 0 || size->height % 2 != 0))
    return Error{"--size", fmt::format("found {}; a film needs even sides", options.size)};
  if (auto problem = not_an_input({options.output}, {options.run})) return *std::move(problem);
  const auto run = RunIndex::open(options.run);
  if (!run) return run.error();
  const double end_s = run->entry(run->size() - 1).t.seconds();
  if (options.at_s && !(*options.at_s >= 0 && *options.at_s <= end_s))
    return Error{"--at", fmt::format("found {} s; the run goes from 0 to {} s", *options.at_s, end_s)};
  // The pictures of a contact sheet have their text below them.
  const bool text = options.text && *output != Output::picture;
  auto pictures = RunPictures::open(*run, {*size, options.camera, options.text && (text || options.at_s)});
  if (!pictures) return pictures.error();
  if (*output == Output::film) return write_film(*pictures, options, *size);
  return options.at_s ? write_instant(*pictures, options) : write_moments(*pictures, options, *output);
}

}  // namespace

int run_render(const RenderOptions& options) {
  const auto done = render(options);
  if (!done) return report(done.error()), exit_impossible;
  fmt::print("{}: {} -> {}\n", printable_line(fs::path(options.run).filename().string()), *done,
             printable_line(options.output));
  return exit_done;
}

void describe_render(CLI::App& command, RenderOptions& options) {
  command.add_option("RUN", options.run, "a run log (.run.jsonl, .run.jsonl.gz)")->required();
  command
      .add_option(
          "-o,--output", options.output,
          "FILE.mp4: a film with the dialogue as subtitles; FILE.png: the key moments on one sheet, or with --at "
          "one picture; a folder: the key moments as a file each, and the sheet")
      ->required();
  takes_instants(command.add_option("--at", options.at_s, "the instant to draw, from the start"));
  command.add_option(
      "--size", options.size,
      "of a picture in pixels, WxH; otherwise 1280x720 of a film, 960x540 of one picture, 400x300 of each of several");
  command.add_option("--fps", options.frames_per_second, "a film's frames a second")
      ->check(CLI::Range(1, 120))
      ->capture_default_str();
  command.add_option("--camera", options.camera,
                     "front, left, right, back, top, or the name of one of the scene's cameras; otherwise front");
  command.add_flag("!--no-text", options.text, "no subtitles, clock or state in the picture");
  command.add_flag("--real-time", options.real_time, "a film does not shorten waits");
  command.footer(
      "Examples: continua render talk.run.jsonl -o talk.mp4\n"
      "          continua render talk.run.jsonl -o talk.png --at 12.5 --size 1280x720 --camera left");
}

}  // namespace continua
