// OpenGL without a display: an EGL context without a window. Mesa's software driver needs no graphics card.
#pragma once

#include <memory>
#include <mutex>

#include "continua/core/result.h"

namespace continua {

class OffScreen {
 public:
  /// The error names the missing part and a package that would help.
  static Result<OffScreen> open();
  ~OffScreen();
  OffScreen(OffScreen&&) noexcept;
  OffScreen& operator=(OffScreen&&) noexcept;

  /// Directs the calling thread's OpenGL to this context for the object's lifetime. Only one object exists at a time in
  /// the program; other threads wait.
  class Current {
   public:
    explicit Current(const OffScreen& place);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    std::lock_guard<std::mutex> lock_;
  };

 private:
  struct Handles;
  explicit OffScreen(std::unique_ptr<Handles> handles);
  std::unique_ptr<Handles> handles_;
};

}  // namespace continua
