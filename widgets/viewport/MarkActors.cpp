// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/MarkActors.h"

namespace handwheel {

namespace {

// Up to this number, selected faces get an outline, which is visible however small they are.
constexpr std::size_t kMostOutlined = 200;

QColor withAlpha(QColor c, float alpha) {
  c.setAlphaF(alpha);
  return c;
}

void show(DepthOffsetActor& actor, const PolyDataBuilder& triangles) {
  triangles.isEmpty() ? actor.hide() : actor.setData(triangles.build(PolyDataBuilder::Kind::Triangles));
}

}  // namespace

CasedStrokes::CasedStrokes(LayerProps& props, double lift, double width, double rim)
    // Strokes bulge towards the viewer by up to their width, where they recede; the core must stand before that.
    : m_rim(props, lift, width + 2 * rim), m_core(props, lift + width + 2 * rim + 0.5, width) {}

void CasedStrokes::set(std::vector<Stroke> strokes, const QColor& rim, const Vec3& origin) {
  m_core.set(strokes, origin);
  for (Stroke& s : strokes) s.colour = mixed(s.colour, rim, 0.8f);
  m_rim.set(strokes, origin);
}

void CasedStrokes::prepare(const LayerFrame& frame) {
  m_rim.prepare(frame);
  m_core.prepare(frame);
}

MarkActors::MarkActors(LayerProps& props)
    : m_colours(sceneColours(false)),
      m_faces(props, 1.0),
      m_selected(props, 1.2, 0.9),
      m_highlighted(props, 1.4, 0.45),
      m_hovered(props, 1.6),
      m_preview(props, 1.5),
      m_previewEdges(props, 2.0, 1.0),
      m_plainLoops(props, 3.0, 3.0, 1.0),
      m_strongLoops(props, 4.0, 5.0, 2.5),
      m_lines(props, 4.0, 3.0, 1.0),
      m_points(props, 6.0, 8.0, 1.5),
      m_section(props, 2.5, 2.5, 1.0),
      m_selectedEdges(props, 3.5, 3.0, 1.5) {
  for (DepthOffsetActor* actor : {&m_faces, &m_hovered, &m_preview}) setOverlayMaterial(actor->property());
  m_selected.setColour(m_colours.selected);
  m_highlighted.setColour(m_colours.accent);
}

void MarkActors::clear() {
  setLoops({});
  setFaceMarks({});
  setPointMarks({});
  setLineMarks({});
  setSection({});
  setPreview({}, {});
  setSelectedFaces({});
  setHighlightedFaces({});
}

void MarkActors::setLoops(std::vector<LoopMark> loops) {
  m_loops = std::move(loops);
  m_stale.set(Loops);
}

void MarkActors::setFaceMarks(std::vector<FaceMark> marks) {
  m_faceMarks = std::move(marks);
  m_stale.set(Faces);
}

void MarkActors::setPointMarks(std::vector<PointMark> marks) {
  m_pointMarks = std::move(marks);
  m_stale.set(Points);
}

void MarkActors::setLineMarks(std::vector<LineMark> marks) {
  m_lineMarks = std::move(marks);
  m_stale.set(Lines);
}

void MarkActors::setSection(std::vector<SectionMark> section) {
  m_sectionMarks = std::move(section);
  m_stale.set(Section);
}

void MarkActors::setPreview(std::vector<Vec3> points, std::vector<Triangle> triangles) {
  m_previewPoints = std::move(points);
  m_previewTriangles = std::move(triangles);
  m_stale.set(Preview);
}

void MarkActors::setHovered(int listLoop, int cursorLoop, Face face) {
  if (listLoop != m_listLoop || cursorLoop != m_cursorLoop) m_stale.set(Loops);
  if (face != m_hoveredFace) m_stale.set(HoveredFace);
  m_listLoop = listLoop;
  m_cursorLoop = cursorLoop;
  m_hoveredFace = face;
}

bool MarkActors::setSelectedFaces(const FaceSelection& faces) {
  if (!m_selected.set(faces)) return false;
  m_outlined.clear();
  if (faces.count() <= kMostOutlined) m_outlined = faces.faces();
  m_stale.set(SelectedEdges);
  return true;
}

void MarkActors::setColours(const SceneColours& colours) {
  if (colours == m_colours) return;
  m_colours = colours;
  m_selected.setColour(colours.selected);
  m_highlighted.setColour(colours.accent);
  m_stale.set();
}

void MarkActors::setMesh(const HalfEdgeMesh& mesh, const Vec3& origin) {
  if (m_origin != origin) m_stale.set();
  for (const Part part : {Faces, HoveredFace, SelectedEdges}) m_stale.set(part);
  for (FaceActors* faces : {&m_selected, &m_highlighted}) faces->setStale();
  m_mesh = mesh;
  m_origin = origin;
}

std::size_t MarkActors::buildPendingFaces() {
  const std::size_t taken = m_highlighted.takeOne(m_mesh, m_origin);
  return taken > 0 ? taken : m_selected.takeOne(m_mesh, m_origin);
}

void MarkActors::prepare(const LayerFrame& frame) {
  rebuildStale();
  for (DepthOffsetActor* actor : {&m_faces, &m_hovered, &m_preview}) actor->prepare(frame);
  for (FaceActors* faces : {&m_selected, &m_highlighted}) faces->prepare(frame);
  m_previewEdges.prepare(frame);
  for (CasedStrokes* strokes : {&m_plainLoops, &m_strongLoops, &m_lines, &m_points, &m_section, &m_selectedEdges})
    strokes->prepare(frame);
}

void MarkActors::rebuildStale() {
  if (m_stale[Loops]) rebuildLoops();
  if (m_stale[Faces]) rebuildFaces();
  if (m_stale[HoveredFace]) rebuildHoveredFace();
  if (m_stale[Points]) rebuildPoints();
  if (m_stale[Lines]) rebuildLines();
  if (m_stale[Section]) rebuildSection();
  if (m_stale[Preview]) rebuildPreview();
  if (m_stale[SelectedEdges]) rebuildSelectedEdges();
  m_stale.reset();
}

void MarkActors::rebuildLoops() {
  std::vector<Stroke> plain, strong;
  for (const LoopMark& loop : m_loops) {
    const bool isHovered = loop.id >= 0 && (loop.id == m_listLoop || loop.id == m_cursorLoop);
    (loop.emphasised || isHovered ? strong : plain).push_back({loop.points, true, loop.colour});
  }
  m_plainLoops.set(std::move(plain), m_colours.casing, m_origin);
  m_strongLoops.set(std::move(strong), QColor(Qt::white), m_origin);
}

// Adds the face's triangle with colours at its corners; nothing for a face that an edit has removed meanwhile.
void MarkActors::addFace(PolyDataBuilder& builder, Face face, const QColor& colour) const {
  if (face >= m_mesh.faceSlots() || !m_mesh.isLive(face)) return;
  const Triangle& t = m_mesh.triangle(face);
  const auto corner = [&](int k) { return builder.addPoint(m_mesh.position(t[k]), colour); };
  const std::int32_t a = corner(0), b = corner(1), c = corner(2);
  builder.addCell({a, b, c});
}

void MarkActors::rebuildFaces() {
  PolyDataBuilder triangles(m_origin);
  for (const FaceMark& mark : m_faceMarks) {
    for (const Face f : mark.faces) addFace(triangles, f, mark.colour);
  }
  show(m_faces, triangles);
}

void MarkActors::rebuildSelectedEdges() {
  std::vector<TrianglePoints> corners;
  for (const Face f : m_outlined)
    if (f < m_mesh.faceSlots() && m_mesh.isLive(f)) corners.push_back(m_mesh.points(f));
  std::vector<Stroke> strokes;
  for (const TrianglePoints& p : corners) strokes.push_back({p, true, m_colours.selected});
  m_selectedEdges.set(std::move(strokes), QColor(Qt::white), m_origin);
}

void MarkActors::rebuildHoveredFace() {
  PolyDataBuilder triangles(m_origin);
  addFace(triangles, m_hoveredFace, withAlpha(m_colours.accent, 0.45f));
  show(m_hovered, triangles);
}

void MarkActors::rebuildPoints() {
  std::vector<Stroke> dots;
  for (const PointMark& mark : m_pointMarks) {
    for (const Vec3& p : mark.points) dots.push_back({{&p, 1}, false, mark.colour});
  }
  m_points.set(std::move(dots), m_colours.casing, m_origin);
}

void MarkActors::rebuildSection() {
  std::vector<Stroke> strokes;
  for (const SectionMark& mark : m_sectionMarks) strokes.push_back({mark.points, mark.closed, m_colours.accent});
  m_section.set(std::move(strokes), m_colours.casing, m_origin);
}

void MarkActors::rebuildLines() {
  std::vector<std::array<Vec3, 2>> ends;
  std::vector<QColor> colours;
  for (const LineMark& mark : m_lineMarks) {
    for (const auto& [a, b] : mark.segments) {
      ends.push_back({a, b});
      colours.push_back(mark.colour);
    }
  }
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < ends.size(); ++i) strokes.push_back({ends[i], false, colours[i]});
  m_lines.set(std::move(strokes), m_colours.casing, m_origin);
}

void MarkActors::rebuildPreview() {
  PolyDataBuilder triangles(m_origin);
  for (const Vec3& p : m_previewPoints) triangles.addPoint(p, withAlpha(m_colours.accent, 0.6f));
  std::vector<std::array<Vec3, 3>> outlines;
  for (const auto& [a, b, c] : m_previewTriangles) {
    triangles.addCell({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)});
    outlines.push_back({m_previewPoints[a], m_previewPoints[b], m_previewPoints[c]});
  }
  show(m_preview, triangles);
  std::vector<Stroke> edges;
  for (const auto& outline : outlines) edges.push_back({outline, true, m_colours.accent.darker(140)});
  m_previewEdges.set(edges, m_origin);
}

}  // namespace handwheel
