#include "continua/replay/server/waiting_answers.h"

#include <sys/socket.h>

namespace continua {

WaitingAnswers::Place::Place(WaitingAnswers& all, int socket) : all_(all), socket_(socket) {
  const std::lock_guard lock(all_.mutex_);
  all_.waiting_.push_back(socket);
  if (all_.waiting_.size() <= most) return;
  ::shutdown(all_.waiting_.front(), SHUT_RDWR);
  all_.waiting_.pop_front();
}

WaitingAnswers::Place::~Place() {
  const std::lock_guard lock(all_.mutex_);
  all_.waiting_.remove(socket_);
}

}  // namespace continua
