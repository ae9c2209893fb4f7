// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectList.h"

#include "text/RepairText.h"

#include <algorithm>
#include <utility>

namespace handwheel {

DefectList::DefectList(MeshDocument& document, QObject* parent) : QObject(parent), m_document(document) {
  connect(&document, &MeshDocument::meshChanged, this, [this] { documentChanged(); });
  connect(&document, &MeshDocument::keptOpenChanged, this, [this] {
    sortLoops();
    emit changed();
  });
  connect(&document, &Document::fileChanged, this,
          [this, unit = document.displayUnit(), numbers = document.fileNumbers()]() mutable {
            const LengthUnit before = std::exchange(unit, m_document.displayUnit());
            const NumberType were = std::exchange(numbers, m_document.fileNumbers());
            const bool isRoundedAnew = were != numbers;
            if (isRoundedAnew && m_selfIntersections)
              m_intersectionsBeforeRounding = std::exchange(m_selfIntersections, std::nullopt);
            else if (isRoundedAnew && !m_intersectionsBeforeRounding)  // there is nothing to compare with
              m_findings.hopeless.erase(DefectKind::SelfIntersection);
            if (unit != before || isRoundedAnew) emit changed();
          });
  nameLoops();
  sortLoops();
}

void DefectList::documentChanged() {
  m_selfIntersections.reset();
  m_intersectionsBeforeRounding.reset();
  m_findings = {};
  nameLoops();
  sortLoops();
  emit changed();
}

void DefectList::nameLoops() {
  m_keys.clear();
  for (const BoundaryLoop& each : m_document.defects().loops) {
    m_keys.push_back(handwheel::keyOf(m_document.mesh(), each));
    if (m_numbers.try_emplace({each.isSheetBoundary, m_keys.back()}, m_named.peek(each.isSheetBoundary)).second)
      m_named.take(each.isSheetBoundary);
  }
}

void DefectList::sortLoops() {
  m_holes.clear();
  m_keptOpen.clear();
  m_debris.clear();
  for (int id = 0; id < loopCount(); ++id) {
    const bool open = loop(id).isSheetBoundary || m_document.isKeptOpen(loop(id));
    (open ? m_keptOpen : m_holes).push_back(id);
  }
  const auto& components = m_document.defects().components;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto isKept = [this](Face f) { return hasCornerAt(m_document.mesh(), f, m_keptPieces); };
    const std::vector<Face>& faces = components[i].faces;
    if (components[i].debris && std::none_of(faces.begin(), faces.end(), isKept)) m_debris.push_back(i);
  }
}

void DefectList::keepPieces(const std::set<PointKey>& corners) {
  if (corners.empty()) return;
  m_keptPieces.insert(corners.begin(), corners.end());
  sortLoops();
  emit changed();
}

std::size_t DefectList::sheetCount() const {
  return static_cast<std::size_t>(
      std::count_if(m_keptOpen.begin(), m_keptOpen.end(), [this](int id) { return loop(id).isSheetBoundary; }));
}

void DefectList::setSelfIntersections(std::uint64_t revision, FacePairs pairs) {
  if (revision != m_document.revision()) return;
  // Intersections that no cut separates are not separated in numbers of a file in which the same triangles intersect.
  if (m_intersectionsBeforeRounding && *m_intersectionsBeforeRounding != pairs)
    m_findings.hopeless.erase(DefectKind::SelfIntersection);
  m_intersectionsBeforeRounding.reset();
  m_selfIntersections = std::move(pairs);
  std::erase_if(m_findings.reasons.ofRow,
                [](const auto& of) { return of.first.first == DefectKind::SelfIntersection; });
  emit changed();
}

std::size_t DefectList::count(DefectKind kind) const {
  const Defects& defects = m_document.defects();
  switch (kind) {
    case DefectKind::Hole:
      return m_holes.size();
    case DefectKind::KeptOpen:
      return m_keptOpen.size();
    case DefectKind::NonManifoldEdge:
      return defects.nonManifoldEdges.size();
    case DefectKind::NonManifoldVertex:
      return defects.nonManifoldVertices.size();
    case DefectKind::OneSided:
      return defects.nonOrientableEdges.size();
    case DefectKind::InsideOut:
      return defects.insideOut.size();
    case DefectKind::Inconsistent:
      return defects.inconsistentFaces.size();
    case DefectKind::NearVertex:
      return defects.nearVertices.size();
    case DefectKind::Flipped:
      return m_document.reversedFaces().size();
    case DefectKind::Degenerate:
      return defects.degenerateFaces.size();
    case DefectKind::Duplicate:
      return defects.duplicateFaces.size();
    case DefectKind::SelfIntersection:
      return m_selfIntersections ? m_selfIntersections->size() : 0;
    case DefectKind::Debris:
      return m_debris.size();
  }
  return 0;
}

std::map<DefectKind, std::size_t> DefectList::counts() const {
  std::map<DefectKind, std::size_t> counts;
  for (int i = 0; i < kDefectKinds; ++i) {
    const auto kind = static_cast<DefectKind>(i);
    if (kind != DefectKind::SelfIntersection || m_selfIntersections) counts[kind] = count(kind);
  }
  return counts;
}

void DefectList::setBefore(std::map<DefectKind, std::size_t> counts, LoopCounts loops) {
  m_findings.before = std::move(counts);
  m_findings.loopOutcomes = loops;
  emit changed();
}

void DefectList::setFindings(RepairFindings findings) {
  m_findings = std::move(findings);
  emit changed();
}

void DefectList::setHopeless(DefectKind kind) {
  if (m_findings.hopeless.insert(kind).second) emit changed();
}

QString DefectList::reason(DefectKind kind, int row) const {
  const auto own = m_findings.reasons.ofRow.find({kind, row});
  if (own != m_findings.reasons.ofRow.end()) return own->second;
  const auto common = m_findings.reasons.ofKind.find(kind);
  return common == m_findings.reasons.ofKind.end() ? QString() : common->second;
}

void DefectList::setReason(DefectKind kind, int row, const QString& reason) {
  if (row >= 0)
    m_findings.reasons.ofRow[{kind, row}] = reason;
  else
    m_findings.reasons.ofKind[kind] = reason;
  emit reasonsChanged(kind);
}

std::optional<std::size_t> DefectList::countBefore(DefectKind kind) const {
  const auto found = m_findings.before.find(kind);
  const bool isSearching = kind == DefectKind::SelfIntersection && !m_selfIntersections;
  if (found == m_findings.before.end() || isSearching || found->second == count(kind)) return std::nullopt;
  return found->second;
}

MeshState DefectList::state() const {
  return m_document.defects().state(m_selfIntersections ? std::optional(m_selfIntersections->size()) : std::nullopt);
}

bool DefectList::isClean() const {
  const bool hasIntersections = count(DefectKind::SelfIntersection) > 0 && !isHopeless(DefectKind::SelfIntersection);
  return !hasIntersections && m_holes.empty() && count(DefectKind::NonManifoldEdge) == 0 &&
         count(DefectKind::NonManifoldVertex) == 0 && count(DefectKind::OneSided) == 0 &&
         count(DefectKind::InsideOut) == 0 && count(DefectKind::Inconsistent) == 0 &&
         count(DefectKind::NearVertex) == 0 && count(DefectKind::Degenerate) == 0 && count(DefectKind::Duplicate) == 0;
}

int DefectList::loopNumber(int id) const {
  return m_numbers.at({loop(id).isSheetBoundary, keyOf(id)});
}

QString DefectList::loopName(int id) const {
  return boundaryLoopName(loop(id).isSheetBoundary, loopNumber(id));
}

QString DefectList::loopLength(int id) const {
  return lengthText(loop(id).length, m_document.displayUnit());
}

QString DefectList::loopDetail(int id) const {
  return tr("%Ln edge(s), %1", nullptr, static_cast<int>(loop(id).borderEdges)).arg(loopLength(id));
}

QString DefectList::loopMeasures(int id) const {
  const BoundaryLoop& l = loop(id);
  const LengthUnit unit = m_document.displayUnit();
  QStringList parts{tr("Area %1.").arg(areaText(l.area, unit)),
                    tr("%1 from the best-fitting plane (RMS).").arg(lengthText(l.planarity * l.length, unit))};
  if (l.islands > 0)
    parts << tr("%Ln island(s) inside: Repair all joins them to the patch, Fill alone covers them.", nullptr,
                static_cast<int>(l.islands));
  return parts.join(QLatin1Char(' '));
}

QString DefectList::loopTitle(int id) const {
  return tr("%1 — %2").arg(loopName(id), loopDetail(id));
}

FillFailure DefectList::failure(int id) const {
  const auto found = m_failures.find(keyOf(id));
  return found == m_failures.end() ? FillFailure::None : found->second;
}

void DefectList::setFailure(int id, FillFailure failure) {
  if (this->failure(id) == failure) return;
  m_failures[keyOf(id)] = failure;
  emit changed();
}

void DefectList::setFailures(const std::map<Vertex, FillFailure>& failures) {
  for (const auto& [key, failure] : failures) m_failures[key] = failure;
  if (!failures.empty()) emit changed();
}

Vertex DefectList::keyOf(int id) const {
  return m_keys[static_cast<std::size_t>(id)];
}

int DefectList::loopWithKey(Vertex key) const {
  const auto found = std::find(m_keys.begin(), m_keys.end(), key);
  return found == m_keys.end() ? -1 : static_cast<int>(found - m_keys.begin());
}

}  // namespace handwheel
