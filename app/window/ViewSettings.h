// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/property/PropertyList.h"
#include "mesh/search/PickRay.h"
#include "viewport/Viewport.h"

#include <QAction>
#include <optional>

namespace handwheel {

// The settings of the view: projection, clipping plane, view cube. They are shown as a form and are not stored with a
// document.
class ViewSettings : public QObject {
  Q_OBJECT

 public:
  ViewSettings(PropertyList& list, Viewport& viewport, QObject* parent = nullptr);

  // Updates the settings. To be called when another model is shown. The clipping plane gets the same relative position
  // as in the previous model.
  void followModel();
  // Updates the settings. To be called when the size of the model or the projection of the camera has changed.
  void refresh();
  void setLengthUnit(LengthUnit unit);
  // Sets the measurements of the section and refreshes.
  void setSectionFigures(std::vector<Property> statistics);
  QAction* clipAction() { return &m_clip; }  // switches the clipping plane on and off
  // Returns the action that cuts through the axis of the model and hides the half nearer to the viewer.
  QAction* halfSectionAction() { return &m_half; }
  // Sets the axis of the present model; none: the model has no half section.
  void setSectionAxis(std::optional<Ray> axis);
  // Returns the actions for projection and view cube, whose states are stored in the settings.
  QList<QAction*> viewActions() { return {&m_perspective, &m_cube}; }

 private:
  Vec3 axis() const;
  std::pair<double, double> range() const;  // range of the plane's offset within the model, mm
  void makeClipAction();
  void makeHalfSectionAction();
  void cutThroughAxis();
  void makeViewActions();
  void project();
  void set(const std::string& id, const PropertyValue& value);
  void clip();

  PropertyList& m_list;
  Viewport& m_viewport;
  QAction m_clip;
  QAction m_half;
  QAction m_perspective;
  QAction m_cube;
  int m_axis = 0;  // 0…2: X, Y, Z; 3: the direction of the view when this axis was chosen
  bool m_isFlipped = false;
  std::optional<Ray> m_sectionAxis;  // the plane stays at this axis while the half section is on
  double m_offset = 0.0;             // offset of the plane along the axis, mm
  double m_relativeOffset = 0.5;     // relative position of the plane within the model, 0…1
  Vec3 m_viewDirection = Vec3::UnitZ();
  std::vector<Property> m_figures;
};

}  // namespace handwheel
