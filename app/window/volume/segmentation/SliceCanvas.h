// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/Scan.h"
#include "volume/segment/SlicePicture.h"

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>

namespace handwheel {

// The action of the left mouse button in a slice.
enum class SliceAction { Look, Paint, Erase, Grow };

// A slice of a scan at the crosshair, with the segment over it. Letters name the patient's sides. The left button
// performs the chosen action, or moves the crosshair with Shift; the right button changes the level and width of the
// greys, and the middle button pans. The wheel changes the slice, or zooms with Ctrl. Keys act at the crosshair:
// arrows, Page up and down, Home and End move it, Space performs the action, [ and ] change the radius, and + and -
// zoom.
class SliceCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit SliceCanvas(SlicePlane plane, QWidget* parent = nullptr);

  void setScan(std::shared_ptr<const Scan> scan);  // null: none
  // Shows the patient's left at the left.
  void setMirrored(bool isMirrored);
  void setSegment(const Segment& segment);
  void setGreys(const GreyWindow& greys);
  void setCrosshair(const Vec3& index);
  // radius: radius of the brush, mm.
  void setAction(SliceAction action, double radius);

  const SliceView& view() const { return m_view; }
  int slice() const;
  void goToSlice(int slice);
  // Returns the position of a sample in the widget, pixels.
  QPointF shownAt(const Vec3& index) const;

  QSize sizeHint() const override { return {300, 260}; }
  QSize minimumSizeHint() const override { return {90, 70}; }

 signals:
  void crosshairMoved(const handwheel::Vec3& index);
  void greysEdited(const handwheel::GreyWindow& greys);
  // The signals of a stroke of the brush: its first position, each further position, and its end. opposite: true if the
  // brush erases instead of painting, or vice versa.
  void strokeBegan(int through, const handwheel::Vec3& index, bool opposite);
  void strokeMoved(const handwheel::Vec3& index);
  void strokeEnded();
  void grown(const handwheel::Vec3& index);
  void radiusStepped(double factor);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Drag { None, Look, Stroke, Greys, Pan };

  QRectF pictureArea() const;  // area of all samples, in pixels of the widget
  Vec3 indexAt(const QPointF& position) const;
  Vec3 inImage(const Vec3& index) const;
  void zoomAt(const QPointF& position, double factor);
  void step(int right, int down, int through);
  void act();
  void drawPicture(QPainter& painter);
  void drawCrosshair(QPainter& painter) const;
  void drawBrush(QPainter& painter) const;
  void drawLetters(QPainter& painter) const;

  bool m_isMirrored = false;
  SlicePlane m_plane;
  std::shared_ptr<const Scan> m_scan;
  SliceView m_view{};
  Segment m_segment;
  GreyWindow m_greys;
  Vec3 m_crosshair = Vec3::Zero();
  SliceAction m_action = SliceAction::Look;
  double m_radius = 5.0;  // mm
  QImage m_picture;       // picture of the slice; empty: it must be drawn again
  double m_zoom = 1.0;    // 1: the whole slice is visible
  QPointF m_pan;          // offset of the picture's centre from the centre of the widget, pixels
  Drag m_drag = Drag::None;
  QPointF m_last;                  // position of the pointer during dragging
  std::optional<QPointF> m_hover;  // position of the pointer; none: outside the widget
};

}  // namespace handwheel
