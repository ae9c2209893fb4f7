// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewLayer.h"

#include <QColor>
#include <memory>
#include <vector>

namespace handwheel {

// A contact point of two surfaces, with the outward normal of one of them.
struct ContactMark {
  Vec3 position = Vec3::Zero();  // mm
  Vec3 normal = Vec3::UnitZ();   // unit length
};

// Returns the colour of contacts. It stands out on surfaces in the colour of collisions.
QColor contactColour();

// A view layer with dots at contact points. A line from each dot shows the normal. The model does not hide dots and
// lines, and they are ignored by fitting and picking.
class ContactLayer : public ViewLayer {
 public:
  static constexpr double kNormalLength = 40.0;  // length of the lines, mm

  ContactLayer();
  ~ContactLayer() override;

  void setContacts(std::vector<ContactMark> contacts);

  Box bounds() const override { return {}; }
  Box drawnBounds() const override;
  std::vector<Vec3> outline() const override { return {}; }
  void setStyle(const SurfaceStyle& style) override;
  void prepare(const LayerFrame& frame) override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
