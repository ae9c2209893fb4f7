// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ViewLayer.h"

#include "viewport/LayerProps.h"

namespace handwheel {

ViewLayer::ViewLayer() : m_props(std::make_unique<LayerProps>()) {}

ViewLayer::~ViewLayer() = default;

void ViewLayer::setVisible(bool visible) {
  if (visible == m_isVisible) return;
  m_isVisible = visible;
  m_props->setVisible(visible);
  report(visible ? LayerChange::Model : LayerChange::Elements);
}

void ViewLayer::attach(vtkRenderer* renderer, Listener listener) {
  m_props->attach(renderer);
  m_listener = std::move(listener);
}

void ViewLayer::detach() {
  attach(nullptr, {});
}

void ViewLayer::paintOver(QPainter&, const QSizeF&, LengthUnit, const SceneColours&) const {}

std::optional<LayerHit> ViewLayer::firstHit(const Vec3&, const Vec3&) const {
  return std::nullopt;
}

void ViewLayer::findNear(const CameraNavigation&, const Vec2&, std::vector<LayerHit>&) const {}

Vec3 ViewLayer::normalNear(const Vec3&) const {
  return Vec3::Zero();
}

void ViewLayer::report(LayerChange change) const {
  if (m_listener) m_listener(*this, change);
}

}  // namespace handwheel
