// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PartsLayer.h"

#include "viewport/LayerFrame.h"
#include "viewport/surface/PartActors.h"
#include "viewport/surface/PartPreparation.h"

namespace handwheel {

namespace {

constexpr double kProposedOpacity = 0.5;

}  // namespace

class PartsLayer::Private {
 public:
  Private(PartsLayer& layer, Role of)
      : q(layer),
        role(of),
        actors(layer.props(), of == Role::Proposed ? kProposedOpacity : 1.0),
        preparation([this](const PartPreparation::Soup& soup, PartShape shape) { take(soup, std::move(shape)); },
                    [this] { q.report(LayerChange::OutOfMemory); }) {}

  void take(const PartPreparation::Soup& soup, PartShape shape) {
    actors.setShape(soup, shape);
    preparation.request(actors.missing());
    q.report(LayerChange::Look);
  }

  PartsLayer& q;
  const Role role;
  PartActors actors;
  PartPreparation preparation;
  std::optional<std::uint64_t> hovered;
};

PartsLayer::PartsLayer(Role role) : d(std::make_unique<Private>(*this, role)) {}

PartsLayer::~PartsLayer() = default;

void PartsLayer::setParts(const std::vector<DisplayPart>& parts) {
  if (parts.empty() && d->actors.isEmpty()) return;
  d->actors.set(parts);
  d->preparation.request(d->actors.missing());
  if (d->role == Role::Model && !d->actors.isAnyShown()) return report(LayerChange::Model);
  const bool isGone = d->hovered && d->actors.nameOf(*d->hovered).empty();
  report(isGone ? LayerChange::Elements : LayerChange::Look);
}

void PartsLayer::setPartsAtOnce(const std::vector<DisplayPart>& parts) {
  d->actors.set(parts);
  for (const PartActors::Soup& soup : d->actors.missing()) {
    PartShape shape = shapeOf(*soup);
    d->actors.setShape(soup, shape);
  }
  report(LayerChange::Model);
}

void PartsLayer::setFaded(const std::vector<DisplayPart>& proposed) {
  if (d->actors.setFaded(proposed)) report(LayerChange::Look);
}

void PartsLayer::setFaintGroup(const std::string& group) {
  d->actors.setFaintGroup(group);
  report(LayerChange::Look);
}

void PartsLayer::setSelected(const std::set<std::string>& names, bool isCovered) {
  if (d->actors.setSelected(names, isCovered)) report(LayerChange::Look);
}

std::string PartsLayer::nameOf(std::uint64_t element) const {
  return d->actors.nameOf(element);
}

Box PartsLayer::bounds() const {
  return d->role == Role::Model ? d->actors.bounds() : Box();
}

Box PartsLayer::drawnBounds() const {
  return d->actors.bounds();
}

std::vector<Vec3> PartsLayer::outline() const {
  return d->role == Role::Model ? d->actors.outline() : std::vector<Vec3>();
}

void PartsLayer::setStyle(const SurfaceStyle& style) {
  d->actors.setStyle(style);
}

std::size_t PartsLayer::takePiece() {
  return d->actors.takeOne();
}

void PartsLayer::finish() {
  d->preparation.finish();
}

int PartsLayer::builtCount() const {
  return d->actors.builtCount();
}

void PartsLayer::prepare(const LayerFrame& frame) {
  d->actors.setOrigin(frame.origin);
}

bool PartsLayer::isSearchable() const {
  return d->role == Role::Proposed || d->actors.missing().empty();
}

std::optional<LayerHit> PartsLayer::firstHit(const Vec3& origin, const Vec3& direction) const {
  return d->role == Role::Model ? d->actors.firstHit(origin, direction) : std::nullopt;
}

void PartsLayer::setHovered(std::optional<std::uint64_t> element) {
  d->hovered = element;
  d->actors.setHighlighted(element ? nameOf(*element) : std::string());
}

std::string partOf(const Pick& pick) {
  const auto* layer = dynamic_cast<const PartsLayer*>(pick.layer);
  return layer ? layer->nameOf(pick.element) : std::string();
}

}  // namespace handwheel
