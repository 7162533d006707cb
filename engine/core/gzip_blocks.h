// Packs texts as gzip files in blocks that can be unpacked one without the other, as bgzip does (BGZF). Programs that
// know nothing of blocks read them as any gzip file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace continua {

/// Bytes of text in a block at most.
inline constexpr std::size_t longest_block_text = 0xff00;

/// Takes a text in parts. The same text gives the same bytes, whatever the parts are and whenever it is.
class GzipBlocks {
 public:
  /// The blocks that are full now. A block ends with a line, unless the line is longer than a block.
  std::string add(std::string_view part);
  /// The rest, and the empty block that tells that nothing was cut off.
  std::string finish();

 private:
  std::string held_;
};

/// The length of a whole block, packed, by its first bytes; nothing if these do not begin such a block.
inline constexpr std::size_t block_head_bytes = 18;
std::optional<std::uint32_t> block_bytes_of(std::string_view head);

/// The length of its text, by its last bytes.
inline constexpr std::size_t block_tail_bytes = 4;
std::uint32_t text_bytes_of(std::string_view tail);

}  // namespace continua
