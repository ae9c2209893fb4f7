// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Lighting.h"
#include "viewport/overlay/ViewCubeGeometry.h"

#include <QWidget>

namespace handwheel {

// A cube in the corner of the view that turns with the camera. A click on a side, an edge or a corner selects the view
// from its direction, and a drag orbits. While the cube has the keyboard focus, the arrow keys turn the view by 45°.
// Mouse events beside the cube are left to the view.
class ViewCube : public QWidget {
  Q_OBJECT

 public:
  explicit ViewCube(QWidget* parent);

  void setOrientation(const Eigen::Quaterniond& orientation);
  void setColours(const SceneColours& colours);
  // Names the sides after those of a patient, whose coordinates are those of ImageGrid: x to the left, y to the back, z
  // to the head. The sides have the letters of slices.
  void setPatient(bool isPatient);
  QSize sizeHint() const override;

  // Returns the translated name of a region: "Front", "Front · Right · Top".
  static QString nameOf(const CubeRegion& region);
  // Returns the same for a patient: "Front of the patient (A)".
  static QString nameOnPatient(const CubeRegion& region);
  // Returns the text on a side.
  QString textOn(const CubeRegion& side) const;

 signals:
  void chosen(const handwheel::CubeRegion& region);
  void stepped(int around, int up);  // emitted for arrow keys, with the arguments for steppedFrom()
  void dragStarted();
  void dragged(const QPointF& delta);  // emitted while the cube is dragged; delta: logical pixels
  void dragEnded();
  void entered();  // emitted when the cursor moves from the model to the cube

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  ViewCubeGeometry geometryNow() const;
  std::optional<CubeRegion> regionAt(const QPointF& position) const;
  void hover(const std::optional<CubeRegion>& region);
  QString shownName(const CubeRegion& region) const;
  void describe();
  void paintCells(QPainter& painter) const;
  void paintNames(QPainter& painter) const;

  Eigen::Quaterniond m_orientation = Eigen::Quaterniond::Identity();
  SceneColours m_colours;
  bool m_isPatient = false;
  std::optional<CubeRegion> m_hovered;
  std::optional<CubeRegion> m_pressed;
  bool m_isDragged = false;
  QPointF m_last;
};

}  // namespace handwheel
