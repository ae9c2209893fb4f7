// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/DimensionsView.h"

#include "document/workpiece/ThreadReport.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/TargetImport.h"
#include "machining/drawing/PartDrawing.h"
#include "viewport/Viewport.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTab.h"
#include "window/workpiece/TextOutlines.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPaper = 160.0;  // mm that the part would measure on a drawing: so large are the texts
constexpr int kPerArc = 24;       // pieces

// Converts a position on the sheet to the scene. The chuck is left, the tool on this side, so that up is against y.
Vec3 inScene(const ProfilePoint& at, double scale) {
  return {0.0, -at.y() / scale, at.x() / scale};
}

void addCurve(std::vector<PathLine>& lines, const ProfileSegment& curve, double scale) {
  PathLine line;
  const int pieces = curve.isArc() ? kPerArc : 1;
  for (int i = 0; i <= pieces; ++i) line.points.push_back(inScene(curve.at(static_cast<double>(i) / pieces), scale));
  lines.push_back(std::move(line));
}

// The outlines of its letters.
void addText(std::vector<PathLine>& lines, const Sheet::Text& text, double scale, bool isFromBehind) {
  const TextOutlines written = textOutlines(QString::fromStdString(text.text), text.height);
  const TextOutlines words = isFromBehind ? written.reversed() : written;
  const double start = text.align == Sheet::Align::Left    ? 0.0
                       : text.align == Sheet::Align::Right ? -words.width
                                                           : -0.5 * words.width;
  for (const std::vector<Vec2>& outline : words.lines) {
    PathLine line;
    for (const Vec2& p : outline) {
      const ProfilePoint flat(start + p.x(), p.y());
      line.points.push_back(inScene(text.at + (text.isUpwards ? ProfilePoint(-flat.y(), flat.x()) : flat), scale));
    }
    lines.push_back(std::move(line));
  }
}

PathLayer::Lines linesOf(const Sheet& sheet, double scale, bool isFromBehind) {
  auto lines = std::make_shared<std::vector<PathLine>>();
  for (const Sheet::Stroke& stroke : sheet.strokes) addCurve(*lines, stroke.curve, scale);
  for (const Sheet::Area& area : sheet.areas)
    for (const ProfileSegment& side : area.outline) addCurve(*lines, side, scale);
  for (const Sheet::Text& text : sheet.texts) addText(*lines, text, scale, isFromBehind);
  return lines;
}

// Runs on a worker thread.
PathLayer::Lines dimensionLines(const WorkpieceSnapshot& workpiece, bool isFromBehind) {
  const Result<TargetProfile> section = sectionOf(workpiece);
  if (!section) return nullptr;
  DrawingLayout layout;
  layout.scale = kPaper / std::max(section->length(), 2.0 * section->largestRadius());
  DrawingTitle title;
  title.tolerance = workpiece.chord;
  title.threads = threadsToDraw(workpiece);
  return linesOf(dimensionSheet(*section, title, layout), layout.scale, isFromBehind);
}

}  // namespace

DimensionsView::DimensionsView(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_toggle(tr("Dimensions in the &view"), this),
      m_layer(std::make_shared<PathLayer>()),
      m_measuring(JobRunner::Policy::Latest, parts.pool) {
  m_toggle.setObjectName(QStringLiteral("dimensionsInView"));
  m_toggle.setCheckable(true);
  setActionToolTip(m_toggle, tr("Show diameters, lengths, radii and chamfers of the part in the view"));
  parts.viewport.addLayer(m_layer);
  connect(&m_toggle, &QAction::toggled, this, &DimensionsView::refresh);
  connect(&parts.viewport, &Viewport::cameraChanged, this, [this] {
    if (m_isFromBehind != isBehindLathe(m_parts.viewport.camera())) refresh();
  });
}

DimensionsView::~DimensionsView() {
  m_parts.viewport.removeLayer(*m_layer);
}

void DimensionsView::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_measuring.cancelAll();
  m_document = document;
  m_toggle.setEnabled(document != nullptr);
  if (document) connect(&document->document, &Document::changed, this, &DimensionsView::refresh);
  refresh();
}

void DimensionsView::setVisible(bool isVisible) {
  if (std::exchange(m_isVisible, isVisible) != isVisible) refresh();
}

void DimensionsView::refresh() {
  m_measuring.cancelAll();
  if (!m_document || !m_isVisible || !m_toggle.isChecked()) {
    m_layer->setLines(nullptr);
    return;
  }
  m_isFromBehind = isBehindLathe(m_parts.viewport.camera());
  Job job;
  job.name = tr("Measuring");
  job.document = &m_document->document;
  job.work = [this, document = m_document, isFromBehind = m_isFromBehind,
              value =
                  static_cast<const WorkpieceDocument&>(m_document->document).workpiece()](Progress) -> Job::Finish {
    PathLayer::Lines lines = dimensionLines(value, isFromBehind);
    return [this, document, lines] {
      if (document != m_document || !m_toggle.isChecked()) return;
      m_layer->setLines(lines);
    };
  };
  m_measuring.start(std::move(job));
}

}  // namespace handwheel
