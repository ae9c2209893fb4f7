// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/Tool.h"

#include <functional>

namespace handwheel {

// The distance between two points that one clicks at. It changes nothing.
class MeasureTool : public Tool {
 public:
  // pick: the point of the model that a ray meets first ("picking").
  using Pick = std::function<std::optional<Vec3>(const Ray&)>;
  explicit MeasureTool(Pick pick) : m_pick(std::move(pick)) {}

  // mm; between the first point and the second, or what is under the pointer. None before there are two.
  std::optional<double> distance() const;

  std::string id() const override { return "measure"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void documentChanged() override { m_first = m_second = m_hovered = std::nullopt; }
  std::vector<std::string> needs() const override { return {"picking"}; }

 private:
  std::optional<Vec3> end() const { return m_second ? m_second : m_hovered; }

  Pick m_pick;
  std::optional<Vec3> m_first, m_second, m_hovered;
};

}  // namespace handwheel
