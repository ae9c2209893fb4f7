// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyProperties.h"

#include "base/NumberText.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyDescription.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"

#include <QtGlobal>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace handwheel {

namespace {

constexpr std::string_view kBodyPrefix = "body.";

std::string colourText(const std::array<float, 3>& colour) {
  const auto level = [&](std::size_t i) { return static_cast<unsigned>(std::lround(255.0f * colour[i])); };
  char text[16];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", level(0), level(1), level(2));
  return text;
}

std::optional<std::array<float, 3>> colourFrom(std::string_view text) {
  std::array<float, 3> colour{};
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    unsigned level = 0;
    const char* const first = text.data() + 1 + 2 * i;
    const auto [stop, error] = std::from_chars(first, first + 2, level, 16);
    if (error != std::errc() || stop != first + 2) return std::nullopt;
    colour[i] = static_cast<float>(level) / 255.0f;
  }
  return colour;
}

const char* linkProblem(LinkState state) {
  if (state == LinkState::Missing) return QT_TRANSLATE_NOOP("Property", "the file is missing");
  if (state == LinkState::Changed) return QT_TRANSLATE_NOOP("Property", "the file has changed since it was read");
  return "";
}

// Collects the properties of one body.
class PropertiesOfBody {
 public:
  explicit PropertiesOfBody(const Body& body)
      : m_prefix(std::string(kBodyPrefix) + std::to_string(body.id) + '.'), m_group(body.name) {}

  Property& add(const char* field, const char* label, PropertyValue value) {
    Property property;
    property.id = m_prefix + field;
    property.group = m_group;
    property.groupTranslated = false;
    property.label = label;
    property.value = std::move(value);
    m_all.push_back(std::move(property));
    return m_all.back();
  }
  void addNumber(const char* field, const char* label, double value, Quantity quantity, double least, double largest) {
    Property& property = add(field, label, value);
    property.quantity = quantity;
    property.least = least;
    property.largest = largest;
  }
  void addLength(const char* field, const char* label, double value) {
    addNumber(field, label, value, Quantity::Length, -kFarthestBody, kFarthestBody);
  }
  void addAngle(const char* field, const char* label, double value, double largest) {
    addNumber(field, label, value, Quantity::Angle, -largest, largest);
  }
  Property& addToRead(const char* field, const char* label, std::string value) {
    Property& property = add(field, label, std::move(value));
    property.editable = false;
    return property;
  }
  std::vector<Property> take() { return std::move(m_all); }

 private:
  std::string m_prefix;
  std::string m_group;
  std::vector<Property> m_all;
};

void addPose(const Pose& pose, PropertiesOfBody& all) {
  constexpr double kPi = std::numbers::pi;
  const Vec3 at = pose.translation(), angles = rollPitchYaw(pose);
  all.addLength("x", QT_TRANSLATE_NOOP("Property", "X"), at.x());
  all.addLength("y", QT_TRANSLATE_NOOP("Property", "Y"), at.y());
  all.addLength("z", QT_TRANSLATE_NOOP("Property", "Z"), at.z());
  all.addAngle("rx", QT_TRANSLATE_NOOP("Property", "Rotate about X"), angles.x(), kPi);
  all.addAngle("ry", QT_TRANSLATE_NOOP("Property", "Rotate about Y"), angles.y(), 0.5 * kPi);
  all.addAngle("rz", QT_TRANSLATE_NOOP("Property", "Rotate about Z"), angles.z(), kPi);
}

void addShape(const BodyGeometry& geometry, PropertiesOfBody& all) {
  Property& shape = all.addToRead("shape", QT_TRANSLATE_NOOP("Property", "Shape"), shapeNameOf(geometry));
  if (!geometry.isKnown()) shape.problem = QT_TRANSLATE_NOOP("Property", "cannot be shown");
  const auto* primitive = dynamic_cast<const PrimitiveGeometry*>(&geometry);
  for (std::size_t i = 0; primitive && i < primitive->dimensions().size(); ++i) {
    const auto& [id, label] = primitive->description().dimensions[i];
    all.addNumber(id, label, primitive->dimensions()[i], Quantity::Length, PrimitiveGeometry::kLeastSize,
                  PrimitiveGeometry::kLargestSize);
  }
}

bool setPoseField(Body& body, std::string_view field, double value) {
  constexpr std::string_view kAxes = "xyz";
  const std::size_t axis = kAxes.find(field.back());
  if (axis == kAxes.npos || (field.size() == 2 && field[0] != 'r') || field.size() > 2) return false;
  const auto i = static_cast<Eigen::Index>(axis);
  if (field.size() == 1) {
    body.pose.translation()[i] = value;
  } else {
    Vec3 angles = rollPitchYaw(body.pose);
    angles[i] = value;
    body.pose = poseOf(body.pose.translation(), angles);
  }
  return true;
}

Status setDimension(Body& body, std::string_view field, double value) {
  const auto& primitive = dynamic_cast<const PrimitiveGeometry&>(*body.geometry);
  std::vector<double> dimensions = primitive.dimensions();
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    if (primitive.description().dimensions[i].id == field) dimensions[i] = value;
  }
  auto changed = PrimitiveGeometry::make(primitive.primitive(), std::move(dimensions));
  if (!changed) return changed.error();
  body.geometry = std::move(changed).value();
  return Done{};
}

// value: of the type of the property, and within its range.
Status setField(Body& body, const std::string& id, std::string_view field, const PropertyValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    if (setPoseField(body, field, *number)) return Done{};
    return setDimension(body, field, *number);
  }
  if (field == "visible") body.visible = std::get<bool>(value);
  if (field == "smooth") body.look.smooth = std::get<bool>(value);
  if (field == "name") body.name = std::get<std::string>(value);
  if (field == "colour") {
    const auto colour = colourFrom(std::get<std::string>(value));
    if (!colour) return Error{ErrorCode::ElementMalformed, {id, "a colour such as #b8bcc7 was expected"}, {}, {}};
    body.look.colour = *colour;
  }
  return Done{};
}

std::string shownNumber(const Property& property, double value) {
  return roundedText(property.quantity == Quantity::Angle ? value / kRadiansPerDegree : value);
}

Status checkProperty(const Property& property, const PropertyValue& value) {
  if (!property.editable) return Error{ErrorCode::Unsupported, {"setting " + property.id}, {}, {}};
  if (value.index() != property.value.index()) {
    const char* const expected = std::holds_alternative<double>(property.value) ? "a number was expected"
                                 : std::holds_alternative<bool>(property.value) ? "yes or no was expected"
                                                                                : "a text was expected";
    return Error{ErrorCode::ElementMalformed, {property.id, expected}, {}, {}};
  }
  const auto* number = std::get_if<double>(&value);
  if (!number || (*number >= property.least && *number <= property.largest)) return Done{};
  return Error{ErrorCode::ValueOutOfRange,
               {property.id, shownNumber(property, *number), shownNumber(property, property.least),
                shownNumber(property, property.largest)},
               {},
               {}};
}

}  // namespace

std::vector<Property> propertiesOf(const Body& body) {
  PropertiesOfBody all(body);
  all.add("name", QT_TRANSLATE_NOOP("Property", "Name"), body.name);
  addPose(body.pose, all);
  addShape(*body.geometry, all);
  all.add("visible", QT_TRANSLATE_NOOP("Property", "Visible"), body.visible);
  all.add("colour", QT_TRANSLATE_NOOP("Property", "Colour"), colourText(body.look.colour));
  all.add("smooth", QT_TRANSLATE_NOOP("Property", "Smooth shading"), body.look.smooth);
  if (body.link) {
    all.addToRead("link", QT_TRANSLATE_NOOP("Property", "Linked file"), body.link->path);
    all.addToRead("link_state", QT_TRANSLATE_NOOP("Property", "State of the file"), nameOf(body.link->state)).problem =
        linkProblem(body.link->state);
  }
  return all.take();
}

std::vector<Property> bodyProperties(const BodySet& bodies) {
  std::vector<Property> all;
  for (const BodyPointer& body : bodies) {
    for (Property& property : propertiesOf(*body)) all.push_back(std::move(property));
  }
  return all;
}

std::optional<BodyId> bodyOfProperty(std::string_view id) {
  if (!id.starts_with(kBodyPrefix)) return std::nullopt;
  id.remove_prefix(kBodyPrefix.size());
  BodyId number = 0;
  const auto [stop, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  if (error != std::errc() || stop == id.data() + id.size() || *stop != '.') return std::nullopt;
  return number;
}

Result<std::unique_ptr<Edit>> bodyPropertyEdit(const BodySet& bodies, const std::string& id,
                                               const PropertyValue& value) {
  const auto number = bodyOfProperty(id);
  const BodyPointer body = number ? bodies.withId(*number) : nullptr;
  const std::vector<Property> all = body ? propertiesOf(*body) : std::vector<Property>();
  const auto property = std::find_if(all.begin(), all.end(), [&](const Property& each) { return each.id == id; });
  if (property == all.end()) return Error{ErrorCode::ReferenceMissing, {"the property", id}, {}, {}};
  if (const Status checked = checkProperty(*property, value); !checked) return checked.error();
  if (property->value == value) return std::unique_ptr<Edit>();
  Body changed = *body;
  const std::string field = id.substr(id.rfind('.') + 1);
  if (const Status done = setField(changed, id, field, value); !done) return done.error();
  return changeBodyEdit(bodies, std::move(changed));
}

}  // namespace handwheel
