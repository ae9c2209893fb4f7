// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/ply/PlyReader.h"

#include "document/formats/MeshAssembly.h"
#include "document/formats/MeshFileErrors.h"
#include "document/formats/ply/PlyLayout.h"
#include "document/formats/ply/PlyRows.h"

#include <algorithm>

namespace handwheel {

namespace {

template <class Rows>
class BodyReader {
 public:
  BodyReader(std::string_view bytes, const PlyHeader& header, const ReadOptions& options, Progress progress)
      : m_header(header), m_assembly(options, progress, bytes.size()), m_rows(bytes, header) {}

  Result<MeshFile> read() {
    bool whole = true;
    std::size_t vertexElements = static_cast<std::size_t>(std::count_if(
        m_header.elements.begin(), m_header.elements.end(), [](const PlyElement& e) { return e.name == "vertex"; }));
    for (std::size_t i = 0; i < m_header.elements.size(); ++i) {
      if (vertexElements == 0) m_assembly.allPointsAdded();
      if (m_header.elements[i].name == "vertex") --vertexElements;
      whole = readElement(i);
      if (!whole) break;
    }
    m_assembly.allPointsAdded();
    if (whole && m_rows.hasExcess()) m_assembly.noteExcess(m_rows.position(), m_rows.inputPosition());
    return m_assembly.finish(coordinateType(m_header));
  }

 private:
  bool readElement(std::size_t number) {
    const PlyElement& element = m_header.elements[number];
    if (element.count == 0 || element.properties.empty()) return true;
    const PlyLayout layout = layoutOf(element);
    if (!layout.missing.empty())
      return m_assembly.fail(
          {ErrorCode::HeaderMalformed, {"property " + layout.missing}, InputPosition::line(m_header.bodyLine - 1), {}});
    for (const auto& [lost, name] : layout.lost) m_assembly.lose(lost, name);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!m_assembly.advance(m_rows.position())) return false;
      const InputPosition position = m_rows.inputPosition();
      const bool isThere = m_rows.begin();
      const auto start = m_rows.mark();
      RowState state = isThere ? readRow(layout) : RowState::Ended;
      if (state == RowState::Bad && rowsRunOn(start, number, i)) {
        m_rows.returnTo(start);
        m_rows.runOn();
        state = readRow(layout);
      }
      if (state == RowState::Ended) {
        const bool isRefused = isThere && m_rows.error().code == MeshFileError::TokenUnexpected;
        m_assembly.tolerate(isRefused ? m_rows.error()
                                      : Error{ErrorCode::DataTruncated,
                                              {layout.rowsName, std::to_string(element.count), std::to_string(i)},
                                              position,
                                              {}});
        return false;
      }
      if (state == RowState::Bad) m_rows.abandon();
      if (!(state == RowState::Good ? store(layout, position) : storeBad(layout))) return false;
    }
    return true;
  }

  // Returns true if all rows from a mark on run on over lines: read so, the last one ends with the file. Decided once.
  bool rowsRunOn(const auto& start, std::size_t number, std::uint64_t row) {
    if (m_hasDecided || !m_rows.isOfOtherLength()) return false;
    m_hasDecided = true;
    Rows ahead = m_rows;
    ahead.returnTo(start);
    ahead.runOn();
    for (; number < m_header.elements.size(); ++number, row = 0) {
      const PlyElement& element = m_header.elements[number];
      for (; row < element.count && !element.properties.empty(); ++row) {
        for (const PlyProperty& property : element.properties) {
          std::int64_t count = 1;
          if (property.countType && ahead.integer(*property.countType, count) != RowState::Good) return false;
          for (std::int64_t i = 0; i < count; ++i)
            if (!m_assembly.step() || ahead.skip(property.type, 1) != RowState::Good) return false;
        }
      }
    }
    return !ahead.hasExcess();
  }

  RowState readRow(const PlyLayout& layout) {
    m_corners.clear();
    for (const PlyField& field : layout.fields) {
      const RowState state = field.countType ? readList(field) : readScalar(field);
      if (state != RowState::Good) return state;
    }
    return m_rows.end();
  }

  RowState readScalar(const PlyField& field) {
    if (field.role == PlyField::Role::Skipped) return m_rows.skip(field.type, 1);
    return m_rows.number(field.type, m_point[static_cast<Eigen::Index>(field.role)]);
  }

  RowState readList(const PlyField& field) {
    const InputPosition position = m_rows.inputPosition();
    std::int64_t count = 0;
    if (const RowState state = m_rows.integer(*field.countType, count); state != RowState::Good) return state;
    if (count < 0)
      return m_rows.refuse({MeshFileError::TokenUnexpected, {"a count", std::to_string(count)}, position, {}});
    if (field.role == PlyField::Role::Skipped) return m_rows.skip(field.type, static_cast<std::uint64_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
      std::int64_t corner = 0;
      if (!m_assembly.step()) return RowState::Ended;
      if (const RowState state = m_rows.integer(field.type, corner); state != RowState::Good) return state;
      m_corners.push_back(corner);
    }
    return RowState::Good;
  }

  bool store(const PlyLayout& layout, InputPosition position) {
    switch (layout.kind) {
      case PlyLayout::Kind::Vertices:
        if (m_point.allFinite()) return m_assembly.addPoint(m_point);
        return m_assembly.addUnreadablePoint(
            {ErrorCode::NumberNotFinite, {m_point.hasNaN() ? "nan" : "inf"}, position, {}});
      case PlyLayout::Kind::Faces:
        return m_assembly.addPolygon(m_corners, position);
      case PlyLayout::Kind::Strips:
        return addStrips(position);
      case PlyLayout::Kind::Other:
        break;
    }
    return true;
  }

  bool storeBad(const PlyLayout& layout) {
    if (layout.kind == PlyLayout::Kind::Vertices) return m_assembly.addUnreadablePoint(m_rows.error());
    return m_assembly.tolerate(m_rows.error());
  }

  // Adds strips. Strips of one row are separated by -1; every second triangle is reversed.
  bool addStrips(InputPosition position) {
    std::size_t start = 0;
    for (std::size_t i = 0; i <= m_corners.size(); ++i) {
      const bool ends = i == m_corners.size() || m_corners[i] == -1;
      if (ends) {
        const std::size_t length = i - start;
        if (length > 0 && length < 3 && !m_assembly.addPolygon(std::span(m_corners).subspan(start, length), position))
          return false;
        start = i + 1;
        continue;
      }
      if (i < start + 2) continue;
      std::array<std::int64_t, 3> triangle = {m_corners[i - 2], m_corners[i - 1], m_corners[i]};
      if ((i - start) % 2 == 1) std::swap(triangle[0], triangle[1]);
      if (!m_assembly.advance(m_rows.position()) || !m_assembly.addPolygon(triangle, position)) return false;
    }
    return true;
  }

  const PlyHeader& m_header;
  MeshAssembly m_assembly;
  Rows m_rows;
  bool m_hasDecided = false;  // rowsRunOn() was asked
  Vec3 m_point = Vec3::Zero();
  std::vector<std::int64_t> m_corners;
};

}  // namespace

bool looksLikePly(std::string_view bytes) {
  TextScanner scanner(bytes.substr(0, 256));
  return scanner.wordOnAnyLine() == "ply";
}

Result<MeshFile> readPly(std::string_view bytes, const ReadOptions& options, Progress progress) {
  const Result<PlyHeader> header = readPlyHeader(bytes);
  if (!header) return header.error();
  if (header->encoding == PlyEncoding::Text) return BodyReader<PlyTextRows>(bytes, *header, options, progress).read();
  return BodyReader<PlyBinaryRows>(bytes, *header, options, progress).read();
}

}  // namespace handwheel
