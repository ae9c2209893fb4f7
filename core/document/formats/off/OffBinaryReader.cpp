// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/off/OffBinaryReader.h"

#include "base/ByteOrder.h"
#include "document/formats/MeshAssembly.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kWord = 4;  // every number in the file has four bytes
constexpr std::size_t kCounts = 3 * kWord;
constexpr std::size_t kUsualFace = 4 * kWord;  // a triangle without colour

class BinaryReader {
 public:
  BinaryReader(std::string_view bytes, std::size_t bodyAt, OffKeyword keyword, const ReadOptions& options,
               Progress progress)
      : m_bytes(bytes), m_at(bodyAt), m_keyword(keyword), m_assembly(options, progress, bytes.size()) {
    const unsigned numbers = 3u + (keyword.normal ? 3u : 0u) + (keyword.colour ? 4u : 0u) + (keyword.texture ? 2u : 0u);
    m_vertexSize = numbers * kWord;
  }

  Result<MeshFile> read() {
    if (room() < kCounts)
      truncated("bytes", m_at + kCounts, m_bytes.size());
    else if (readCounts() && readVertices() && readFaces() && room() > 0)
      m_assembly.noteExcess(m_at, InputPosition::byte(m_at));
    return m_assembly.finish(NumberType::Float32);
  }

 private:
  std::size_t room() const { return m_bytes.size() - m_at; }

  std::uint32_t wordAt(std::size_t at) const { return loadNumber<std::uint32_t>(m_bytes.data() + at, m_order); }

  // Returns the number of bytes that the counts require in this byte order.
  std::uint64_t bytesNeeded(std::endian order) const {
    const std::uint64_t vertices = loadNumber<std::uint32_t>(m_bytes.data() + m_at, order);
    const std::uint64_t faces = loadNumber<std::uint32_t>(m_bytes.data() + m_at + kWord, order);
    return vertices * m_vertexSize + faces * kUsualFace;
  }

  bool readCounts() {
    const std::uint64_t big = bytesNeeded(std::endian::big), little = bytesNeeded(std::endian::little);
    const bool fitsBig = big <= room() - kCounts, fitsLittle = little <= room() - kCounts;
    const bool isBig = fitsBig || (!fitsLittle && big <= little);
    m_order = isBig ? std::endian::big : std::endian::little;
    m_vertices = wordAt(m_at);
    m_faces = wordAt(m_at + kWord);
    m_at += kCounts;
    return true;
  }

  bool readVertices() {
    const std::size_t there = std::min<std::size_t>(m_vertices, room() / m_vertexSize);
    for (std::size_t i = 0; i < there; ++i, m_at += m_vertexSize) {
      if (!m_assembly.advance(m_at)) return false;
      Vec3 p;
      for (std::size_t k = 0; k < 3; ++k)
        p[static_cast<Eigen::Index>(k)] = rounded(
            static_cast<double>(loadNumber<float>(m_bytes.data() + m_at + k * kWord, m_order)), NumberType::Float32);
      const bool added =
          p.allFinite()
              ? m_assembly.addPoint(p)
              : m_assembly.addUnreadablePoint(
                    {ErrorCode::NumberNotFinite, {p.hasNaN() ? "nan" : "inf"}, InputPosition::byte(m_at), {}});
      if (!added) return false;
    }
    m_assembly.allPointsAdded();
    if (there < m_vertices) return truncated("vertices", m_vertices, there);
    if (m_keyword.normal) m_assembly.lose(LostAttribute::Normals);
    if (m_keyword.colour) m_assembly.lose(LostAttribute::Colour);
    if (m_keyword.texture) m_assembly.lose(LostAttribute::TextureCoordinates);
    return true;
  }

  bool readFaces() {
    const bool colours = facesHaveColourCounts();
    for (std::uint32_t i = 0; i < m_faces; ++i) {
      if (!m_assembly.advance(m_at)) return false;
      const std::size_t end = faceEnd(m_at, colours);
      if (end == 0) return truncated("faces", m_faces, i);
      const std::uint32_t count = wordAt(m_at);
      m_corners.clear();
      for (std::uint32_t k = 0; k < count; ++k) m_corners.push_back(wordAt(m_at + (k + 1) * kWord));
      if (colours && wordAt(m_at + (count + 1) * kWord) > 0) m_assembly.lose(LostAttribute::Colour);
      const InputPosition start = InputPosition::byte(m_at);
      m_at = end;
      if (count == 1) m_assembly.lose(LostAttribute::Points);
      if (count == 2) m_assembly.lose(LostAttribute::Lines);
      if (count != 1 && count != 2 && !m_assembly.addPolygon(m_corners, start)) return false;
    }
    return true;
  }

  // Returns the end of the face that begins here; 0 if the file ends sooner.
  std::size_t faceEnd(std::size_t at, bool colours) const {
    for (int part = 0; part < (colours ? 2 : 1); ++part) {
      if (m_bytes.size() - at < kWord) return 0;
      const std::uint64_t length = (std::uint64_t{wordAt(at)} + 1) * kWord;
      if (length > m_bytes.size() - at) return 0;
      at += static_cast<std::size_t>(length);
    }
    return at;
  }

  // The interpretation that ends with the file and has all faces is right; if none does, the one with more faces.
  bool facesHaveColourCounts() {
    const Walk without = walkFaces(false), with = walkFaces(true);
    if (with.complete || without.complete) return with.complete;
    return with.faces > without.faces || (with.faces == without.faces && m_order == std::endian::big);
  }

  struct Walk {
    std::uint32_t faces = 0;  // up to the first without corners or whose corner is no vertex
    bool complete = false;
  };

  Walk walkFaces(bool colours) {
    Walk walk;
    std::size_t at = m_at;
    for (; walk.faces < m_faces && m_assembly.step(); ++walk.faces) {
      const std::size_t end = faceEnd(at, colours);
      const bool sane = end != 0 && wordAt(at) > 0 && wordAt(at + kWord) < m_vertices;
      if (!sane) break;
      at = end;
    }
    walk.complete = walk.faces == m_faces && at == m_bytes.size();
    return walk;
  }

  bool truncated(const char* what, std::uint64_t expected, std::uint64_t found) {
    m_assembly.tolerate({ErrorCode::DataTruncated,
                         {what, std::to_string(expected), std::to_string(found)},
                         InputPosition::byte(m_bytes.size()),
                         {}});
    return false;
  }

  std::string_view m_bytes;
  std::size_t m_at;
  OffKeyword m_keyword;
  MeshAssembly m_assembly;
  std::size_t m_vertexSize = 0;
  std::endian m_order = std::endian::big;
  std::uint32_t m_vertices = 0;
  std::uint32_t m_faces = 0;
  std::vector<std::int64_t> m_corners;
};

}  // namespace

Result<MeshFile> readBinaryOff(std::string_view bytes, std::size_t headerEnd, OffKeyword keyword,
                               const ReadOptions& options, Progress progress) {
  const std::size_t lineEnd = bytes.find('\n', headerEnd);
  const std::size_t bodyAt = lineEnd == std::string_view::npos ? bytes.size() : lineEnd + 1;
  return BinaryReader(bytes, bodyAt, keyword, options, progress).read();
}

}  // namespace handwheel
