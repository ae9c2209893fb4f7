// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/Blobs.h"

#include "base/ByteOrder.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>

namespace handwheel {

namespace {

// Number of lost elements per existing one at which the array is given up; an existing chunk, however short, counts as
// a whole one.
constexpr std::uint64_t kMostLost = 64;

std::string chunkName(const std::string& name, std::uint64_t chunk) {
  std::string digits = std::to_string(chunk);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return name + '/' + digits;
}

std::optional<std::uint64_t> chunkNumber(const std::string& name, const std::string& blob) {
  std::uint64_t chunk = 0;
  const char* const end = blob.data() + blob.size();
  const auto [stop, error] = std::from_chars(blob.data() + name.size() + 1, end, chunk);
  if (error != std::errc() || stop != end || blob != chunkName(name, chunk)) return {};
  return chunk;
}

template <class T>
std::string bytesOf(std::span<const T> values) {
  std::string blob;
  blob.reserve(values.size_bytes());
  for (const T& value : values) appendNumber(blob, value, std::endian::little);
  return blob;
}

template <class T>
void copyNumbers(std::string_view blob, T* to) {
  for (std::size_t i = 0; i < blob.size() / sizeof(T); ++i) {
    to[i] = loadNumber<T>(blob.data() + i * sizeof(T), std::endian::little);
  }
}

struct Chunk {
  std::uint64_t begin = 0, end = 0;  // elements
  const std::string* bytes = nullptr;
};

// Returns the chunks of the right size, in order.
std::vector<Chunk> soundChunks(const Container& container, const std::string& name, std::uint64_t count,
                               std::size_t elementSize) {
  std::vector<Chunk> chunks;
  for (auto blob = container.blobs.lower_bound(name + '/');
       blob != container.blobs.end() && blob->first.starts_with(name + '/'); ++blob) {
    const auto number = chunkNumber(name, blob->first);
    if (!number || *number >= (count + kChunkElements - 1) / kChunkElements) continue;
    const std::uint64_t begin = *number * kChunkElements, end = std::min<std::uint64_t>(count, begin + kChunkElements);
    if (blob->second.size() == (end - begin) * elementSize) chunks.push_back({begin, end, &blob->second});
  }
  // Names with more than four digits are not in order.
  std::sort(chunks.begin(), chunks.end(), [](const Chunk& a, const Chunk& b) { return a.begin < b.begin; });
  return chunks;
}

}  // namespace

template <class T>
std::string toBlob(const std::vector<T>& values) {
  return bytesOf(std::span<const T>(values));
}

template <class T>
std::vector<T> fromBlob(std::string_view blob) {
  std::vector<T> values(blob.size() / sizeof(T));
  copyNumbers(blob, values.data());
  return values;
}

template <class T>
void writeArray(Container& container, const std::string& name, std::span<const T> values, std::size_t numbers) {
  assert(numbers > 0 && values.size() % numbers == 0);
  const std::size_t chunkNumbers = kChunkElements * numbers;
  for (std::size_t i = 0; i * chunkNumbers < values.size(); ++i) {
    const std::size_t count = std::min(chunkNumbers, values.size() - i * chunkNumbers);
    container.blobs[chunkName(name, i)] = bytesOf(values.subspan(i * chunkNumbers, count));
  }
}

template <class T>
ReadArray<T> readArray(const Container& container, const std::string& name, std::uint64_t count, std::size_t numbers) {
  assert(numbers > 0);
  count = std::min<std::uint64_t>(count, kLargestContainer);  // no more elements than bytes
  std::vector<Chunk> chunks = soundChunks(container, name, count, numbers * sizeof(T));
  std::uint64_t present = 0;
  for (const Chunk& chunk : chunks) present += std::max<std::uint64_t>(chunk.end - chunk.begin, kChunkElements);
  if (!chunks.empty() && chunks.back().end > kMostLost * present) chunks.clear();

  ReadArray<T> read;
  if (!chunks.empty()) read.values.resize(chunks.back().end * numbers);
  std::uint64_t reached = 0;
  for (const Chunk& chunk : chunks) {
    if (chunk.begin > reached) read.lost.push_back({reached, chunk.begin});
    copyNumbers(*chunk.bytes, read.values.data() + chunk.begin * numbers);
    reached = chunk.end;
  }
  if (reached < count) read.lost.push_back({reached, count});
  return read;
}

#define HANDWHEEL_BLOB_OF(T)                                                                 \
  template std::string toBlob(const std::vector<T>&);                                        \
  template std::vector<T> fromBlob(std::string_view);                                        \
  template void writeArray(Container&, const std::string&, std::span<const T>, std::size_t); \
  template ReadArray<T> readArray(const Container&, const std::string&, std::uint64_t, std::size_t);
HANDWHEEL_BLOB_OF(double)
HANDWHEEL_BLOB_OF(float)
HANDWHEEL_BLOB_OF(std::uint8_t)
HANDWHEEL_BLOB_OF(std::int8_t)
HANDWHEEL_BLOB_OF(std::uint16_t)
HANDWHEEL_BLOB_OF(std::int16_t)
HANDWHEEL_BLOB_OF(std::uint32_t)
HANDWHEEL_BLOB_OF(std::int32_t)
HANDWHEEL_BLOB_OF(std::uint64_t)
HANDWHEEL_BLOB_OF(std::int64_t)
#undef HANDWHEEL_BLOB_OF

}  // namespace handwheel
