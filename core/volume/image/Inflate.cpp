// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/Inflate.h"

#include "process/SystemMemory.h"

#include <zlib.h>
#include <algorithm>

namespace handwheel {
namespace {

// Ends a stream of zlib with its scope.
struct InflateStream {
  z_stream stream{};
  bool isOpen;

  InflateStream() : isOpen(inflateInit2(&stream, MAX_WBITS + 32) == Z_OK) {}  // 32: gzip or zlib, as it begins
  ~InflateStream() {
    if (isOpen) inflateEnd(&stream);
  }
  InflateStream(const InflateStream&) = delete;
  InflateStream& operator=(const InflateStream&) = delete;
};

}  // namespace

bool looksLikeGzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

Result<std::string> inflated(std::string_view packed, std::size_t most) {
  constexpr std::size_t kStep = std::size_t{1} << 20, kLongestInput = std::size_t{1} << 30;
  const std::size_t allowed = systemMemory() / 4;  // the result of parsing the bytes needs memory, too
  if (most > allowed)
    return Error{ErrorCode::FileTooLarge,
                 {"bytes of the unpacked image", std::to_string(most), std::to_string(allowed)},
                 {},
                 {}};
  InflateStream own;
  if (!own.isOpen) return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  std::string plain;
  int status = Z_OK;
  while (plain.size() < most && status != Z_STREAM_END) {
    if (own.stream.avail_in == 0) {
      if (packed.empty()) return Error{ErrorCode::LibraryFailed, {"zlib", "the compressed data end too early"}, {}, {}};
      const std::string_view next = packed.substr(0, kLongestInput);
      own.stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(next.data()));  // not written to
      own.stream.avail_in = static_cast<uInt>(next.size());
      packed.remove_prefix(next.size());
    }
    const std::size_t before = plain.size(), room = std::min(most - before, std::max(kStep, before));
    plain.resize(before + std::min(room, kLongestInput));
    own.stream.next_out = reinterpret_cast<Bytef*>(plain.data() + before);
    own.stream.avail_out = static_cast<uInt>(plain.size() - before);
    status = inflate(&own.stream, Z_NO_FLUSH);
    plain.resize(plain.size() - own.stream.avail_out);
    if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
      return Error{ErrorCode::LibraryFailed, {"zlib", "the compressed data are damaged"}, {}, {}};
  }
  return plain;
}

}  // namespace handwheel
