#include "continua/core/replaced_file.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "continua/core/gzip_text.h"
#include "continua/core/put_in_place.h"

#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("a file is replaced by a whole one, or not at all") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  CHECK_FALSE(replace_file(path.string(), "old"));
  CHECK(text_of(path) == "old");
  {
    ReplacedFile file(path.string());
    file.stream() << "new";
    CHECK(text_of(path) == "old");
  }
  CHECK(text_of(path) == "old");
  ReplacedFile file(path.string());
  file.stream() << std::string(1'000'000, 'x');
  CHECK_FALSE(file.commit());
  CHECK(text_of(path).size() == 1'000'000);
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("pieces of any size are one after another in the file, also packed") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.txt", "a.txt.gz"}) {
    INFO(name);
    const auto path = (folder.path() / name).string();
    std::string all;
    ReplacedFile file(path);
    for (const int size : {3, 65536, 0, 65535, 70000, 1, 200000, 2}) {
      const std::string piece(static_cast<std::size_t>(size), static_cast<char>('a' + all.size() % 26));
      file.stream() << piece;
      all += piece;
    }
    REQUIRE_FALSE(file.commit());
    const auto read = read_text(path);
    REQUIRE(read);
    CHECK((*read == all));
  }
}

TEST_CASE("a file stays as it was where the program is killed in mid-writing, and nothing is left beside it") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  REQUIRE_FALSE(replace_file(path.string(), "old"));
  const auto child = ::fork();
  if (child == 0) {
    ReplacedFile file(path.string());
    file.stream() << std::string(1'000'000, 'x') << std::flush;
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  CHECK(text_of(path) == "old");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a file stays as it was where there is no room") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  REQUIRE_FALSE(replace_file(path.string(), "old"));
  const auto child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit least{100'000, 100'000};
    ::setrlimit(RLIMIT_FSIZE, &least);
    ReplacedFile file(path.string());
    file.stream() << std::string(1'000'000, 'x');
    const bool stopped = !file.stream();
    ::_exit(stopped && file.commit() ? 0 : 1);
  }
  int status = 1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(text_of(path) == "old");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("a file that another program wrote is put in place, or stays a part") {
  const TemporaryFolder folder;
  const auto part = folder.file("a.part", "new"), path = folder.file("a", "old");
  CHECK(put_in_place(part + ".not", path));
  CHECK(text_of(path) == "old");
  CHECK(put_in_place(part, folder.at("no folder/a"))->where == folder.at("no folder/a"));
  CHECK(text_of(part) == "new");
  CHECK_FALSE(put_in_place(part, path));
  CHECK(text_of(path) == "new");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("links are followed or replaced, and modes are kept") {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt", link = folder.path() / "link";
  REQUIRE_FALSE(replace_file(path.string(), "old"));
  ::chmod(path.c_str(), 0640);
  fs::create_symlink("a.txt", link);
  CHECK_FALSE(replace_file(link.string(), "new"));
  CHECK(fs::is_symlink(link));
  CHECK(text_of(path) == "new");
  struct stat told {};
  REQUIRE(::stat(path.c_str(), &told) == 0);
  CHECK((told.st_mode & 0777) == 0640);
  CHECK_FALSE(replace_file(link.string(), "other", ReplacedFile::Links::replace));
  CHECK_FALSE(fs::is_symlink(link));
  CHECK(text_of(path) == "new");
}

TEST_CASE("a file that cannot be written is told with its name") {
  const TemporaryFolder folder;
  const auto missing = (folder.path() / "nowhere" / "a.txt").string();
  const auto problem = replace_file(missing, "x");
  REQUIRE(problem);
  CHECK(problem->where == missing);
  CHECK(replace_file(folder.path().string(), "x"));
  CHECK(replace_file("/dev/full", "x"));
  CHECK_FALSE(replace_file("/dev/null", "x"));
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("an output is none of the inputs, by whatever name") {
  const TemporaryFolder folder;
  const auto a = (folder.path() / "a").string(), b = (folder.path() / "b").string();
  REQUIRE_FALSE(replace_file(a, "x"));
  fs::create_hard_link(a, b);
  const auto fresh = (folder.path() / "new").string();
  CHECK(not_an_input({a}, {a}));
  CHECK(not_an_input({a}, {"", "no such file", b}));
  CHECK_FALSE(not_an_input({a}, {"", "no such file", "/dev/null"}));
  CHECK_FALSE(not_an_input({"/dev/null"}, {"/dev/null"}));
  CHECK_FALSE(not_an_input({fresh}, {a}));
  const auto problem = not_an_input({fresh, b}, {a});
  REQUIRE(problem);
  CHECK(problem->text() == b + ": is also the output, and is read as " + a + "; expected another file");
}
