// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/ViewCube.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <utility>

namespace handwheel {

namespace {

constexpr int kSize = 112;      // logical pixels
constexpr double kHalf = 32.0;  // half of the cube's edge; its corners reach √3 times as far
constexpr double kCubeDragThreshold = 4.0;
constexpr double kTextHeight = 0.42;  // height of the capitals, in halves of the cube's edge
constexpr double kTextWidth = 1.2;    // at most

QPolygonF toPolygon(const std::array<Vec2, 4>& outline) {
  QPolygonF polygon;
  for (const Vec2& p : outline) polygon << QPointF(p.x(), p.y());
  return polygon;
}

// Returns the name of a side about (0, 0), y down, in halves of the cube's edge.
QPainterPath textPath(const QString& text, QFont font) {
  font.setPixelSize(24);
  font.setBold(true);
  const QFontMetricsF metrics(font);
  QPainterPath path;
  path.addText(0, 0, font, text);
  const QRectF box = path.boundingRect();
  if (box.isEmpty()) return path;
  const double scale = std::min(kTextHeight / metrics.capHeight(), kTextWidth / box.width());
  QTransform transform;
  transform.scale(scale, scale);
  transform.translate(-box.center().x(), metrics.capHeight() / 2);
  return transform.map(path);
}

}  // namespace

ViewCube::ViewCube(QWidget* parent) : QWidget(parent), m_colours(sceneColours(false)) {
  setObjectName(QStringLiteral("viewCube"));
  setAccessibleName(tr("View cube"));
  setMouseTracking(true);
  setFocusPolicy(Qt::TabFocus);
  setAttribute(Qt::WA_NoSystemBackground);
  setFixedSize(sizeHint());
}

QSize ViewCube::sizeHint() const {
  return {kSize, kSize};
}

QString ViewCube::nameOf(const CubeRegion& region) {
  QStringList names;
  if (region.y() != 0) names += region.y() < 0 ? tr("Front") : tr("Back");
  if (region.x() != 0) names += region.x() < 0 ? tr("Left") : tr("Right");
  if (region.z() != 0) names += region.z() < 0 ? tr("Bottom") : tr("Top");
  return names.join(QStringLiteral(" · "));
}

void ViewCube::setOrientation(const Eigen::Quaterniond& orientation) {
  if (orientation.coeffs() == m_orientation.coeffs()) return;
  m_orientation = orientation;
  describe();
}

void ViewCube::setPatient(bool isPatient) {
  if (std::exchange(m_isPatient, isPatient) == isPatient) return;
  describe();
}

// The orientation is the accessible description.
void ViewCube::describe() {
  const QString facing = shownName(regionFacing(m_orientation));
  if (facing != accessibleDescription()) setAccessibleDescription(facing);
  update();
}

QString ViewCube::shownName(const CubeRegion& region) const {
  return m_isPatient ? nameOnPatient(region) : nameOf(region);
}

QString ViewCube::nameOnPatient(const CubeRegion& region) {
  QStringList names;
  if (region.y() != 0) names += region.y() < 0 ? tr("Front of the patient (A)") : tr("Back of the patient (P)");
  if (region.x() != 0) names += region.x() < 0 ? tr("Right of the patient (R)") : tr("Left of the patient (L)");
  if (region.z() != 0) names += region.z() < 0 ? tr("Feet of the patient (F)") : tr("Head of the patient (H)");
  return names.join(QStringLiteral(" · "));
}

QString ViewCube::textOn(const CubeRegion& side) const {
  if (!m_isPatient) return nameOf(side);
  constexpr std::array<char, 3> kBelow{'R', 'A', 'F'}, kAbove{'L', 'P', 'H'};
  Eigen::Index axis = 0;
  side.cwiseAbs().maxCoeff(&axis);
  const auto k = static_cast<std::size_t>(axis);
  return QChar::fromLatin1(side[axis] < 0 ? kBelow[k] : kAbove[k]);
}

void ViewCube::setColours(const SceneColours& colours) {
  m_colours = colours;
  update();
}

ViewCubeGeometry ViewCube::geometryNow() const {
  return {m_orientation, {width() / 2.0, height() / 2.0}, kHalf};
}

std::optional<CubeRegion> ViewCube::regionAt(const QPointF& position) const {
  return geometryNow().regionAt({position.x(), position.y()});
}

void ViewCube::hover(const std::optional<CubeRegion>& region) {
  if (region == m_hovered) return;
  if (region && !m_hovered) emit entered();
  m_hovered = region;
  setToolTip(region ? shownName(*region) : QString());
  region ? setCursor(Qt::PointingHandCursor) : unsetCursor();
  update();
}

void ViewCube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintCells(painter);
  paintNames(painter);
  if (!hasFocus()) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(m_colours.accent, 2.0));
  painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 8, 8);
}

// Draws the cells. A side that faces the viewer is bright, one at a slant darker; edges and corners stand off a little.
void ViewCube::paintCells(QPainter& painter) const {
  for (const CubeCell& cell : geometryNow().cells()) {
    const double facing = (m_orientation.conjugate() * Vec3(cell.side.cast<double>())).z();
    QColor fill = mixed(m_colours.edge, m_colours.cubeSide, static_cast<float>(0.55 + 0.45 * facing));
    if (cell.region != cell.side) fill = mixed(fill, m_colours.edge, 0.14f);
    if (cell.region == m_hovered) fill = mixed(fill, m_colours.accent, 0.7f);
    fill.setAlphaF(0.94f);
    painter.setBrush(fill);
    painter.setPen(QPen(fill, 0.7));  // closes the seams between neighbours
    painter.drawPolygon(toPolygon(cell.outline));
  }
}

void ViewCube::paintNames(QPainter& painter) const {
  const ViewCubeGeometry geometry = geometryNow();
  for (const CubeCell& cell : geometry.cells()) {
    if (cell.region != cell.side) continue;
    const Vec3 out = cell.side.cast<double>();
    const auto [right, up] = axesOn(cell.side);
    const Vec2 middle = geometry.toScreen(out);
    const Vec2 x = geometry.toScreen(out + right) - middle, y = geometry.toScreen(out - up) - middle;
    QColor ink = m_colours.text;
    ink.setAlphaF(static_cast<float>(std::clamp(2.0 * (m_orientation.conjugate() * out).z(), 0.0, 1.0)));
    const QTransform onSide(x.x(), x.y(), y.x(), y.y(), middle.x(), middle.y());
    painter.fillPath(onSide.map(textPath(textOn(cell.side), font())), ink);
  }
}

void ViewCube::mousePressEvent(QMouseEvent* event) {
  m_pressed = event->button() == Qt::LeftButton ? regionAt(event->position()) : std::nullopt;
  m_isDragged = false;
  m_last = event->position();
  event->setAccepted(m_pressed.has_value());
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
  if (!m_pressed) {
    const auto region = event->buttons() == Qt::NoButton ? regionAt(event->position()) : std::nullopt;
    hover(region);
    return event->setAccepted(region.has_value());
  }
  const QPointF delta = event->position() - m_last;
  if (!m_isDragged && std::hypot(delta.x(), delta.y()) < kCubeDragThreshold) return;
  if (!m_isDragged) {
    hover({});
    setCursor(Qt::ClosedHandCursor);
    emit dragStarted();
  }
  m_isDragged = true;
  m_last = event->position();
  emit dragged(delta);
}

void ViewCube::mouseReleaseEvent(QMouseEvent* event) {
  if (!m_pressed || event->button() != Qt::LeftButton) return event->ignore();
  const auto pressed = *std::exchange(m_pressed, std::nullopt);
  if (m_isDragged) {
    unsetCursor();
    emit dragEnded();
  } else if (regionAt(event->position()) == pressed) {
    emit chosen(pressed);
  }
}

void ViewCube::mouseDoubleClickEvent(QMouseEvent* event) {
  mousePressEvent(event);
}

void ViewCube::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  hover({});
}

void ViewCube::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return emit stepped(-1, 0);
    case Qt::Key_Right:
      return emit stepped(1, 0);
    case Qt::Key_Up:
      return emit stepped(0, 1);
    case Qt::Key_Down:
      return emit stepped(0, -1);
    default:
      return QWidget::keyPressEvent(event);
  }
}

}  // namespace handwheel
