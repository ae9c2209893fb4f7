// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "viewport/ViewLayer.h"

#include <set>

namespace handwheel {

// A view layer that shows rigid parts. Its elements are parts.
class PartsLayer : public ViewLayer {
 public:
  // Proposed parts are translucent. They cannot be picked, and the camera is not fitted to them.
  enum class Role { Model, Proposed };
  explicit PartsLayer(Role role = Role::Model);
  ~PartsLayer() override;

  // Shows these parts. Returns at once. A part whose soup is still the same object is moved, not rebuilt; one whose
  // soup changed keeps its former shape until the new one has been built.
  void setParts(const std::vector<DisplayPart>& parts);
  // Shows these parts, and builds all their shapes before it returns, as a picture needs them.
  void setPartsAtOnce(const std::vector<DisplayPart>& parts);
  // Draws translucently each part for which a tool proposes another one of the same name.
  void setFaded(const std::vector<DisplayPart>& proposed);
  // Draws the parts of this group translucently, from now on; empty: none.
  void setFaintGroup(const std::string& group);
  // Marks the parts of these names by their colour. isCovered: all others are drawn translucently, so that the marked
  // ones are visible.
  void setSelected(const std::set<std::string>& names, bool isCovered);
  // Returns the name of an element; empty if there is no such part.
  std::string nameOf(std::uint64_t element) const;

  Box bounds() const override;
  Box drawnBounds() const override;
  std::vector<Vec3> outline() const override;
  void setStyle(const SurfaceStyle& style) override;
  std::size_t takePiece() override;
  void finish() override;
  int builtCount() const override;
  void prepare(const LayerFrame& frame) override;
  bool isSearchable() const override;
  std::optional<LayerHit> firstHit(const Vec3& origin, const Vec3& direction) const override;
  void setHovered(std::optional<std::uint64_t> element) override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

// Returns the name of the part that was hit; empty if the pick is not on a layer of parts.
std::string partOf(const Pick& pick);

}  // namespace handwheel
