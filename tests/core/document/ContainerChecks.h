// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <rapidcheck.h>
#include <zlib.h>
#include <QProcess>
#include <QString>
#include <cstring>
#include <nlohmann/json.hpp>

namespace handwheel::test {

using nlohmann::json;

// Returns arbitrary JSON. It uses few different keys, so that two results have some in common.
inline json anyJson(int depth) {
  switch (*rc::gen::inRange(0, depth > 0 ? 8 : 6)) {
    case 0:
      return nullptr;
    case 1:
      return *rc::gen::arbitrary<bool>();
    case 2:
      return *rc::gen::arbitrary<std::int64_t>();
    case 3:
      return *rc::gen::arbitrary<std::uint64_t>();
    case 4:
      return *rc::gen::inRange(-1000000, 1000000) / 7.0;
    case 5:
      return *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
    case 6: {
      json array = json::array();
      for (int i = *rc::gen::inRange(0, 3); i > 0; --i) array.push_back(anyJson(depth - 1));
      return array;
    }
    default: {
      json object = json::object();
      for (int i = *rc::gen::inRange(0, 5); i > 0; --i)
        object[std::string(1, *rc::gen::inRange('a', 'g'))] = anyJson(depth - 1);
      return object;
    }
  }
}

inline json anyObject(int depth) {
  json object = json::object();
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i)
    object[std::string(1, *rc::gen::inRange('a', 'g'))] = anyJson(depth);
  return object;
}

inline Container anyContainer() {
  Container container;
  *container.manifest = anyObject(3);
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
    const std::string folder = *rc::gen::element<std::string>("", "mesh/", "mesh/faces/", "a b/");
    container.blobs[folder + std::to_string(i)] = *rc::gen::arbitrary<std::string>();
  }
  return container;
}

// Returns the manifest without the keys that the writer adds.
inline json ownPart(json manifest) {
  manifest.erase("handwheel");
  return manifest;
}

// A ZIP archive that is written byte by byte according to APPNOTE.TXT, so that it can be wrong in any respect.
class HandmadeZip {
 public:
  struct Entry {
    std::string name, data;      // data: the bytes in the archive
    std::uint32_t size = 0;      // announced size of the unpacked data
    std::uint32_t checksum = 0;  // announced checksum
    std::uint16_t flags = 0, method = 0;
  };

  static Entry stored(std::string name, std::string bytes) {
    const std::uint32_t sum = checksumOf(bytes);
    const auto size = static_cast<std::uint32_t>(bytes.size());
    return {std::move(name), std::move(bytes), size, sum};
  }

  static Entry deflated(std::string name, const std::string& bytes) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return {std::move(name), std::move(packed), static_cast<std::uint32_t>(bytes.size()), checksumOf(bytes), 0, 8};
  }

  HandmadeZip& add(const Entry& entry) {
    const auto offset = static_cast<std::uint32_t>(m_bytes.size());
    m_bytes += "PK\3\4";
    header(m_bytes, entry);
    m_bytes += entry.name + entry.data;
    list(entry, offset);
    return *this;
  }

  // Adds an entry to the directory only.
  HandmadeZip& list(const Entry& entry, std::uint32_t offset) {
    m_directory += "PK\1\2";
    number<std::uint16_t>(m_directory, 20);
    header(m_directory, entry);
    m_directory += std::string(2 + 2 + 2 + 4, '\0');  // comment, disk, attributes
    number(m_directory, offset);
    m_directory += entry.name;
    ++m_count;
    return *this;
  }

  std::string withoutDirectory() const { return m_bytes; }

  std::string bytes() const {
    std::string all = m_bytes + m_directory + "PK\5\6" + std::string(4, '\0');
    number(all, m_count);
    number(all, m_count);
    number(all, static_cast<std::uint32_t>(m_directory.size()));
    number(all, static_cast<std::uint32_t>(m_bytes.size()));
    return all + std::string(2, '\0');
  }

  static std::uint32_t checksumOf(const std::string& bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
  }

 private:
  template <class T>
  static void number(std::string& to, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) to += static_cast<char>(value >> (8 * i));
  }

  // Writes the fields that the local header and the directory have in common.
  static void header(std::string& to, const Entry& entry) {
    number<std::uint16_t>(to, 20);
    number(to, entry.flags);
    number(to, entry.method);
    number<std::uint32_t>(to, 0x00210000);  // 1 January 1980
    number(to, entry.checksum);
    number(to, static_cast<std::uint32_t>(entry.data.size()));
    number(to, entry.size);
    number(to, static_cast<std::uint16_t>(entry.name.size()));
    number<std::uint16_t>(to, 0);
  }

  std::string m_bytes, m_directory;
  std::uint16_t m_count = 0;
};

// Returns a small manifest in the format of this program.
inline std::string plainManifest() {
  return R"({"handwheel": {"format": 1}, "kind": "mesh"})";
}

// Returns the output of a Python program that gets bytes on standard input; "failed: ..." if it fails.
inline QString python(const QString& program, const std::string& input) {
  QProcess process;
  process.start("python3", {"-c", program});
  process.write(input.data(), static_cast<qint64>(input.size()));
  process.closeWriteChannel();
  if (!process.waitForFinished() || process.exitCode() != 0) return "failed: " + process.readAllStandardError();
  return QString::fromUtf8(process.readAllStandardOutput()).trimmed();
}

}  // namespace handwheel::test
