#include "continua/core/digest.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace continua {
namespace {

std::string hexadecimal(XXH128_hash_t hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }

struct FreeState {
  void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

}  // namespace

std::string digest(std::string_view bytes) { return hexadecimal(XXH3_128bits(bytes.data(), bytes.size())); }

std::uint64_t hash_of(std::string_view bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

struct RunningDigest::State {
  std::unique_ptr<XXH3_state_t, FreeState> hash{XXH3_createState()};
};

RunningDigest::RunningDigest() : state_(std::make_unique<State>()) { XXH3_128bits_reset(state_->hash.get()); }
RunningDigest::~RunningDigest() = default;
RunningDigest::RunningDigest(RunningDigest&&) noexcept = default;
RunningDigest& RunningDigest::operator=(RunningDigest&&) noexcept = default;

void RunningDigest::add(std::string_view bytes) { XXH3_128bits_update(state_->hash.get(), bytes.data(), bytes.size()); }

std::string RunningDigest::text() const { return hexadecimal(XXH3_128bits_digest(state_->hash.get())); }

}  // namespace continua
