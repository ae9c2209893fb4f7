// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/ToolKey.h"
#include "tools/mesh/MeshServices.h"

#include <array>

namespace handwheel {

class MeshDocument;

// Moves, turns and scales a whole mesh by numbers, or puts it where it is usually wanted: onto its largest flat face,
// along its main axes, to the origin. The box that it will have is shown.
class TransformTool : public Tool {
 public:
  // The document must outlive all calls but the destructor's.
  TransformTool(MeshDocument& document, MeshServices services)
      : m_document(document), m_services(std::move(services)) {}

  // First brought to millimetres, about the origin. Then scaled, and turned about x, y and z, in this order, all about
  // the centre of the box; then moved.
  Eigen::Affine3d placement() const;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "transform"; }
  ToolReply pointer(const PointerEvent&) override { return ToolReply::Ignored; }
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;

 private:
  bool isIdle() const;
  void reset();

  MeshDocument& m_document;
  MeshServices m_services;
  std::array<double, 3> m_shift{};  // mm
  std::array<double, 3> m_turn{};   // radian
  double m_scale = 1.0;
  int m_unit = 0;  // that the file was written in, as in kUnits
};

}  // namespace handwheel
