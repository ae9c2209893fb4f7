// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/FillHoleTool.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/boundary/BoundaryPick.h"
#include "mesh/boundary/HolePick.h"
#include "tools/OperationSettings.h"

#include <QtGlobal>
#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

constexpr ToolKey kFillHoleKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "fill the hole")},
    {"next", "N", QT_TRANSLATE_NOOP("Tool", "next hole"), "nextHole"},
    {"previous", "Shift+N", QT_TRANSLATE_NOOP("Tool", "previous hole"), "previousHole"},
    {"keep", "K", QT_TRANSLATE_NOOP("Tool", "keep open"), "keepOpen"},
    {"automatic", "", QT_TRANSLATE_NOOP("Tool", "choose the bridges again")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "deselect the hole")},
};
constexpr const char* kWeightIds[] = {"ears_length", "ears_angles", "ears_normal"};
constexpr double kLargestWeight = 5.0;  // upper limit of the sliders

const char* problemOf(FillFailure failure) {
  switch (failure) {
    case FillFailure::None:
      break;
    case FillFailure::Cancelled:
      return QT_TRANSLATE_NOOP("Property", "It was cancelled.");
    case FillFailure::SheetBoundary:
      return QT_TRANSLATE_NOOP("Property", "It is the outer boundary of an open sheet.");
    case FillFailure::WasSheetBoundary:
      return QT_TRANSLATE_NOOP("Property", "It was the outer boundary of an open sheet.");
    case FillFailure::KeptOpen:
      return QT_TRANSLATE_NOOP("Property", "It is kept open.");
    case FillFailure::TooLong:
      return QT_TRANSLATE_NOOP("Property", "It has more edges than allowed.");
    case FillFailure::NoPatch:
      return QT_TRANSLATE_NOOP("Property", "No valid patch fits its boundary.");
    case FillFailure::SelfIntersecting:
      return QT_TRANSLATE_NOOP("Property", "Every patch would intersect the part.");
    case FillFailure::Bulging:
      return QT_TRANSLATE_NOOP("Property", "Every patch would bulge out too far.");
    case FillFailure::NarrowTriangles:
      return QT_TRANSLATE_NOOP(
          "Property", "No patch fits, perhaps due to narrow triangles along its boundary. “Repair all” removes them.");
    case FillFailure::SheetIntersecting:
      return QT_TRANSLATE_NOOP("Property", "However thin, the body of the sheet would intersect the part.");
    case FillFailure::SheetTooThin:
      return QT_TRANSLATE_NOOP("Property", "The numbers of the file cannot show such a thickness.");
    case FillFailure::SheetKeptOpen:
      return QT_TRANSLATE_NOOP("Property", "A boundary of the sheet is kept open, and a thin body has none.");
    case FillFailure::TooMuchEffort:
      return QT_TRANSLATE_NOOP("Property", "It would take too long for a mesh of this size.");
  }
  return "";
}

}  // namespace

FillHoleTool::FillHoleTool(MeshDocument& document, FillServices services, std::optional<Vertex> first)
    : m_document(document), m_services(std::move(services)) {
  choose(first);
}

const BoundaryLoop* FillHoleTool::loop() const {
  return m_key ? loopWithKey(m_document.mesh(), m_document.defects().loops, *m_key) : nullptr;
}

void FillHoleTool::choose(std::optional<Vertex> key) {
  m_key = key;
  m_bridges.reset();
  const BoundaryLoop* chosen = loop();
  if (!chosen) {
    m_patch.reset();
    m_attempt = {};
    m_key.reset();
    m_state = State::Choosing;
    ++m_ticket;  // a pending answer is late and ignored
    return;
  }
  m_index = static_cast<std::size_t>(chosen - m_document.defects().loops.data());
  request();
}

void FillHoleTool::request() {
  m_state = State::Computing;
  m_isCommitWanted = false;
  m_patch.reset();
  m_attempt = {};
  m_services.request({++m_ticket, *loop(), m_bridges.own()});
}

void FillHoleTool::previewReady(std::uint64_t ticket, FillAttempt attempt) {
  if (ticket != m_ticket || m_state != State::Computing) return;
  m_attempt = std::move(attempt);
  m_state = m_attempt.failure == FillFailure::None ? State::Ready : State::Impossible;
  if (m_state == State::Ready)
    m_patch = std::make_shared<const TriangleSoup>(TriangleSoup{m_attempt.patch.points, m_attempt.patch.triangles});
  reportUpdated();
  if (m_isCommitWanted) commit();
}

std::optional<Vertex> FillHoleTool::holeFrom(std::size_t index, bool forward) const {
  const auto& loops = m_document.defects().loops;
  const std::size_t n = loops.size();
  for (std::size_t i = 0; i < n; ++i) {
    const BoundaryLoop& loop = loops[(index + (forward ? i : n - i)) % n];
    if (!loop.isSheetBoundary && !m_document.isKeptOpen(loop)) return keyOf(m_document.mesh(), loop);
  }
  return std::nullopt;
}

std::optional<Vertex> FillHoleTool::neighbour(bool forward) const {
  const std::size_t n = m_document.defects().loops.size();
  if (n == 0) return std::nullopt;
  if (!m_key) return holeFrom(forward ? 0 : n - 1, forward);
  return holeFrom(forward ? m_index + 1 : m_index + n - 1, forward);
}

std::optional<Vertex> FillHoleTool::holeAt(const PointerEvent& event) const {
  const auto faces = m_services.faces();
  if (!faces) return std::nullopt;
  const auto& loops = m_document.defects().loops;
  const auto loop = pickHole(m_document.mesh(), loops, *faces, event.pickRay());
  return loop ? std::optional(keyOf(m_document.mesh(), loops[*loop])) : std::nullopt;
}

ToolReply FillHoleTool::pointer(const PointerEvent& event) {
  switch (event.kind) {
    case PointerEvent::Kind::Hover:
      m_hovered = holeAt(event);
      return ToolReply::Used;
    case PointerEvent::Kind::Leave:
      m_hovered.reset();
      return ToolReply::Used;
    case PointerEvent::Kind::Press:
      return press(event);
    case PointerEvent::Kind::Drag:
      if (!m_bridges.isDrawing()) return ToolReply::Ignored;
      m_bridges.drag(pointAt(event));
      return ToolReply::Used;
    case PointerEvent::Kind::Release:
      if (!m_bridges.isDrawing()) return ToolReply::Ignored;
      if (loop() && m_bridges.release(loop()->halfEdges.size(), m_attempt.patch.bridges)) request();
      return ToolReply::Used;
    case PointerEvent::Kind::DoubleClick:
      break;
  }
  return ToolReply::Ignored;
}

ToolReply FillHoleTool::press(const PointerEvent& event) {
  if (event.device && event.button == PointerButton::Second) return commit();
  if (event.button != PointerButton::First) return ToolReply::Ignored;
  if (const auto point = m_state == State::Committing ? std::nullopt : pointAt(event)) {
    m_bridges.press(*point);
    return ToolReply::Used;
  }
  const auto key = holeAt(event);
  if (!key) return ToolReply::Ignored;  // the camera's
  if (key != m_key || m_state == State::Committing) choose(key);
  return ToolReply::Used;
}

std::optional<std::uint32_t> FillHoleTool::pointAt(const PointerEvent& event) const {
  const BoundaryLoop* chosen = loop();
  const auto faces = m_services.faces();
  if (!chosen || !faces) return std::nullopt;
  const auto found = pickBoundaryPoint(m_document.mesh(), {chosen, 1}, *faces, event.pickRay());
  if (!found) return std::nullopt;
  const auto at = std::find(chosen->halfEdges.begin(), chosen->halfEdges.end(), found->at);
  return static_cast<std::uint32_t>(at - chosen->halfEdges.begin());
}

std::vector<Vec3> FillHoleTool::line(const HoleBridge& bridge) const {
  const auto& edges = loop()->halfEdges;
  const HalfEdgeMesh& mesh = m_document.mesh();
  return {mesh.position(mesh.from(edges[bridge.a])), mesh.position(mesh.from(edges[bridge.b]))};
}

ToolReply FillHoleTool::perform(std::string_view action) {
  if (action == "commit") return commit();
  if (action == "keep") return keepOpen();
  if (action == "next" || action == "previous") {
    choose(neighbour(action == "next"));
    return ToolReply::Used;
  }
  if (action == "automatic" && m_key) {
    choose(m_key);
    return ToolReply::Used;
  }
  if (action != "revert") return ToolReply::Ignored;
  if (!m_key) return ToolReply::Finished;
  choose(std::nullopt);
  return ToolReply::Used;
}

// The document may change now or later; documentChanged() goes on to the next hole.
ToolReply FillHoleTool::commit() {
  m_isCommitWanted = m_state == State::Computing;  // a user who is quicker than the patch need not wait for it
  if (m_isCommitWanted) return ToolReply::Used;
  const BoundaryLoop* chosen = m_state == State::Ready ? loop() : nullptr;
  if (!chosen) return ToolReply::Ignored;
  m_state = State::Committing;
  const std::uint64_t ticket = m_ticket;
  const BoundaryLoop filled = *chosen;
  const FillAttempt attempt = m_attempt;
  if (!m_services.commit(filled, attempt)) {
    m_state = State::Ready;
    return ToolReply::Ignored;
  }
  if (ticket == m_ticket) m_patch.reset();
  return m_key ? ToolReply::Used : ToolReply::Finished;
}

ToolReply FillHoleTool::keepOpen() {
  const BoundaryLoop* chosen = loop();
  if (!chosen) return ToolReply::Ignored;
  const BoundaryLoop kept = *chosen;
  const bool keep = !m_document.isKeptOpen(kept);
  m_document.setKeptOpen(kept, keep);
  if (keep) choose(neighbour(true));
  return ToolReply::Used;
}

// Loops are in the order of their smallest vertices, so the next one takes the index of one that is gone.
void FillHoleTool::documentChanged() {
  m_hovered.reset();
  if (!m_key) return;
  choose(loop() ? m_key : holeFrom(m_index));
}

std::span<const ToolKey> FillHoleTool::keys() {
  return kFillHoleKeys;
}

std::vector<ToolAction> FillHoleTool::actions() const {
  const BoundaryLoop* chosen = loop();
  const bool kept = chosen && m_document.isKeptOpen(*chosen);
  const bool any = neighbour(true).has_value();
  return {
      {"", QT_TRANSLATE_NOOP("ToolInput", "Click"), QT_TRANSLATE_NOOP("Tool", "choose a hole")},
      actionOf(kFillHoleKeys, "commit", m_state == State::Ready || m_state == State::Computing),
      actionOf(kFillHoleKeys, "next", any),
      actionOf(kFillHoleKeys, "previous", any),
      actionOf(kFillHoleKeys, "keep", chosen != nullptr,
               kept ? QT_TRANSLATE_NOOP("Tool", "no longer keep open") : nullptr),
      {"", QT_TRANSLATE_NOOP("ToolInput", "Drag"), QT_TRANSLATE_NOOP("Tool", "bridge the hole from vertex to vertex"),
       chosen != nullptr},
      actionOf(kFillHoleKeys, "automatic", !m_bridges.own().empty()),
      actionOf(kFillHoleKeys, "revert", true, chosen ? nullptr : QT_TRANSLATE_NOOP("Tool", "done")),
  };
}

ToolPreview FillHoleTool::preview() const {
  ToolPreview preview;
  if (m_patch && m_services.showsPatch()) {
    DisplayPart part;
    part.name = "patch";
    part.soup = m_patch;
    preview.parts.push_back(std::move(part));
  }
  const auto& loops = m_document.defects().loops;
  for (const auto& key : {m_key, m_hovered != m_key ? m_hovered : std::nullopt}) {
    const BoundaryLoop* line = key ? loopWithKey(m_document.mesh(), loops, *key) : nullptr;
    if (line) preview.lines.push_back(outlineOf(m_document.mesh(), *line));
  }
  if (!loop()) return preview;
  for (const HoleBridge& bridge : m_attempt.patch.bridges) preview.lines.push_back(line(bridge));
  if (const auto drawn = m_bridges.drawn()) preview.lines.push_back(line(*drawn));
  return preview;
}

std::vector<Property> FillHoleTool::settings() const {
  const OperationValues& values = *m_services.values;
  const FillMethod method = fillOptionsOf(values).method;
  std::vector<Property> all = {settingOf(values, "fill")};
  if (method == FillMethod::Fair || method == FillMethod::Crease) all.push_back(settingOf(values, "continuity"));
  for (const char* id : kWeightIds) {
    if (method != FillMethod::Ear) break;
    all.push_back(settingOf(values, id));
    all.back().largest = kLargestWeight;
    all.back().continuous = true;
  }
  Property triangles;
  triangles.id = "triangles";
  triangles.label = QT_TRANSLATE_NOOP("Property", "New triangles");
  triangles.value = static_cast<double>(m_patch ? m_patch->triangles.size() : 0);
  triangles.editable = false;
  if (m_state == State::Impossible) triangles.problem = problemOf(m_attempt.failure);
  all.push_back(std::move(triangles));
  return all;
}

void FillHoleTool::setSetting(std::string_view id, const PropertyValue& value) {
  const auto* weight = std::find(std::begin(kWeightIds), std::end(kWeightIds), id);
  const auto* number = std::get_if<double>(&value);
  const bool isWeight = weight != std::end(kWeightIds);
  if (!isWeight && id != "fill" && id != "continuity") return;
  const bool isTaken =
      takeSetting(*m_services.values, id, isWeight && number ? std::min(*number, kLargestWeight) : value);
  if (isTaken && loop()) request();
}

}  // namespace handwheel
