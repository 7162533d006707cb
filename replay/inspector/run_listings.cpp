#include "continua/replay/inspector/run_listings.h"

#include <algorithm>
#include <chrono>

#include "continua/replay/log/run_listing.h"

namespace continua {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t prepared_runs = 2;
constexpr auto patience = 100ms;  // the start page waits so long for runs that are nearly read

double seconds_since_1970(std::filesystem::file_time_type time) {
  return std::chrono::duration<double>(std::chrono::file_clock::to_sys(time).time_since_epoch()).count();
}

}  // namespace

void RunListings::start(std::function<void(const std::string& id)> prepare) {
  prepare_ = std::move(prepare);
  wanted_ = true;
  thread_ = std::thread([this] { work(); });
}

void RunListings::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wanted_changed_.notify_all();
  known_changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

std::vector<RunListings::Listed> RunListings::newest_first() {
  std::vector<Listed> all;
  for (auto& file : library_.runs()) {
    const auto state = file_state(file.path);
    all.push_back({std::move(file), state});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Listed& a, const Listed& b) { return a.state.written > b.state.written; });
  return all;
}

// REQUIRES that the mutex is held.
bool RunListings::is_known(const Listed& one) {
  const auto known = known_.find(one.file.path);
  return known != known_.end() && known->second.state == one.state;
}

void RunListings::look_into(const Listed& one) {
  const auto run = library_.look_into(one.file);
  const auto listing = run ? run_listing(**run) : Result<Json>(run.error());
  Json line = listing ? *listing : Json{{"error", {{"message", listing.error().text()}}}};
  const std::lock_guard lock(mutex_);
  known_.insert_or_assign(one.file.path, Known{one.state, std::move(line)});
}

void RunListings::work() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      wanted_changed_.wait(lock, [this] { return wanted_ || stopping_; });
      if (stopping_) return;
      wanted_ = false;
    }
    std::size_t prepared = 0;
    const auto all = newest_first();
    for (const auto& one : all) {
      {
        const std::lock_guard lock(mutex_);
        if (stopping_) return;
      }
      // First, so that its index is there for the listing.
      if (prepared++ < prepared_runs) prepare_(one.file.id);
      bool known = false;
      {
        const std::lock_guard lock(mutex_);
        known = is_known(one);
      }
      if (known) continue;
      look_into(one);
      known_changed_.notify_all();
    }
    const std::lock_guard lock(mutex_);
    std::erase_if(known_, [&](const auto& known) {
      return std::none_of(all.begin(), all.end(), [&](const Listed& one) { return one.file.path == known.first; });
    });
  }
}

Json RunListings::all() {
  const auto all = newest_first();
  const auto every_known = [&] {
    return std::all_of(all.begin(), all.end(), [this](const Listed& one) { return is_known(one); });
  };
  std::unique_lock lock(mutex_);
  if (thread_.joinable() && !every_known()) {
    wanted_ = true;
    wanted_changed_.notify_all();
    known_changed_.wait_for(lock, patience, [&] { return stopping_ || every_known(); });
  } else if (!thread_.joinable()) {
    for (const auto& one : all) {
      if (is_known(one)) continue;
      lock.unlock();
      look_into(one);
      lock.lock();
    }
  }
  Json lines = Json::array();
  for (const auto& one : all) {
    const auto changed = seconds_since_1970(one.state.written);
    Json line{{"id", one.file.id}, {"name", one.file.name}, {"changed", changed}};
    if (!one.file.what_if_of.empty()) line["what_if_of"] = one.file.what_if_of;
    const auto known = known_.find(one.file.path);
    if (known != known_.end()) line.update(known->second.line);
    if (!is_known(one)) line["pending"] = true;
    line["bytes"] = one.state.bytes;
    line["live"] = !line.contains("error") && !line.value("complete", false) &&
                   library_.is_being_written(one.file.path, one.state);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace continua
