// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/stl/StlTextReader.h"

#include "document/formats/MeshAssembly.h"
#include "document/formats/MeshTextValues.h"

namespace handwheel {

namespace {

class TextStlParser {
 public:
  TextStlParser(std::string_view bytes, const ReadOptions& options, Progress progress)
      : m_assembly(options, progress, bytes.size()), m_scanner(bytes) {}

  Result<MeshFile> read() {
    while (m_assembly.advance(m_scanner.position()) && m_scanner.findWord() && readStatement()) {
    }
    if (m_insideSolid) m_assembly.mend(unexpectedWord("endsolid", "", m_scanner.inputPosition()));
    return m_assembly.finish(NumberType::Float32);
  }

 private:
  bool nextIs(std::string_view keyword) { return equalsIgnoringCase(m_scanner.peek(), keyword); }

  bool readStatement() {
    const InputPosition position = m_scanner.inputPosition();
    const std::string_view word = m_scanner.word();
    if (equalsIgnoringCase(word, "facet")) return readFacet(position);
    if (equalsIgnoringCase(word, "solid")) {
      if (m_insideSolid) m_assembly.mend(unexpectedWord("endsolid", word, position));
      m_insideSolid = true;
    } else if (equalsIgnoringCase(word, "endsolid")) {
      m_insideSolid = false;
    } else if (equalsIgnoringCase(word, "color")) {
      m_assembly.lose(LostAttribute::Colour);
    } else if (!isGarbledEnd(word)) {
      if (!m_assembly.tolerate(unexpectedWord("facet", word, position))) return false;
    }
    skipName();
    return true;
  }

  // Recognises "end solid", "endsoli" and the like; no facet is lost with such a line.
  bool isGarbledEnd(std::string_view word) {
    if (!equalsIgnoringCase(word.substr(0, 3), "end")) return false;
    m_assembly.mend(unexpectedWord("endsolid", word, m_scanner.inputPosition()));
    m_insideSolid = false;
    return true;
  }

  // Skips a name, which ends with its line, or at a facet on the same line.
  void skipName() {
    for (;;) {
      const TextScanner start = m_scanner;
      const std::string_view word = m_scanner.word();
      if (word.empty()) break;
      if (!equalsIgnoringCase(word, "facet") || !nextIs("normal")) continue;
      m_scanner = start;
      return;
    }
    m_scanner.nextLine();
  }

  bool readFacet(InputPosition position) {
    m_corners.clear();
    // The normal is not needed, and often it is not a number either.
    while (!m_scanner.peek().empty() && !nextIs("outer")) m_scanner.word();
    Error error;
    const bool cornersRead =
        expect("outer", error) && expect("loop", error) && readCorners(error) && expect("endloop", error);
    const bool whole = cornersRead && expect("endfacet", error);
    if (!whole && !m_assembly.tolerate(std::move(error))) return false;
    if (cornersRead && !addFacet(position)) return false;
    return whole || resume();
  }

  bool expect(std::string_view keyword, Error& error) {
    m_scanner.findWord();
    if (nextIs(keyword)) return !m_scanner.word().empty();
    error = unexpectedWord(keyword, m_scanner.peek(), m_scanner.inputPosition());
    return false;
  }

  bool readCorners(Error& error) {
    while (m_scanner.findWord() && nextIs("vertex")) {
      m_scanner.word();
      Vec3 point;
      if (!m_assembly.advance(m_scanner.position())) return false;
      if (!readPoint(m_scanner, NumberType::Float32, point, error)) return false;
      m_corners.push_back(point);
    }
    return true;
  }

  bool addFacet(InputPosition position) {
    m_indices.clear();
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      m_indices.push_back(static_cast<std::int64_t>(m_assembly.pointCount() + i));
    if (m_corners.size() >= 3)
      for (const Vec3& corner : m_corners)
        if (!m_assembly.addPoint(corner)) return false;
    if (m_corners.size() > 3)
      m_assembly.mend({ErrorCode::CountMismatch, {"vertices", "3", std::to_string(m_corners.size())}, position, {}});
    return m_assembly.addPolygon(m_indices, position);
  }

  // Skips an invalid facet, to the next line that begins a statement.
  bool resume() {
    do {
      if (!m_assembly.advance(m_scanner.position())) return false;
      if (nextIs("facet") || nextIs("solid") || nextIs("endsolid")) break;
    } while (m_scanner.nextLine());
    return true;
  }

  MeshAssembly m_assembly;
  TextScanner m_scanner;
  bool m_insideSolid = false;
  std::vector<Vec3> m_corners;
  std::vector<std::int64_t> m_indices;
};

}  // namespace

Result<MeshFile> readTextStl(std::string_view bytes, const ReadOptions& options, Progress progress) {
  return TextStlParser(bytes, options, progress).read();
}

}  // namespace handwheel
