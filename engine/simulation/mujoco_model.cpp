#include "continua/simulation/mujoco_model.h"

#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <optional>
#include <regex>

#include <fmt/format.h>

#include "continua/core/result.h"
#include "continua/simulation/box_contacts.h"

namespace continua {

namespace {

// While this is set, MuJoCo's fatal errors jump back here instead of ending the program.
thread_local std::jmp_buf* way_back = nullptr;
thread_local std::array<char, 500> fatal_error{};

void on_error(const char* message) {
  if (!way_back) require(false, message);
  fmt::format_to_n(fatal_error.data(), fatal_error.size() - 1, "{}", message);
  std::longjmp(*way_back, 1);
}

// Warnings of the compiler are of no consequence for a scene that compiles; those of a step are counted in mjData.
void on_warning(const char*) {}

// MuJoCo's settings of the whole process are made once, before its first work: other threads read them at any time.
void set_up_once() {
  static const bool done = [] {
    mju_user_error = on_error;
    mju_user_warning = on_warning;
    guard_box_contacts();
    return true;
  }();
  static_cast<void>(done);
}

void put_file(mjVFS& files, const char* name, const std::string& content) {
#if mjVERSION_HEADER >= 320
  mj_addBufferVFS(&files, name, content.data(), static_cast<int>(content.size()));
#else
  mj_makeEmptyFileVFS(&files, name, static_cast<int>(content.size()));
  std::memcpy(files.filedata[mj_findFileVFS(&files, name)], content.data(), content.size());
#endif
}

/// `text` whose first element after the root says where assets are; on the root's line, so that no line number changes.
std::string with_asset_directory(const std::string& text, const std::string& directory) {
  const std::size_t root = text.find("<mujoco");
  const std::size_t end = root == std::string::npos ? root : text.find('>', root);
  if (end == std::string::npos || text[end - 1] == '/') return text;
  const auto setting = fmt::format("<compiler meshdir=\"{0}\" texturedir=\"{0}\"/>", directory);
  return text.substr(0, end + 1) + setting + text.substr(end + 1);
}

/// MuJoCo writes places as ", line 12", ", line = 12, column = -1" or " Line number=12"; its sentence may take several
/// lines. The places are taken out: they are of the text with all inclusions, which nobody has before them.
CompileError read_message(std::string message) {
  static const std::regex place(R"(,? *[Ll]ine *(number)? *=? *([0-9]+)(, *column *= *-?[0-9]+)?)");
  CompileError error;
  for (std::smatch found; std::regex_search(message, found, place);
       message = found.prefix().str() + found.suffix().str())
    error.line = std::atoi(found[2].str().c_str());
  for (char& letter : message) letter = letter == '\n' || letter == '\r' ? ' ' : letter;
  while (!message.empty() && message.back() == ' ') message.pop_back();
  error.sentence = "MuJoCo does not take this scene: " + message;
  return error;
}

}  // namespace

std::variant<ModelOwner, CompileError> compile_mjcf(const std::string& text, const std::string& asset_directory) {
  constexpr const char* name = "scene.xml";
  const auto files = std::make_unique<mjVFS>();  // megabytes in early releases: not for the stack
  mj_defaultVFS(files.get());
  put_file(*files, name, with_asset_directory(text, asset_directory));

  std::array<char, 1000> message{};
  mjModel* model = nullptr;
  std::string fatal;
  try {
    fatal = fatal_error_of(
        [&] { model = mj_loadXML(name, files.get(), message.data(), static_cast<int>(message.size())); });
  } catch (const std::bad_alloc&) {
    fatal = "it takes more memory than there is";
  }
  way_back = nullptr;
  mj_deleteVFS(files.get());

  if (!fatal.empty()) return read_message(fatal);
  if (!model) return read_message(message.data());
  return ModelOwner(model);
}

std::string fatal_error_of(const std::function<void()>& work) {
  set_up_once();
  fatal_error.fill(0);
  std::jmp_buf here;
  way_back = &here;
  if (setjmp(here) == 0) work();
  way_back = nullptr;
  return fatal_error.data();
}

std::string name_of(const mjModel& model, mjtObj type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name ? name : fmt::format("#{}", id);
}

}  // namespace continua
