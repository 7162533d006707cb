// A place to draw with OpenGL where there is no display: an EGL context of its own, without a window. Mesa's software
// driver needs no graphics card.
#pragma once

#include <memory>
#include <mutex>

#include "continua/core/result.h"

namespace continua {

class OffScreen {
 public:
  /// An error says what is missing and which package would help.
  static Result<OffScreen> open();
  ~OffScreen();
  OffScreen(OffScreen&&) noexcept;
  OffScreen& operator=(OffScreen&&) noexcept;

  /// While it lives, what the calling thread does in OpenGL goes to this context. One at a time in the program: others
  /// wait.
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
