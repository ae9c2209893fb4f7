// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/LocalEntries.h"

#include "base/ByteOrder.h"

#include <zlib.h>
#include <algorithm>
#include <limits>

namespace handwheel {

namespace {

constexpr std::size_t kHeaderSize = 30;
constexpr std::size_t kLongestEntryName = 1000;
constexpr std::uint16_t kStored = 0, kDeflated = 8;
constexpr std::uint16_t kEncryptedFlag = 1, kStreamedFlag = 8;
constexpr std::size_t kSearchBlock = 256 * 1024;
constexpr std::string_view kLocalHeader("PK\3\4", 4), kDirectoryHeader("PK\1\2", 4), kDescriptor("PK\7\10", 4);

std::uint16_t number16(std::string_view bytes, std::size_t at) {
  return loadNumber<std::uint16_t>(bytes.data() + at, std::endian::little);
}
std::uint32_t number32(std::string_view bytes, std::size_t at) {
  return loadNumber<std::uint32_t>(bytes.data() + at, std::endian::little);
}

struct Header {
  LocalEntry entry;
  bool isUsable = false;
};

Header parseHeader(std::string_view archive, std::size_t at) {
  Header header;
  if (archive.size() - at < kHeaderSize) return header;
  const std::string_view fields = archive.substr(at, kHeaderSize);
  const std::uint16_t flags = number16(fields, 6), method = number16(fields, 8);
  const std::size_t nameLength = number16(fields, 26), extraLength = number16(fields, 28);
  LocalEntry& entry = header.entry;
  entry.checksum = number32(fields, 14);
  entry.compressed = number32(fields, 18);
  entry.size = number32(fields, 22);
  entry.isDeflated = method == kDeflated;
  entry.isStreamed = (flags & kStreamedFlag) != 0;
  entry.data = at + kHeaderSize + nameLength + extraLength;
  if (entry.data > archive.size() || nameLength == 0 || nameLength > kLongestEntryName) return header;
  entry.name = archive.substr(at + kHeaderSize, nameLength);
  // Stored data of unknown length has no recognisable end.
  const bool hasEnd = entry.isDeflated || !entry.isStreamed;
  header.isUsable = (flags & kEncryptedFlag) == 0 && (method == kStored || method == kDeflated) && hasEnd;
  return header;
}

// Returns the text in which the next header is sought.
std::size_t behind(std::string_view archive, const LocalEntry& entry) {
  if (!entry.isStreamed && entry.compressed <= archive.size() - entry.data) {
    const std::string_view rest = archive.substr(entry.data + entry.compressed);
    if (rest.starts_with(kLocalHeader) || rest.starts_with(kDirectoryHeader)) return entry.data + entry.compressed;
  }
  return entry.data;
}

// Inflates raw deflate data, block by block.
class Inflation {
 public:
  explicit Inflation(std::string_view input) : m_input(input) {
    m_isReady = inflateInit2(&m_stream, -MAX_WBITS) == Z_OK;
  }
  ~Inflation() {
    if (m_isReady) inflateEnd(&m_stream);
  }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  bool isReady() const { return m_isReady; }
  bool atEnd() const { return m_atEnd; }
  std::size_t consumed() const { return m_consumed; }

  // Appends at most one block. Returns false at the end.
  bool next(std::string& to, std::uint64_t most) {
    const std::size_t before = to.size();
    const auto room = static_cast<std::size_t>(std::min<std::uint64_t>(kSearchBlock, most));
    const std::size_t offered = std::min(kSearchBlock, m_input.size() - m_consumed);
    if (m_atEnd || room == 0) return false;
    to.resize(before + room);
    m_stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(m_input.data() + m_consumed));
    m_stream.avail_in = static_cast<uInt>(offered);
    m_stream.next_out = reinterpret_cast<Bytef*>(to.data() + before);
    m_stream.avail_out = static_cast<uInt>(room);
    const int outcome = inflate(&m_stream, Z_NO_FLUSH);
    m_consumed += offered - m_stream.avail_in;
    to.resize(before + room - m_stream.avail_out);
    m_atEnd = outcome == Z_STREAM_END;
    return outcome == Z_OK;
  }

 private:
  std::string_view m_input;
  z_stream m_stream{};
  std::size_t m_consumed = 0;
  bool m_isReady = false;
  bool m_atEnd = false;
};

std::uint32_t checksumOf(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// Checks the descriptor after the data of a streamed entry: the signature, which is optional, checksum, both sizes.
bool matchesDescriptor(std::string_view behind, std::string_view bytes) {
  if (behind.starts_with(kDescriptor)) behind.remove_prefix(kDescriptor.size());
  constexpr std::size_t kFields = 12;
  return behind.size() >= kFields && number32(behind, 0) == checksumOf(bytes) &&
         number32(behind, 8) == static_cast<std::uint32_t>(bytes.size());
}

}  // namespace

std::vector<LocalEntry> findLocalEntries(std::string_view archive, std::size_t most) {
  std::vector<LocalEntry> entries;
  std::size_t at = archive.find(kLocalHeader);
  while (at != std::string_view::npos && entries.size() < most) {
    Header header = parseHeader(archive, at);
    const std::size_t from = header.isUsable ? behind(archive, header.entry) : at + kLocalHeader.size();
    if (header.isUsable) entries.push_back(std::move(header.entry));
    at = archive.find(kLocalHeader, from);
  }
  return entries;
}

UnpackedEntry unpackLocalEntry(std::string_view archive, const LocalEntry& entry, std::uint64_t most,
                               std::uint64_t& work, const Progress& progress) {
  UnpackedEntry unpacked;
  const std::string_view rest = archive.substr(entry.data);
  const std::string_view packed = entry.isStreamed ? rest : rest.substr(0, entry.compressed);
  const auto spend = [&work](std::uint64_t amount) { work -= std::min(work, amount); };
  if (!entry.isDeflated) {
    unpacked.bytes = packed.substr(0, static_cast<std::size_t>(std::min(most, work)));
    spend(2 * unpacked.bytes.size() + 1);
    unpacked.isWhole = unpacked.bytes.size() == entry.size && checksumOf(unpacked.bytes) == entry.checksum;
    return unpacked;
  }
  Inflation inflation(packed);
  bool goesOn = inflation.isReady();
  while (goesOn && work > 0 && !progress.cancelled()) {
    const std::size_t before = inflation.consumed() + unpacked.bytes.size();
    // One more than allowed: the end of the stream may be after the last byte.
    goesOn = unpacked.bytes.size() <= most && inflation.next(unpacked.bytes, most + 1 - unpacked.bytes.size());
    spend(inflation.consumed() + unpacked.bytes.size() - before + 1);
  }
  if (!inflation.atEnd() || unpacked.bytes.size() > most) return unpacked;
  unpacked.isWhole = entry.isStreamed
                         ? matchesDescriptor(rest.substr(inflation.consumed()), unpacked.bytes)
                         : unpacked.bytes.size() == entry.size && checksumOf(unpacked.bytes) == entry.checksum;
  return unpacked;
}

}  // namespace handwheel
