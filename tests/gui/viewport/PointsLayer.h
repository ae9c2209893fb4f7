// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/DepthOffsetActor.h"
#include "viewport/ViewLayer.h"
#include "viewport/surface/SurfaceStyle.h"

#include <vtkProperty.h>
#include <deque>

// A layer for a kind of geometry that the program does not have, for tests. It draws points of a few pixels, built in
// blocks, in the colour of the view.
namespace handwheel::test {

class PointsLayer : public ViewLayer {
 public:
  static constexpr std::size_t kBlock = 1000;   // points per block
  static constexpr double kDot = 9.0;           // logical pixels across
  static constexpr double kReach = kDot / 2.0;  // largest distance from the cursor, logical pixels

  void setPoints(std::vector<Vec3> points) {
    m_points = std::move(points);
    m_waiting.clear();
    const std::size_t count = (m_points.size() + kBlock - 1) / kBlock;
    for (std::size_t block = 0; block < count; ++block) m_waiting.push_back(block);
    for (std::size_t block = count; block < m_blocks.size(); ++block) m_blocks[block]->hide();
    m_mark.hide();
    m_hovered.reset();
    report(LayerChange::Model);
  }
  // Moves a point; only its block is built again.
  void movePoint(std::size_t i, const Vec3& to) {
    m_points[i] = to;
    m_waiting.push_back(i / kBlock);
    report(LayerChange::Elements);
  }
  // Replaces the points by the same number of moved points. Only the blocks in which a point has moved are built again.
  void movePoints(std::vector<Vec3> points) {
    for (std::size_t first = 0; first < m_points.size(); first += kBlock) {
      const std::size_t last = std::min(first + kBlock, m_points.size());
      if (!std::equal(&m_points[first], &m_points[first] + (last - first), &points[first]))
        m_waiting.push_back(first / kBlock);
    }
    const bool isSame = points == m_points;
    m_points = std::move(points);
    if (!isSame) report(LayerChange::Elements);
  }
  const std::vector<Vec3>& points() const { return m_points; }
  std::optional<std::uint64_t> hovered() const { return m_hovered; }

  Box bounds() const override {
    Box box;
    for (const Vec3& p : m_points) box.extend(p);
    return box;
  }
  std::vector<Vec3> outline() const override { return m_points; }

  void setStyle(const SurfaceStyle& style) override {
    m_colour = style.colours.wire;
    m_accent = style.colours.accent;
  }
  std::size_t takePiece() override {
    if (m_waiting.empty()) return 0;
    build(m_waiting.front());
    m_waiting.pop_front();
    ++m_built;
    return kBlock;
  }
  int builtCount() const override { return m_built; }
  void prepare(const LayerFrame& frame) override {
    if (std::exchange(m_isHoverStale, false)) buildHovered();
    for (const auto& block : m_blocks) prepare(*block, frame);
    prepare(m_mark, frame);
  }

  // Adds the points near the cursor. Points have no surface that a ray could meet.
  void findNear(const CameraNavigation& view, const Vec2& cursor, std::vector<LayerHit>& found) const override {
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      if (!view.isBeforeEye(m_points[i])) continue;
      const double pixels = (view.toScreen(m_points[i]) - cursor).norm();
      if (pixels <= kReach) found.push_back({i, m_points[i], pixels});
    }
  }
  void setHovered(std::optional<std::uint64_t> element) override {
    m_isHoverStale = m_isHoverStale || element != m_hovered;
    m_hovered = element;
  }

 private:
  static vtkSmartPointer<vtkPolyData> dots(std::span<const Vec3> points, const QColor& colour) {
    PolyDataBuilder builder(Vec3::Zero());
    for (const Vec3& p : points) builder.addCell({builder.addPoint(p, colour)});
    return builder.build(PolyDataBuilder::Kind::Points);
  }
  void build(std::size_t block) {
    if (block >= m_blocks.size()) m_blocks.push_back(std::make_unique<DepthOffsetActor>(props(), 0.5));
    const std::size_t first = block * kBlock, count = std::min(kBlock, m_points.size() - first);
    m_blocks[block]->setData(dots(std::span(m_points).subspan(first, count), m_colour));
  }
  void buildHovered() {
    if (!m_hovered || *m_hovered >= m_points.size()) return m_mark.hide();
    m_mark.setData(dots({&m_points[*m_hovered], 1}, m_accent));
  }
  static void prepare(DepthOffsetActor& actor, const LayerFrame& frame) {
    actor.property()->LightingOff();
    actor.property()->SetPointSize(static_cast<float>(kDot * frame.pixelRatio));
    actor.prepare(frame.about(Vec3::Zero()));
  }

  std::vector<Vec3> m_points;
  std::deque<std::size_t> m_waiting;  // numbers of the blocks to be built
  std::vector<std::unique_ptr<DepthOffsetActor>> m_blocks;
  DepthOffsetActor m_mark{props(), 1.5};
  std::optional<std::uint64_t> m_hovered;
  bool m_isHoverStale = false;
  QColor m_colour, m_accent;
  int m_built = 0;
};

}  // namespace handwheel::test
