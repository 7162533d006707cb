#include "continua/replay/server/waiting_answers.h"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <list>
#include <vector>

#include "support/catch.h"

using namespace continua;

namespace {

class Connection {
 public:
  Connection() { REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()) == 0); }
  ~Connection() {
    for (const int end : ends_) ::close(end);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int server() const { return ends_[0]; }
  bool is_open() const {
    char byte;
    return ::recv(ends_[1], &byte, 1, MSG_DONTWAIT) != 0;
  }

 private:
  std::array<int, 2> ends_{};
};

}  // namespace

TEST_CASE("of more answers than may wait, the one that has waited longest ends") {
  std::vector<Connection> connections(WaitingAnswers::most + 3);
  WaitingAnswers answers;
  std::list<WaitingAnswers::Place> places;
  const auto wait = [&](std::size_t i) { places.emplace_back(answers, connections[i].server()); };
  for (std::size_t i = 0; i < WaitingAnswers::most; ++i) wait(i);
  for (const auto& connection : connections) CHECK(connection.is_open());

  // The first goes on, and waits again: the second has waited longest now.
  places.pop_front();
  wait(0);
  for (const auto& connection : connections) CHECK(connection.is_open());
  wait(WaitingAnswers::most);
  CHECK(connections[0].is_open());
  CHECK_FALSE(connections[1].is_open());
  CHECK(connections[2].is_open());

  // The end of one that was shut down makes no room a second time.
  places.pop_front();
  wait(WaitingAnswers::most + 1);
  CHECK_FALSE(connections[2].is_open());
  CHECK(connections[3].is_open());
  places.pop_back();
  wait(WaitingAnswers::most + 2);
  CHECK(connections[3].is_open());
}
