// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/segmentation/SliceCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr std::uint32_t kOverlay = 0x70ff9d2e;  // colour of the segment: amber, which differs from all greys
const QColor kCross(90, 200, 250, 170);

}  // namespace

SliceCanvas::SliceCanvas(SlicePlane plane, QWidget* parent) : QWidget(parent), m_plane(plane) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
}

void SliceCanvas::setScan(std::shared_ptr<const Scan> scan) {
  m_scan = std::move(scan);
  if (m_scan) m_view = sliceView(m_scan->image.grid(), m_plane, m_isMirrored);
  m_segment = Segment();
  m_picture = QImage();
  m_zoom = 1.0;
  m_pan = {};
  m_drag = Drag::None;
  update();
}

void SliceCanvas::setMirrored(bool isMirrored) {
  m_isMirrored = isMirrored;
  if (m_scan) m_view = sliceView(m_scan->image.grid(), m_plane, m_isMirrored);
  m_picture = QImage();
  m_drag = Drag::None;
  update();
}

void SliceCanvas::setSegment(const Segment& segment) {
  m_segment = segment;
  m_picture = QImage();
  update();
}

void SliceCanvas::setGreys(const GreyWindow& greys) {
  m_greys = greys;
  m_picture = QImage();
  update();
}

void SliceCanvas::setCrosshair(const Vec3& index) {
  const int before = m_scan ? slice() : 0;
  m_crosshair = index;
  if (m_scan && slice() != before) m_picture = QImage();
  update();
}

void SliceCanvas::setAction(SliceAction action, double radius) {
  m_action = action;
  m_radius = radius;
  setCursor(action == SliceAction::Look ? Qt::ArrowCursor : Qt::CrossCursor);
  update();
}

int SliceCanvas::slice() const {
  return std::clamp(static_cast<int>(std::lround(m_crosshair[m_view.through])), 0, m_view.slices - 1);
}

void SliceCanvas::goToSlice(int slice) {
  if (!m_scan) return;
  Vec3 index = m_crosshair;
  index[m_view.through] = std::clamp(slice, 0, m_view.slices - 1);
  if (index != m_crosshair) emit crosshairMoved(index);
}

QRectF SliceCanvas::pictureArea() const {
  const double across = m_view.width * m_view.rightSpacing, high = m_view.height * m_view.downSpacing;  // mm
  const double scale = m_zoom * std::min(width() / across, height() / high);
  const QSizeF size(across * scale, high * scale);
  const QPointF middle = QPointF(0.5 * width(), 0.5 * height()) + m_pan;
  return {middle - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
}

Vec3 SliceCanvas::indexAt(const QPointF& position) const {
  const QRectF area = pictureArea();
  return m_view.indexAt((position.x() - area.left()) / area.width() * m_view.width - 0.5,
                        (position.y() - area.top()) / area.height() * m_view.height - 0.5, slice());
}

Vec3 SliceCanvas::inImage(const Vec3& index) const {
  const std::array<int, 3>& size = m_scan->image.grid().size;
  return index.cwiseMax(Vec3::Zero()).cwiseMin(Vec3(size[0] - 1, size[1] - 1, size[2] - 1));
}

QPointF SliceCanvas::shownAt(const Vec3& index) const {
  const QRectF area = pictureArea();
  const auto [x, y] = m_view.pictureAt(index);
  return {area.left() + (x + 0.5) / m_view.width * area.width(),
          area.top() + (y + 0.5) / m_view.height * area.height()};
}

void SliceCanvas::zoomAt(const QPointF& position, double factor) {
  constexpr double kMost = 40.0;
  const double zoom = std::clamp(m_zoom * factor, 1.0, kMost);
  const QPointF middle(0.5 * width(), 0.5 * height());
  m_pan = zoom == 1.0 ? QPointF() : position - middle - (position - middle - m_pan) * (zoom / m_zoom);
  m_zoom = zoom;
  update();
}

void SliceCanvas::step(int right, int down, int through) {
  Vec3 index = m_crosshair;
  index[m_view.right] += m_view.isRightReversed ? -right : right;
  index[m_view.down] += m_view.isDownReversed ? -down : down;
  index[m_view.through] += through;
  index = inImage(index.array().round());
  if (index != m_crosshair) emit crosshairMoved(index);
}

// At the crosshair.
void SliceCanvas::act() {
  if (m_action == SliceAction::Grow) emit grown(m_crosshair);
  if (m_action != SliceAction::Paint && m_action != SliceAction::Erase) return;
  emit strokeBegan(m_view.through, m_crosshair, false);
  emit strokeEnded();
}

void SliceCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!m_scan) return;
  drawPicture(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  drawCrosshair(painter);
  drawBrush(painter);
  drawLetters(painter);
}

void SliceCanvas::drawPicture(QPainter& painter) {
  if (m_picture.isNull()) {
    const SlicePicture made = pictureOf(m_scan->image, m_segment, m_view, slice(), m_greys, kOverlay);
    m_picture = QImage(reinterpret_cast<const uchar*>(made.pixels.data()), made.width, made.height,
                       4 * static_cast<qsizetype>(made.width), QImage::Format_RGB32)
                    .copy();
  }
  // Large samples are drawn without smoothing.
  painter.setRenderHint(QPainter::SmoothPixmapTransform, pictureArea().width() < 3.0 * m_picture.width());
  painter.drawImage(pictureArea(), m_picture);
}

void SliceCanvas::drawCrosshair(QPainter& painter) const {
  const QPointF at = shownAt(m_crosshair);
  painter.setPen(kCross);
  constexpr double kGap = 6.0;  // pixels; keeps the crosshair's position visible
  painter.drawLine(QPointF(0, at.y()), QPointF(at.x() - kGap, at.y()));
  painter.drawLine(QPointF(at.x() + kGap, at.y()), QPointF(width(), at.y()));
  painter.drawLine(QPointF(at.x(), 0), QPointF(at.x(), at.y() - kGap));
  painter.drawLine(QPointF(at.x(), at.y() + kGap), QPointF(at.x(), height()));
}

// Around the pointer, or around the crosshair while the keys move that.
void SliceCanvas::drawBrush(QPainter& painter) const {
  if (m_action != SliceAction::Paint && m_action != SliceAction::Erase) return;
  if (!m_hover && !hasFocus()) return;
  const double radius = m_radius * pictureArea().width() / (m_view.width * m_view.rightSpacing);
  painter.setPen(QPen(m_action == SliceAction::Paint ? QColor(255, 190, 90) : QColor(255, 90, 90), 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(m_hover.value_or(shownAt(m_crosshair)), radius, radius);
}

void SliceCanvas::drawLetters(QPainter& painter) const {
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  const QRectF inner = QRectF(rect()).adjusted(4, 2, -4, -2);
  const auto letter = [&](char side, Qt::Alignment where) {
    const QString text{QChar::fromLatin1(side)};
    painter.setPen(Qt::black);
    painter.drawText(inner.translated(1, 1), static_cast<int>(where), text);
    painter.setPen(QColor(255, 230, 120));
    painter.drawText(inner, static_cast<int>(where), text);
  };
  letter(m_view.atLeft, Qt::AlignLeft | Qt::AlignVCenter);
  letter(m_view.atRight, Qt::AlignRight | Qt::AlignVCenter);
  letter(m_view.atTop, Qt::AlignTop | Qt::AlignHCenter);
  letter(m_view.atBottom, Qt::AlignBottom | Qt::AlignHCenter);
  if (hasFocus()) {
    painter.setPen(QPen(kCross, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
  }
}

void SliceCanvas::mousePressEvent(QMouseEvent* event) {
  if (!m_scan || m_drag != Drag::None) return;
  m_last = event->position();
  const Vec3 index = indexAt(m_last);
  if (event->button() == Qt::RightButton) m_drag = Drag::Greys;
  if (event->button() == Qt::MiddleButton) m_drag = Drag::Pan;
  if (event->button() != Qt::LeftButton) return;
  const bool isLook = m_action == SliceAction::Look || (event->modifiers() & Qt::ShiftModifier) != 0;
  if (!isLook && m_action == SliceAction::Grow) return emit grown(inImage(index.array().round()));
  m_drag = isLook ? Drag::Look : Drag::Stroke;
  if (isLook) return emit crosshairMoved(inImage(index));
  emit strokeBegan(m_view.through, index, (event->modifiers() & Qt::ControlModifier) != 0);
}

void SliceCanvas::mouseMoveEvent(QMouseEvent* event) {
  m_hover = event->position();
  const QPointF displacement = event->position() - m_last;
  m_last = event->position();
  if (m_drag == Drag::Look) emit crosshairMoved(inImage(indexAt(m_last)));
  if (m_drag == Drag::Stroke) emit strokeMoved(indexAt(m_last));
  if (m_drag == Drag::Pan) m_pan += displacement;
  if (m_drag == Drag::Greys) {
    // The convention of viewers of scans: to the right wider, downwards brighter; 500 pixels span all values.
    const double extent = m_scan->histogram.values.largest - m_scan->histogram.values.least;
    const double perPixel = std::max(extent, 1e-9) / 500.0;
    emit greysEdited(
        {m_greys.level - displacement.y() * perPixel, std::max(perPixel, m_greys.width + displacement.x() * perPixel)});
  }
  update();
}

void SliceCanvas::mouseReleaseEvent(QMouseEvent* event) {
  const Qt::MouseButton button = m_drag == Drag::Greys ? Qt::RightButton
                                 : m_drag == Drag::Pan ? Qt::MiddleButton
                                                       : Qt::LeftButton;
  if (event->button() == button && std::exchange(m_drag, Drag::None) == Drag::Stroke) emit strokeEnded();
}

void SliceCanvas::leaveEvent(QEvent*) {
  m_hover.reset();
  update();
}

void SliceCanvas::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (!m_scan) return;
  const double notches = event->angleDelta().y() / 120.0;
  if ((event->modifiers() & Qt::ControlModifier) != 0) return zoomAt(event->position(), std::pow(1.25, notches));
  goToSlice(slice() + (notches > 0.0 ? 1 : -1) * std::max(1, static_cast<int>(std::abs(notches))));
}

void SliceCanvas::keyPressEvent(QKeyEvent* event) {
  if (!m_scan) return QWidget::keyPressEvent(event);
  constexpr double kZoom = 1.25, kRadius = 1.15;
  switch (event->key()) {
    case Qt::Key_Left:
      return step(-1, 0, 0);
    case Qt::Key_Right:
      return step(1, 0, 0);
    case Qt::Key_Up:
      return step(0, -1, 0);
    case Qt::Key_Down:
      return step(0, 1, 0);
    case Qt::Key_PageUp:
      return goToSlice(slice() + 1);
    case Qt::Key_PageDown:
      return goToSlice(slice() - 1);
    case Qt::Key_Home:
      return goToSlice(0);
    case Qt::Key_End:
      return goToSlice(m_view.slices - 1);
    case Qt::Key_Space:
      return act();
    case Qt::Key_BracketLeft:
      emit radiusStepped(1.0 / kRadius);
      return;
    case Qt::Key_BracketRight:
      emit radiusStepped(kRadius);
      return;
    case Qt::Key_Plus:
      return zoomAt(shownAt(m_crosshair), kZoom);
    case Qt::Key_Minus:
      return zoomAt(shownAt(m_crosshair), 1.0 / kZoom);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace handwheel
