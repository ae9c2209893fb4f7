// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeDocument.h"

#include "base/NumberText.h"
#include "base/Utf8.h"
#include "document/volume/LayerSteps.h"

#include <QtGlobal>
#include <charconv>

namespace handwheel {
namespace {

constexpr const char* kLayerProperty = "layer.";

std::string layerProperty(std::size_t layer, const char* what) {
  return kLayerProperty + std::to_string(layer + 1) + "." + what;
}

void addLayerProperties(const ClayLayers& layers, std::vector<Property>& all) {
  for (std::size_t i = 0; i < layers.all().size(); ++i) {
    const ClayLayer& layer = layers.all()[i];
    const auto add = [&](const char* what, const char* label, PropertyValue value) -> Property& {
      Property property{layerProperty(i, what), std::to_string(i + 1) + ": " + layer.name, label, std::move(value)};
      property.groupTranslated = false;
      all.push_back(std::move(property));
      return all.back();
    };
    add("name", QT_TRANSLATE_NOOP("Property", "Layer"), layer.name);
    add("on", QT_TRANSLATE_NOOP("Property", "Visible"), layer.isOn);
    Property& strength = add("strength", QT_TRANSLATE_NOOP("Property", "Strength"), layer.strength);
    strength.least = 0.0;
    strength.largest = 1.0;
    strength.continuous = true;
  }
}

// Parses "layer.2.name" to the second layer and the rest; none for other properties.
struct LayerPropertyName {
  std::size_t layer = 0;
  std::string what;
};
std::optional<LayerPropertyName> layerOfProperty(const std::string& id, const VolumeSnapshot& volume) {
  const std::string prefix = kLayerProperty;
  if (!volume.layers || !id.starts_with(prefix)) return std::nullopt;
  std::size_t number = 0;
  const auto read = std::from_chars(id.data() + prefix.size(), id.data() + id.size(), number);
  if (read.ec != std::errc() || number < 1 || number > volume.layers->all().size()) return std::nullopt;
  for (const char* what : {"name", "on", "strength"})
    if (id == layerProperty(number - 1, what)) return LayerPropertyName{number - 1, what};
  return std::nullopt;
}

}  // namespace

VolumeDocument::VolumeDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent),
      m_volume(std::static_pointer_cast<const VolumeSnapshot>(opened.content)),
      m_scan(m_volume->scan),
      m_segment(m_volume->segment),
      m_tried(m_volume->tried) {}

std::shared_ptr<const VolumeSnapshot> VolumeDocument::completed(
    const std::shared_ptr<const VolumeSnapshot>& volume) const {
  const bool isOfScan = !m_scan || (volume->scan == m_scan && volume->segment == m_segment);
  if (isOfScan && volume->tried == m_tried) return volume;
  auto whole = std::make_shared<VolumeSnapshot>(*volume);
  if (m_scan) {
    whole->scan = m_scan;
    whole->segment = m_segment;
  }
  whole->tried = m_tried;
  return whole;
}

void VolumeDocument::addTried(const DrillRecord& hole, double forbidden) {
  TriedHoles before = m_tried ? *m_tried : TriedHoles();
  m_tried = std::make_shared<const TriedHoles>(withHole(std::move(before), m_volume->holes, hole, forbidden));
  wasRecorded();
}

std::vector<Property> VolumeDocument::properties() const {
  const SparseVolume& volume = m_volume->volume;
  const std::string group = QT_TRANSLATE_NOOP("Property", "Volume");
  std::vector<Property> all;
  const auto add = [&](std::string id, std::string label, PropertyValue value, Quantity quantity) {
    Property property{std::move(id), group, std::move(label), std::move(value), quantity};
    property.editable = false;
    all.push_back(std::move(property));
  };
  add("voxel", QT_TRANSLATE_NOOP("Property", "Voxel"), volume.voxel(), Quantity::Length);
  add("material", QT_TRANSLATE_NOOP("Property", "Material (mm³)"), volume.enclosed(), Quantity::Number);
  add("triangles", QT_TRANSLATE_NOOP("Property", "Triangles"), static_cast<double>(m_volume->surface.triangleCount()),
      Quantity::Number);
  add("memory", QT_TRANSLATE_NOOP("Property", "Memory (MB)"), static_cast<double>(volume.bytes()) / 1e6,
      Quantity::Number);
  if (m_volume->layers)
    add("layers", QT_TRANSLATE_NOOP("Property", "Memory of the layers (MB)"),
        static_cast<double>(m_volume->layers->bytes()) / 1e6, Quantity::Number);
  add("source", QT_TRANSLATE_NOOP("Property", "Made from"), m_volume->source, Quantity::Number);
  if (m_volume->layers) addLayerProperties(*m_volume->layers, all);
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

Result<std::unique_ptr<Edit>> VolumeDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  const std::optional<LayerPropertyName> found = layerOfProperty(id, *m_volume);
  if (!found) return Document::propertyEdit(id, value);
  const ClayLayer& layer = m_volume->layers->all()[found->layer];
  const auto share = [&](double strength, bool isOn) {
    const PreparedShare* const known = m_prepared.get();
    const bool isPrepared = known && known->of == m_volume && known->layer == found->layer &&
                            known->strength == strength && known->isOn == isOn;
    if (isPrepared) return std::unique_ptr<Edit>(known->step.edit(id));
    return std::unique_ptr<Edit>(withLayerShare(*m_volume, found->layer, strength, isOn).edit(id));
  };
  if (found->what == "name") {
    const auto* const name = std::get_if<std::string>(&value);
    if (!name || name->size() > ClayLayers::kLongestName || !isUtf8(*name))
      return Error{ErrorCode::ElementMalformed, {id, "a text of at most 1000 bytes in UTF-8 was expected"}, {}, {}};
    if (name->empty() || *name == layer.name) return std::unique_ptr<Edit>();
    return std::unique_ptr<Edit>(withLayerNamed(*m_volume, found->layer, *name).edit(id));
  }
  if (found->what == "on") {
    const auto* const isOn = std::get_if<bool>(&value);
    if (!isOn) return Error{ErrorCode::ElementMalformed, {id, "yes or no was expected"}, {}, {}};
    return *isOn == layer.isOn ? std::unique_ptr<Edit>() : share(layer.strength, *isOn);
  }
  const auto* const strength = std::get_if<double>(&value);
  if (!strength) return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
  if (!(*strength >= 0.0 && *strength <= 1.0))
    return Error{ErrorCode::ValueOutOfRange, {id, shortestText(*strength), "0", "1"}, {}, {}};
  return *strength == layer.strength ? std::unique_ptr<Edit>() : share(*strength, layer.isOn);
}

}  // namespace handwheel
