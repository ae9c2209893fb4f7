// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyList.h"
#include "viewport/Viewport.h"

#include <QAction>

namespace handwheel {

// How the view shows the model: projection, clipping plane, view cube. Shown as a form, kept with nothing: a view is
// not a part of a document.
class ViewSettings : public QObject {
  Q_OBJECT

 public:
  ViewSettings(PropertyList& list, Viewport& viewport, QObject* parent = nullptr);

  // Another model is in view: the plane lies across it as it did across the last one.
  void followModel();
  // The model has changed its size, or the camera its projection.
  void refresh();
  void setLengthUnit(LengthUnit unit);
  // What was measured where the plane cuts the model; refreshes.
  void setSectionFigures(std::vector<Property> figures);
  QAction* clipAction() { return &m_clip; }  // cuts the model open
  // How everything is seen; kept from one start of the program to the next.
  QList<QAction*> viewActions() { return {&m_perspective, &m_cube}; }

 private:
  Vec3 axis() const;
  std::pair<double, double> range() const;  // of the offset across the model, mm
  void makeClipAction();
  void makeViewActions();
  void project();
  void set(const std::string& id, const PropertyValue& value);
  void clip();

  PropertyList& m_list;
  Viewport& m_viewport;
  QAction m_clip;
  QAction m_perspective;
  QAction m_cube;
  int m_axis = 0;  // X, Y, Z, or the direction of the view at the time it was chosen
  bool m_isFlipped = false;
  double m_offset = 0.0;  // along the axis, mm
  double m_place = 0.5;   // of the plane across the model, 0…1
  Vec3 m_viewDirection = Vec3::UnitZ();
  std::vector<Property> m_figures;
};

}  // namespace handwheel
