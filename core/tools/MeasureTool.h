// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/measure/WallThickness.h"
#include "tools/ToolKey.h"

#include <functional>

namespace handwheel {

// A point of the model's surface.
struct SurfacePoint {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  // unit length, outward; zero: unknown
  Face face = kNone;           // face of a mesh
};

// Services that MeasureTool uses.
struct MeasureServices {
  // Returns the first intersection of a ray with the model ("picking").
  std::function<std::optional<SurfacePoint>(const Ray&)> pick;
  // Measures the wall below a point. Null if the model is not a body of one mesh: only points are measured in this
  // case.
  std::function<std::optional<WallThickness>(const SurfacePoint&)> thickness;
};

// Tool that measures distances, angles and wall thickness at clicked points. The tool measures the distance of two
// points, the angle of three, the angle between two faces, or the thickness of the wall below a point. The document is
// not changed.
class MeasureTool : public Tool {
 public:
  enum class Mode { Distance, PointAngle, FaceAngle, Thickness };

  explicit MeasureTool(MeasureServices services) : m_services(std::move(services)) {}

  // Returns the distance of the two points, of which the last may be the one under the pointer; nothing while points
  // are missing.
  std::optional<double> distance() const;  // mm
  // Returns the angle, 0…π rad. The angle of points is that at the second point between the others. The angle of faces
  // is measured through the material: π/2 between adjacent sides of a square bar, 0 between opposite ones.
  std::optional<double> angle() const;
  std::optional<WallThickness> thickness() const;

  static std::span<const ToolKey> keys();
  std::string id() const override { return "measure"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  // Returns corners and edges for points, which are hard to hit by hand, and faces for directions and walls.
  SnapTargets snapTargets() const override;
  void documentChanged() override { start(); }
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  std::size_t wanted() const;                // number of points that the mode needs
  std::vector<SurfacePoint> points() const;  // the clicked points and the one under the pointer
  void start();
  bool isOfPoints() const { return m_mode == Mode::Distance || m_mode == Mode::PointAngle; }
  std::optional<SurfacePoint> pointAt(const PointerEvent& event) const;
  void addAngle(ToolPreview& preview, const std::vector<SurfacePoint>& points) const;

  MeasureServices m_services;
  Mode m_mode = Mode::Distance;
  std::vector<SurfacePoint> m_clicked;
  std::optional<SurfacePoint> m_hovered;
  double m_pixel = 0.0;  // mm per pixel at the last position of the pointer
};

}  // namespace handwheel
