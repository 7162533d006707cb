#include "continua/simulation/off_screen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <string_view>

namespace continua {
namespace {

const char* const remedy =
    "pictures need OpenGL without a window (EGL), and this machine gives none; Debian's packages libegl-mesa0 and "
    "libgl1-mesa-dri bring one that needs no graphics card";

std::mutex& drawing() {
  static std::mutex one;
  return one;
}

bool has_extension(EGLDisplay display, std::string_view name) {
  const char* const all = eglQueryString(display, EGL_EXTENSIONS);
  return all && std::string_view(all).find(name) != std::string_view::npos;
}

EGLDisplay initialized(EGLDisplay display) {
  return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}

// The first display that works: Mesa's surfaceless platform, a graphics device, the default display.
EGLDisplay open_display() {
  const auto platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (platform_display && has_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    if (auto* display = initialized(platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
      return display;
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (platform_display && query_devices) query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
  for (int i = 0; i < count; ++i)
    if (auto* display = initialized(platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr))) return display;
  return initialized(eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

// Opened once and never closed: closing the display would end every context.
EGLDisplay the_display() {
  static const EGLDisplay display = open_display();
  return display;
}

}  // namespace

struct OffScreen::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface surface = EGL_NO_SURFACE;  // none if a context needs none
  EGLContext context = EGL_NO_CONTEXT;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
  }
};

Result<OffScreen> OffScreen::open() {
  const std::lock_guard lock(drawing());
  auto handles = std::make_unique<Handles>();
  handles->display = the_display();
  if (handles->display == EGL_NO_DISPLAY) return Error{"", remedy};

  constexpr std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                         EGL_NONE};
  EGLConfig config{};
  EGLint count = 0;
  const bool found = eglChooseConfig(handles->display, wanted.data(), &config, 1, &count) && count > 0;
  if (!found || !eglBindAPI(EGL_OPENGL_API)) return Error{"", remedy};
  if (!has_extension(handles->display, "EGL_KHR_surfaceless_context")) {
    constexpr std::array<EGLint, 5> small{EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    handles->surface = eglCreatePbufferSurface(handles->display, config, small.data());
  }
  handles->context = eglCreateContext(handles->display, config, EGL_NO_CONTEXT, nullptr);
  if (handles->context == EGL_NO_CONTEXT) return Error{"", remedy};
  if (!eglMakeCurrent(handles->display, handles->surface, handles->surface, handles->context)) return Error{"", remedy};
  eglMakeCurrent(handles->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  return OffScreen(std::move(handles));
}

OffScreen::OffScreen(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
OffScreen::~OffScreen() = default;
OffScreen::OffScreen(OffScreen&&) noexcept = default;
OffScreen& OffScreen::operator=(OffScreen&&) noexcept = default;

OffScreen::Current::Current(const OffScreen& place) : lock_(drawing()) {
  const auto& to = *place.handles_;
  eglBindAPI(EGL_OPENGL_API);  // is remembered for each thread
  require(eglMakeCurrent(to.display, to.surface, to.surface, to.context), "an OpenGL context that was usable is not");
}

OffScreen::Current::~Current() {
  eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace continua
