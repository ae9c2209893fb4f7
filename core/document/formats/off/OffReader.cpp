// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/off/OffReader.h"

#include "document/formats/MeshAssembly.h"
#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"
#include "document/formats/off/OffBinaryReader.h"
#include "document/formats/off/OffHeader.h"

namespace handwheel {

namespace {

class TextReader {
 public:
  // The scanner must be after the keyword.
  TextReader(std::string_view bytes, TextScanner scanner, OffKeyword keyword, const ReadOptions& options,
             Progress progress)
      : m_assembly(options, progress, bytes.size()), m_scanner(scanner), m_keyword(keyword) {}

  Result<MeshFile> read() {
    if (readCounts() && readVertices() && readFaces() && m_scanner.findWord())
      m_assembly.noteExcess(m_scanner.position(), m_scanner.inputPosition());
    return m_assembly.finish(NumberType::Float64);
  }

 private:
  bool readCounts() {
    if (!readCount(m_vertices, "the number of vertices") || !readCount(m_faces, "the number of faces")) return false;
    m_scanner.nextLine();  // the number of edges, which means nothing and may be missing
    return true;
  }

  bool readCount(std::int64_t& count, std::string_view what) {
    const std::string_view word = m_scanner.wordOnAnyLine();
    const auto value = parseInteger(word);
    if (value && *value >= 0) count = *value;
    if (value && *value >= 0) return true;
    return m_assembly.fail(unexpectedWord(what, word, m_scanner.inputPosition()));
  }

  bool readVertices() {
    for (; m_read < m_vertices; ++m_read) {
      if (!m_assembly.advance(m_scanner.position())) return false;
      if (!m_scanner.findWord()) return truncated("vertices", m_vertices);
      if (!readVertex()) return false;
    }
    m_assembly.allPointsAdded();
    return true;
  }

  bool readVertex() {
    const TextScanner start = m_scanner;
    Vec3 point;
    Error error;
    bool good = readPoint(m_scanner, NumberType::Float64, point, error);
    const bool moreWords = !m_scanner.peek().empty();
    const bool shortLine = !good && error.code == MeshFileError::TokenUnexpected;
    if ((moreWords || shortLine) && verticesRunOn(start)) {
      m_scanner = start;
      good = readPoint(m_scanner, NumberType::Float64, point, error, Words::OfAnyLine);
    } else {
      if (good && moreWords) loseVertexAttributes();
      m_scanner.nextLine();
    }
    return good ? m_assembly.addPoint(point) : m_assembly.addUnreadablePoint(std::move(error));
  }

  // Returns true if vertices are not one per line. A vertex normally has its own line, and any further numbers on it
  // are attributes; unless the file has too few lines for that, and three numbers per vertex lead to the first face.
  // Decided once, on the first call.
  bool verticesRunOn(const TextScanner& here) {
    if (!m_verticesRunOn)
      m_verticesRunOn = m_keyword.hasAttributes() ? false : linesAreTooFew(here) && facesFollowNumbers(here);
    return *m_verticesRunOn;
  }

  bool linesAreTooFew(TextScanner ahead) {
    for (const std::int64_t needed : {m_vertices - m_read, m_faces}) {  // a header may name more than a sum can hold
      for (std::int64_t i = 0; i < needed; ++i) {
        if (!m_assembly.step() || !ahead.findWord()) return true;
        ahead.nextLine();
      }
    }
    return false;
  }

  bool facesFollowNumbers(TextScanner ahead) {
    for (std::int64_t vertex = m_read; vertex < m_vertices; ++vertex)
      for (int axis = 0; axis < 3; ++axis)
        if (!m_assembly.step() || ahead.wordOnAnyLine().empty()) return false;
    if (!ahead.peek().empty() || !ahead.findWord()) return false;
    const std::int64_t corners = parseInteger(ahead.word()).value_or(0);
    for (std::int64_t i = 0; i < corners; ++i) {
      const std::int64_t index = parseInteger(ahead.word()).value_or(-1);
      if (index < 0 || index >= m_vertices) return false;
    }
    return corners > 0;
  }

  void loseVertexAttributes() {
    if (m_keyword.normal) m_assembly.lose(LostAttribute::Normals);
    if (m_keyword.texture) m_assembly.lose(LostAttribute::TextureCoordinates);
    // Without an announcement they are colours, too: several programs write them so.
    if (m_keyword.colour || !m_keyword.hasAttributes()) m_assembly.lose(LostAttribute::Colour);
  }

  bool readFaces() {
    for (m_read = 0; m_read < m_faces; ++m_read) {
      if (!m_assembly.advance(m_scanner.position())) return false;
      if (!m_scanner.findWord()) return truncated("faces", m_faces);
      if (!readFace()) return false;
      m_scanner.nextLine();
    }
    return true;
  }

  bool readFace() {
    const InputPosition position = m_scanner.inputPosition();
    std::int64_t count = 0;
    Error error;
    if (!readIndex(count, error)) return m_assembly.tolerate(std::move(error));
    m_corners.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      std::int64_t corner = 0;
      if (!m_assembly.step()) return false;
      if (!readIndex(corner, error)) return m_assembly.tolerate(std::move(error));
      m_corners.push_back(corner);
    }
    if (!m_scanner.peek().empty()) m_assembly.lose(LostAttribute::Colour);
    return storeFace(position);
  }

  bool readIndex(std::int64_t& index, Error& error) {
    const std::string_view word = m_scanner.word();
    const auto value = parseInteger(word);
    if (value) index = *value;
    if (value) return true;
    error = unexpectedWord("a whole number", word, m_scanner.inputPosition());
    return false;
  }

  bool storeFace(InputPosition position) {
    if (m_corners.size() == 1) m_assembly.lose(LostAttribute::Points);
    if (m_corners.size() == 2) m_assembly.lose(LostAttribute::Lines);
    if (m_corners.size() == 1 || m_corners.size() == 2) return true;
    return m_assembly.addPolygon(m_corners, position);
  }

  bool truncated(const char* what, std::int64_t announced) {
    m_assembly.tolerate({ErrorCode::DataTruncated,
                         {what, std::to_string(announced), std::to_string(m_read)},
                         m_scanner.inputPosition(),
                         {}});
    return false;
  }

  MeshAssembly m_assembly;
  TextScanner m_scanner;
  OffKeyword m_keyword;
  std::int64_t m_vertices = 0;
  std::int64_t m_faces = 0;
  std::int64_t m_read = 0;  // number of vertices, then of faces
  std::optional<bool> m_verticesRunOn;
  std::vector<std::int64_t> m_corners;
};

}  // namespace

Result<MeshFile> readOff(std::string_view bytes, const ReadOptions& options, Progress progress) {
  TextScanner scanner(bytes, {'#', -1});
  const TextScanner start = scanner;
  const std::string_view first = scanner.wordOnAnyLine();
  const auto keyword = parseOffKeyword(first);
  if (!keyword) {
    if (!parseInteger(first)) return Error{ErrorCode::HeaderMalformed, {"OFF"}, scanner.inputPosition(), {}};
    return TextReader(bytes, start, {}, options, progress).read();
  }
  if (keyword->otherDimension)
    return Error{
        MeshFileError::TypeUnknown, {std::string(first.substr(0, keyword->length))}, scanner.inputPosition(), {}};
  scanner.stepBack(first.size() - keyword->length);
  if (scanner.peek() != "BINARY") return TextReader(bytes, scanner, *keyword, options, progress).read();
  return readBinaryOff(bytes, scanner.position(), *keyword, options, progress);
}

}  // namespace handwheel
