#include "continua/replay/terminal/standard_input.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string_view>
#include <utility>

#include "continua/core/located_json.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t piece = 65536;
constexpr std::pair<std::string_view, std::string_view> endings[] = {{"trace", ".trace.jsonl"}, {"run", ".run.jsonl"}};

// By the `kind` of the first line; other files have none.
std::string_view ending_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::getline(file, line);
  const auto header = Json::parse(line, nullptr, false);
  if (!header.is_object() || !header.contains("kind")) return "";
  for (const auto& [kind, ending] : endings)
    if (header["kind"] == kind) return ending;
  return "";
}

}  // namespace

Result<std::string> StandardInput::file() {
  if (folder_) return Error{"-", "stands for standard input, which can be read once; expected other files by name"};
  auto folder = ScratchSpace::make();
  if (!folder) return folder.error();
  folder_ = std::move(*folder);
  const auto path = (folder_->path() / "stdin").string();
  std::ofstream file(path, std::ios::binary);
  for (std::string bytes(piece, '\0'); std::cin.good();) {
    std::cin.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.write(bytes.data(), std::cin.gcount());
  }
  if (std::cin.bad()) return Error{"standard input", "cannot be read to its end"};
  file.close();
  if (!file) return Error{path, "cannot be written; standard input is kept there while it is read"};
  const auto named = path + std::string(ending_of(path));
  std::error_code problem;
  fs::rename(path, named, problem);
  if (problem) return Error{named, "cannot be written: " + problem.message()};
  return named;
}

}  // namespace continua
