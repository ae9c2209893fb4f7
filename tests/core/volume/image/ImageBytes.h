// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/ByteOrder.h"
#include "volume/image/ImageFile.h"

#include <zlib.h>
#include <map>
#include <string>
#include <vector>

namespace handwheel::test {

// Returns numbers as the bytes of a file.
template <class Number>
std::string bytesOfNumbers(const std::vector<Number>& numbers, std::endian order = std::endian::little) {
  std::string bytes;
  for (const Number n : numbers) appendNumber(bytes, n, order);
  return bytes;
}

inline std::string packed(const std::string& plain, bool isGzip) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS + (isGzip ? 16 : 0), 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, plain.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

// Returns a function that reads these files as the siblings of another file, by their names.
inline SiblingFile beside(std::map<std::string, std::string> files) {
  return [files = std::move(files)](const std::string& name, std::size_t most) -> Result<std::string> {
    const auto found = files.find(name);
    if (found == files.end()) return Error{ErrorCode::FileMissing, {}, {}, {}};
    return found->second.substr(0, most);
  };
}

inline std::vector<double> valuesIn(const ImageVolume& image) {
  std::vector<double> values;
  for (std::size_t i = 0; i < image.grid().count(); ++i) values.push_back(image.value(i));
  return values;
}

inline bool hasRemark(const ImageFile& file, ImageRemark::Kind kind) {
  for (const ImageRemark& remark : file.remarks)
    if (remark.kind == kind) return true;
  return false;
}

// Calls the reader with truncated files, and with files in which one byte is changed. The reader may return errors, but
// must not crash.
template <class Read>
void readDamaged(const std::string& bytes, Read read) {
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 64) (void)read(bytes.substr(0, n));
  for (std::size_t n = 0; n < bytes.size(); ++n)
    for (const char c : {'\0', '-', '9', '\xff'}) {
      std::string other = bytes;
      other[n] = c;
      (void)read(other);
    }
}

}  // namespace handwheel::test
