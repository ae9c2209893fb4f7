// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/DxfReader.h"

#include "machining/target/TargetErrors.h"
#include "machining/target/files/DxfEntities.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::string_view kBinaryHead = "AutoCAD Binary DXF";
constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr std::size_t kMostKinds = 100;  // limit of the kinds of entities that are not read
constexpr std::size_t kBetweenPolls = 4096;

// Returns the millimetres for a value of $INSUNITS; 0 if it is unknown.
double millimetresOf(int unit) {
  switch (unit) {
    case 1:
      return 25.4;
    case 2:
      return 304.8;
    case 4:
      return 1.0;
    case 5:
      return 10.0;
    case 6:
      return 1000.0;
    case 8:
      return 25.4e-6;
    case 9:
      return 0.0254;
    case 10:
      return 914.4;
    case 13:
      return 1e-3;
    case 14:
      return 100.0;
    default:
      return 0.0;
  }
}

// Collects the entities of the file and turns them into curves.
class DxfCurves {
 public:
  Status add(const DxfEntity& entity) {
    if (!entity.isShown) return Done{};
    if (!entity.isRead()) {
      if (m_drawing.others.size() < kMostKinds) ++m_drawing.others[entity.type.substr(0, 40)];
      return Done{};
    }
    const Result<std::vector<ProfileSegment>> curves = curvesOf(entity, Drawing::kCurveTolerance / m_scale);
    if (!curves) return curves.error();
    for (const ProfileSegment& s : *curves)
      if (!takeAxis(entity, s)) m_drawing.curves.push_back({m_scale * s.from, m_scale * s.to, s.bulge});
    if (m_drawing.curves.size() <= TargetProfile::kMostSegments) return Done{};
    return Error{ErrorCode::FileTooLarge, {"segments", "", std::to_string(TargetProfile::kMostSegments)}, {}, {}};
  }
  void setUnit(int unit) {
    const double known = millimetresOf(unit);
    m_drawing.hasUnit = known > 0.0;
    m_scale = known > 0.0 ? known : 1.0;
  }
  Result<Drawing> drawing() {
    if (m_drawing.curves.empty()) return Error{TargetError::NoProfile, {}, {}, {}};
    return std::move(m_drawing);
  }

 private:
  // Takes a line that marks the axis. Returns true if it is one, and horizontal.
  bool takeAxis(const DxfEntity& entity, const ProfileSegment& s) {
    if (!entity.isAxis()) return false;
    if (std::abs(s.to.y() - s.from.y()) <= 1e-6 * (s.to - s.from).norm()) m_drawing.axis = m_scale * s.from.y();
    return true;
  }

  Drawing m_drawing;
  double m_scale = 1.0;
};

// The state of reading: the section, variable and entity that the next group belongs to.
class DxfState {
 public:
  Status take(const DxfPair& pair) {
    if (pair.code == 0) {
      if (const Status begun = begin(pair); !begun) return begun;
    } else if (pair.code == 2 && m_isSectionNamed) {
      m_section = pair.value;
      m_isSectionNamed = false;
    } else if (m_section == "HEADER") {
      if (pair.code == 9) m_variable = pair.value;
      if (pair.code == 70 && m_variable == "$INSUNITS") m_curves.setUnit(pair.whole());
    } else if (m_section == "ENTITIES" && !m_entity.type.empty()) {
      return m_entity.take(pair);
    }
    return Done{};
  }
  Result<Drawing> finish() {
    if (const Status ended = end(); !ended) return ended.error();
    return m_curves.drawing();
  }

 private:
  Status begin(const DxfPair& pair) {
    const bool isInside = m_section == "ENTITIES" && m_entity.type == "POLYLINE";
    const bool isVertex = pair.value == "VERTEX" && (isInside || m_isInPolyline);
    if (isVertex) {
      if (isInside) {
        m_polyline = std::move(m_entity);
        m_isInPolyline = true;
      }
      keepVertex();
      m_entity = DxfEntity();
      m_entity.type = "VERTEX";
      m_entity.vertices.emplace_back();
      return Done{};
    }
    if (const Status ended = end(); !ended) return ended;
    m_isSectionNamed = pair.value == "SECTION";
    if (pair.value == "ENDSEC" || pair.value == "SECTION") m_section = {};
    m_entity = DxfEntity();
    const bool isEntity = m_section == "ENTITIES" && pair.value != "SEQEND";
    if (isEntity) m_entity.type = pair.value.substr(0, 100);
    m_entity.line = pair.line;
    return Done{};
  }
  void keepVertex() {
    if (m_entity.type == "VERTEX") m_polyline.vertices.push_back(m_entity.vertices.front());
  }
  Status end() {
    if (m_isInPolyline) {
      keepVertex();
      m_entity = std::move(m_polyline);
      m_polyline = DxfEntity();
      m_isInPolyline = false;
    }
    return m_entity.type.empty() ? Status(Done{}) : m_curves.add(m_entity);
  }

  std::string_view m_section, m_variable;
  bool m_isSectionNamed = false, m_isInPolyline = false;
  DxfEntity m_entity, m_polyline;
  DxfCurves m_curves;
};

}  // namespace

bool looksLikeDxf(std::string_view head) {
  if (head.starts_with(kBinaryHead)) return true;
  DxfPairs pairs(head.substr(0, 4096));
  for (DxfPair pair; true;) {
    const Result<bool> next = pairs.next(pair);
    if (!next || !*next) return false;
    if (pair.code == 999) continue;  // a comment
    return pair.is(0, "SECTION");
  }
}

Result<Drawing> readDxf(std::string_view bytes, Progress progress) {
  if (bytes.starts_with(kBinaryHead)) return Error{TargetError::BinaryDrawing, {}, {}, {}};
  if (bytes.size() > kMostBytes)
    return Error{ErrorCode::FileTooLarge, {"bytes", std::to_string(bytes.size()), std::to_string(kMostBytes)}, {}, {}};
  DxfPairs pairs(bytes);
  DxfState state;
  DxfPair pair;
  for (std::size_t i = 0; true; ++i) {
    if (i % kBetweenPolls == 0) {
      if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
      progress.set(1.0 -
                   static_cast<double>(pairs.left()) / static_cast<double>(std::max<std::size_t>(bytes.size(), 1)));
    }
    const Result<bool> next = pairs.next(pair);
    if (!next) return next.error();
    if (!*next || pair.is(0, "EOF")) break;
    if (const Status taken = state.take(pair); !taken) return taken.error();
  }
  return state.finish();
}

}  // namespace handwheel
