// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/ObjReader.h"

#include "document/formats/MeshAssembly.h"
#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr TextScanner::Syntax kSyntax{'#', '\\'};

struct Statement {
  std::string_view keyword;
  LostAttribute lost;
};

// The statements of Wavefront's specification (version 3.0, appendix B1) that describe no polygon.
constexpr Statement kLostStatements[] = {
    {"vn", LostAttribute::Normals},       {"vt", LostAttribute::TextureCoordinates},
    {"vp", LostAttribute::Curves},        {"g", LostAttribute::Groups},
    {"o", LostAttribute::Groups},         {"s", LostAttribute::Groups},
    {"mg", LostAttribute::Groups},        {"usemtl", LostAttribute::Materials},
    {"mtllib", LostAttribute::Materials}, {"usemap", LostAttribute::Materials},
    {"maplib", LostAttribute::Materials}, {"l", LostAttribute::Lines},
    {"p", LostAttribute::Points},         {"cstype", LostAttribute::Curves},
    {"deg", LostAttribute::Curves},       {"bmat", LostAttribute::Curves},
    {"step", LostAttribute::Curves},      {"curv", LostAttribute::Curves},
    {"curv2", LostAttribute::Curves},     {"surf", LostAttribute::Curves},
    {"parm", LostAttribute::Curves},      {"trim", LostAttribute::Curves},
    {"hole", LostAttribute::Curves},      {"scrv", LostAttribute::Curves},
    {"sp", LostAttribute::Curves},        {"end", LostAttribute::Curves},
    {"con", LostAttribute::Curves},       {"bzp", LostAttribute::Curves},
    {"bsp", LostAttribute::Curves},       {"cdc", LostAttribute::Curves},
    {"cdp", LostAttribute::Curves},       {"res", LostAttribute::Curves},
    {"bevel", LostAttribute::Other},      {"c_interp", LostAttribute::Other},
    {"d_interp", LostAttribute::Other},   {"lod", LostAttribute::Other},
    {"shadow_obj", LostAttribute::Other}, {"trace_obj", LostAttribute::Other},
    {"ctech", LostAttribute::Other},      {"stech", LostAttribute::Other},
    {"call", LostAttribute::Other},       {"csh", LostAttribute::Other},
};

const Statement* findLostStatement(std::string_view keyword) {
  const auto* found = std::find_if(std::begin(kLostStatements), std::end(kLostStatements),
                                   [&](const Statement& s) { return s.keyword == keyword; });
  return found == std::end(kLostStatements) ? nullptr : found;
}

bool isFace(std::string_view keyword) {
  return keyword == "f" || keyword == "fo";
}  // fo: as written before 1990

// Returns true for an argument of "s" that means no smoothing group.
bool isNoGroup(std::string_view word) {
  return word == "off" || word == "0";
}

class ObjParser {
 public:
  ObjParser(std::string_view bytes, const ReadOptions& options, Progress progress)
      : m_assembly(options, progress, bytes.size(), 1), m_scanner(bytes, kSyntax) {}

  Result<MeshFile> read() {
    while (m_assembly.advance(m_scanner.position()) && m_scanner.findWord() && readStatement() &&
           m_scanner.nextLine()) {
    }
    m_assembly.allPointsAdded();
    return m_assembly.finish(NumberType::Float64);
  }

 private:
  bool readStatement() {
    const InputPosition position = m_scanner.inputPosition();
    const std::string_view keyword = m_scanner.word();
    if (keyword == "v") return readVertex();
    if (isFace(keyword)) return readFace(position);
    if (const Statement* statement = findLostStatement(keyword)) {
      if (!(keyword == "s" && isNoGroup(m_scanner.word()))) m_assembly.lose(statement->lost, keyword);
    } else {
      m_assembly.mend(unexpectedWord("a statement of the format", keyword, position));
    }
    return true;
  }

  bool readVertex() {
    Vec3 point;
    Error error;
    if (!readPoint(m_scanner, NumberType::Float64, point, error))
      return m_assembly.addUnreadablePoint(std::move(error));
    // After the position: a weight, or a colour of three or four components.
    const std::string_view fourth = m_scanner.word();
    if (!fourth.empty()) {
      double weight = 1.0;
      ErrorCode why;
      if (!m_scanner.word().empty())
        m_assembly.lose(LostAttribute::Colour);
      else if (!parseNumber(fourth, weight, why) || weight != 1.0)
        m_assembly.lose(LostAttribute::Other, "weights");
    }
    return m_assembly.addPoint(point);
  }

  bool readFace(InputPosition position) {
    m_corners.clear();
    for (std::string_view word = m_scanner.word(); !word.empty(); word = m_scanner.word()) {
      if (!m_assembly.step()) return false;
      const auto index = parseInteger(word.substr(0, word.find('/')));
      const bool good = index && word.find_first_not_of("0123456789+-/") == std::string_view::npos;
      if (!good) return m_assembly.tolerate(unexpectedWord("a vertex number", word, m_scanner.inputPosition()));
      const auto known = static_cast<std::int64_t>(m_assembly.pointCount());
      if (*index == 0 || *index < -known)
        return m_assembly.tolerate({MeshFileError::IndexOutOfRange,
                                    {std::to_string(*index), std::to_string(known)},
                                    m_scanner.inputPosition(),
                                    {}});
      m_corners.push_back(*index > 0 ? *index - 1 : known + *index);
    }
    return m_assembly.addPolygon(m_corners, position);
  }

  MeshAssembly m_assembly;
  TextScanner m_scanner;
  std::vector<std::int64_t> m_corners;
};

}  // namespace

Result<MeshFile> readObj(std::string_view bytes, const ReadOptions& options, Progress progress) {
  return ObjParser(bytes, options, progress).read();
}

bool looksLikeObj(std::string_view bytes) {
  constexpr std::size_t kProbe = 64 * 1024;
  constexpr std::size_t kTextProof = 1024;  // binary data has a NUL within
  if (bytes.substr(0, kTextProof).find('\0') != std::string_view::npos) return false;
  TextScanner scanner(bytes.substr(0, kProbe), kSyntax);
  const std::string_view keyword = scanner.wordOnAnyLine();
  return !scanner.peek().empty() && (keyword == "v" || isFace(keyword) || findLostStatement(keyword));
}

}  // namespace handwheel
