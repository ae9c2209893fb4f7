// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/path/ContactLayer.h"

#include "viewport/DepthOffsetActor.h"
#include "viewport/Lighting.h"
#include "viewport/surface/SurfaceStyle.h"

#include <utility>

namespace handwheel {

namespace {

Vec3 endOf(const ContactMark& mark) {
  return mark.position + ContactLayer::kNormalLength * mark.normal;
}

}  // namespace

QColor contactColour() {
  return {0xff, 0xc8, 0x00};
}

class ContactLayer::Private {
 public:
  explicit Private(LayerProps& props)
      : lineRims(props, 5.0, 5.0), lines(props, 6.0, 2.4), dotRims(props, 7.0, 11.0), dots(props, 8.0, 8.0) {
    for (StrokeActors* const strokes : all()) strokes->drawOverAll();
  }
  std::array<StrokeActors*, 4> all() { return {&lineRims, &lines, &dotRims, &dots}; }
  void build();

  std::vector<ContactMark> contacts;
  Box box;
  Vec3 origin = Vec3::Zero();
  SceneColours colours = sceneColours(false);
  StrokeActors lineRims, lines, dotRims, dots;
  bool isStale = false;
};

void ContactLayer::Private::build() {
  std::vector<std::array<Vec3, 2>> ends;
  for (const ContactMark& mark : contacts) ends.push_back({mark.position, endOf(mark)});
  const auto strokesOf = [&](std::size_t points, const QColor& colour) {
    std::vector<Stroke> strokes;
    for (const auto& pair : ends) strokes.push_back({std::span(pair).first(points), false, colour});
    return strokes;
  };
  lineRims.set(strokesOf(2, colours.casing), origin);
  lines.set(strokesOf(2, contactColour()), origin);
  dotRims.set(strokesOf(1, colours.casing), origin);
  dots.set(strokesOf(1, contactColour()), origin);
}

ContactLayer::ContactLayer() : d(std::make_unique<Private>(props())) {}

ContactLayer::~ContactLayer() = default;

void ContactLayer::setContacts(std::vector<ContactMark> contacts) {
  if (contacts.empty() && d->contacts.empty()) return;
  d->contacts = std::move(contacts);
  d->box = {};
  for (const ContactMark& mark : d->contacts) {
    d->box.extend(mark.position);
    d->box.extend(endOf(mark));
  }
  d->origin = d->box.isEmpty() ? Vec3::Zero() : Vec3(d->box.center());
  d->isStale = true;
  report(LayerChange::Look);
}

Box ContactLayer::drawnBounds() const {
  return d->box;
}

void ContactLayer::setStyle(const SurfaceStyle& style) {
  if (style.colours == d->colours) return;
  d->colours = style.colours;
  d->isStale = true;
}

void ContactLayer::prepare(const LayerFrame& frame) {
  if (std::exchange(d->isStale, false)) d->build();
  const LayerFrame placed = frame.about(d->origin);
  for (StrokeActors* const strokes : d->all()) strokes->prepare(placed);
}

}  // namespace handwheel
