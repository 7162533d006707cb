#include "continua/replay/commands/doctor.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/named_machine.h"
#include "continua/replay/live/hand_model.h"
#include "continua/replay/pictures/film_writer.h"
#include "continua/replay/server/inspector_server.h"
#include "continua/replay/session/version.h"
#include "continua/simulation/mujoco_version.h"
#include "continua/simulation/physics_body.h"
#include "continua/simulation/renderer.h"
#include "continua/simulation/scene.h"
#include "continua/web/assets.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

struct Finding {
  std::string part;
  Result<std::string> state;  ///< a sentence; the error: why it does not work
  bool needed = true;         ///< without it there is no replay or no page
};

Result<std::string> machines_in(const DataPaths& data) {
  const auto names = names_in(data.knowledge / "machines", ".json");
  if (names.empty()) return Error{(data.knowledge / "machines").string(), "has no machine"};
  for (const auto& name : names)
    if (const auto machine = load_named_machine(name, data.knowledge.string()); !machine) return machine.error();
  return fmt::format("{}: {}, all can be read", data.knowledge.lexically_normal().string(),
                     counted(names.size(), "machine"));
}

// A second of each scene, with its arm.
Result<std::string> physics_of(const DataPaths& data) {
  const auto names = names_in(data.mjcf / "scenes", ".xml");
  if (names.empty()) return Error{(data.mjcf / "scenes").string(), "has no scene"};
  for (const auto& name : names) {
    const auto scene = load_scene((data.mjcf / "scenes" / (name + ".xml")).string());
    if (!scene) return scene.error();
    auto body = PhysicsBody::create(*scene);
    if (!body) return body.error();
    static_cast<void>((*body)->advance(SimTime::from_seconds(1)));
  }
  return fmt::format("MuJoCo {}: {}, a second of each", mujoco_version(), counted(names.size(), "scene"));
}

// A film of one picture.
Result<std::string> films() {
  const auto path = (fs::temp_directory_path() / fmt::format("continua.{}.mp4", ::getpid())).string();
  constexpr ImageSize size{16, 16};
  auto film = FilmWriter::open(path, size, 1);
  auto problem = film ? film->add(std::string(4UL * size.width * size.height, '\0')) : Outcome(film.error());
  if (!problem) problem = film->finish();
  std::error_code none;
  fs::remove(path, none);
  if (problem) return Error{"", problem->sentence};
  return std::string("ffmpeg makes mp4");
}

Result<std::string> page() {
  const auto has = [](std::string_view path) {
    const auto assets = web_assets();
    return std::any_of(assets.begin(), assets.end(), [&](const WebAsset& one) { return one.path == path; });
  };
  return fmt::format("{} files; {}, {}, {}", web_assets().size(),
                     has("/vendor/three.module.js") ? "the scene in 3D" : "the scene as pictures, for want of three",
                     has("/vendor/dagre.esm.js") ? "graphs by dagre" : "graphs by its own layout, for want of dagre",
                     hand_model_folder() ? "hands by camera" : "no hands by camera, for want of @mediapipe/hands");
}

Result<std::string> port_for_page(int wanted) {
  InspectorServer server({});
  const auto port = server.listen("127.0.0.1", wanted);
  if (!port) return Error{"", port.error().sentence};
  return fmt::format("{} is free", *port);
}

Result<std::string> pictures() {
  if (const auto problem = cannot_render()) return Error{"", problem->sentence};
  return std::string("EGL draws without a display");
}

std::vector<Finding> examine(const DoctorOptions& options) {
  std::vector<Finding> findings;
  const auto data = find_data_paths(options.knowledge);
  if (data) {
    findings.push_back({"knowledge", machines_in(*data)});
    findings.push_back({"physics", physics_of(*data)});
  } else {
    findings.push_back({"knowledge", data.error()});
  }
  findings.push_back({"page", page()});
  findings.push_back({"port", port_for_page(options.port), false});
  findings.push_back({"pictures", pictures(), false});
  findings.push_back({"films", films(), false});
  return findings;
}

}  // namespace

int run_doctor(const DoctorOptions& options) {
  for (const char c : version_text()) fmt::print("{}", c == '\n' ? std::string(", ") : std::string(1, c));
  fmt::print("\n");
  int status = exit_done;
  for (const auto& [part, state, needed] : examine(options)) {
    const auto told = state ? *state : state.error().text();
    fmt::print("{:<5}{:<10} {}\n", state ? "ok" : needed ? "FAIL" : "no", part, printable_line(told));
    if (!state && needed) status = exit_no;
  }
  return status;
}

void describe_doctor(CLI::App& command, DoctorOptions& options) {
  command.add_option("--knowledge", options.knowledge, "folder of machines, lexicon, voxemes; otherwise the program's");
  command.add_option("--port", options.port, "the port that the page would have")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command.footer(
      "A line for each part: ok, no (the rest works without it), FAIL (there is no replay, or no page).\n"
      "Exit status: 0 no FAIL, 1 a FAIL.\n"
      "Example: continua doctor");
}

}  // namespace continua
