#include "continua/core/growing_file.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
using Begin = GrowingFile::Begin;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("pieces are in the file as soon as they are added") {
  const TemporaryFolder folder;
  const auto path = folder.at("a");
  GrowingFile file(path, Begin::first);
  CHECK_FALSE(file.add("one "));
  CHECK_FALSE(file.add("two "));
  CHECK(text_of(path) == "one two ");
  CHECK(file.bytes() == 8);
  CHECK_FALSE(file.sync());
  CHECK_FALSE(file.close());
  CHECK_FALSE(file.close());
  CHECK_FALSE(GrowingFile(path, Begin::after).add("three"));
  CHECK(text_of(path) == "one two three");
  CHECK(GrowingFile(path, Begin::anew).sound());
  CHECK(text_of(path).empty());
}

TEST_CASE("a file may be closed while another thread syncs it") {
  const TemporaryFolder folder;
  for (int i = 0; i < 50; ++i) {
    GrowingFile file(folder.at(std::to_string(i)), Begin::first);
    std::atomic<int> begun = 0;
    std::atomic<bool> over = false;
    std::vector<std::thread> others(4);
    for (auto& other : others)
      other = std::thread([&] {
        for (++begun; !over;) (void)file.sync();
      });
    while (begun < 4) std::this_thread::yield();
    CHECK_FALSE(file.close());
    over = true;
    for (auto& other : others) other.join();
    CHECK(file.sound());
  }
}

TEST_CASE("a file that is there is not begun again") {
  const TemporaryFolder folder;
  const auto path = folder.file("a", "old");
  GrowingFile file(path, Begin::first);
  CHECK_FALSE(file.sound());
  CHECK(file.add("new"));
  CHECK(file.fault().where == path);
  CHECK(text_of(path) == "old");
}

TEST_CASE("a piece that does not fit is not in the file, nor any after it") {
  const TemporaryFolder folder;
  const auto path = folder.file("a", "before ");
  const auto child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit least{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &least);
    GrowingFile file(path, Begin::after);
    const bool first = !file.add("whole "), second = !file.add(std::string(200, 'x')), third = !file.add("more");
    ::_exit(first && !second && !third && file.close() && file.bytes() == 6 ? 0 : 1);
  }
  int status = 1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(text_of(path) == "before whole ");
  CHECK(GrowingFile("/dev/full", Begin::anew).add("x"));
  CHECK_FALSE(GrowingFile("/dev/null", Begin::anew).add("x"));
}
