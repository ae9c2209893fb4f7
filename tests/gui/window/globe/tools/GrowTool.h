// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "globe/document/GlobeDocument.h"
#include "tools/Tool.h"

namespace handwheel::test {

// Tool that doubles the size of the globe. It shows the result while a button is held, and applies it when the button
// is released.
class GrowTool : public Tool {
 public:
  explicit GrowTool(GlobeDocument& document) : m_document(document) {}

  std::string id() const override { return "grow"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override { return {{"revert", "Esc", "leave"}}; }
  ToolPreview preview() const override;

 private:
  GlobeDocument& m_document;
  std::optional<double> m_radius;
};

}  // namespace handwheel::test
