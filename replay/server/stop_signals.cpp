#include "continua/replay/server/stop_signals.h"

#include <pthread.h>

#include <utility>

namespace continua {

StopSignals::StopSignals(std::function<void()> stop) {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGHUP);   // the terminal was closed
  sigaddset(&signals_, SIGUSR1);  // from the destructor
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  waiting_ = std::thread([this, stop = std::move(stop)] {
    int signal = 0;
    sigwait(&signals_, &signal);
    if (signal != SIGUSR1) stop();
  });
}

StopSignals::~StopSignals() {
  pthread_kill(waiting_.native_handle(), SIGUSR1);
  waiting_.join();
}

}  // namespace continua
