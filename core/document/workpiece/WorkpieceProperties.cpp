// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceProperties.h"

#include "base/Utf8.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/force/WorkMaterials.h"

#include <QCoreApplication>
#include <QString>
#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kLongestMaterial = 1000;  // bytes

Property stockProperty(const char* id, const char* label, PropertyValue value) {
  Property property;
  property.id = id;
  property.group = QT_TRANSLATE_NOOP("Property", "Stock");
  property.label = label;
  property.value = std::move(value);
  return property;
}

Property length(const char* id, const char* label, double value, double least, double largest) {
  Property property = stockProperty(id, label, value);
  property.quantity = Quantity::Length;
  property.least = least;
  property.largest = largest;
  return property;
}

Property computed(const char* id, const char* label, double value) {
  Property property = stockProperty(id, label, value);
  property.editable = false;
  return property;
}

// Any text may be entered. Cutting forces are known for the choices.
Property materialProperty(const std::string& name) {
  Property material = stockProperty("material", QT_TRANSLATE_NOOP("Property", "Material"), name);
  for (const WorkMaterial& each : WorkMaterials::standard().all()) material.choices.push_back(each.name);
  if (!name.empty() && !WorkMaterials::standard().named(name))
    material.problem = QT_TRANSLATE_NOOP("Property", "no known material: forces are those of a medium carbon steel");
  return material;
}

std::string text(double value) {
  return QString::number(value).toStdString();
}

Error malformed(const std::string& id, const char* expected) {
  return {ErrorCode::ElementMalformed, {id, expected}, {}, {}};
}

}  // namespace

Property propertyOf(const WorkpieceSnapshot& workpiece, WorkpieceField field) {
  const StockCylinder& stock = workpiece.stock;
  switch (field) {
    case WorkpieceField::Diameter: {
      Property diameter = length("diameter", QT_TRANSLATE_NOOP("Property", "Diameter"), stock.diameter,
                                 StockCylinder::kLeastSize, StockCylinder::kLargestSize);
      diameter.prefix = "⌀";
      return diameter;
    }
    case WorkpieceField::Length:
      return length("length", QT_TRANSLATE_NOOP("Property", "Length"), stock.length, StockCylinder::kLeastSize,
                    StockCylinder::kLargestSize);
    case WorkpieceField::Position:
      return length("position", QT_TRANSLATE_NOOP("Property", "Lower end at Z"), stock.position,
                    -StockCylinder::kFurthest, StockCylinder::kFurthest);
    case WorkpieceField::Chord:
      return length("chord", QT_TRANSLATE_NOOP("Property", "Chord tolerance"), workpiece.chord,
                    WorkpieceSnapshot::kLeastChord, WorkpieceSnapshot::kLargestChord);
    case WorkpieceField::Material:
      break;
  }
  return materialProperty(workpiece.material);
}

std::optional<WorkpieceField> fieldNamed(std::string_view id) {
  static const WorkpieceSnapshot any;
  for (WorkpieceField field : kWorkpieceFields) {
    if (propertyOf(any, field).id == id) return field;
  }
  return std::nullopt;
}

Status checkValue(WorkpieceField field, const PropertyValue& value) {
  static const WorkpieceSnapshot any;
  const Property property = propertyOf(any, field);
  if (field == WorkpieceField::Material) {
    const auto* name = std::get_if<std::string>(&value);
    if (!name || name->size() > kLongestMaterial || !isUtf8(*name)) {
      return malformed(property.id, "a text of at most 1000 bytes in UTF-8 was expected");
    }
    return Done{};
  }
  const auto* number = std::get_if<double>(&value);
  if (!number) return malformed(property.id, "a number was expected");
  if (!(*number >= property.least && *number <= property.largest)) {
    return Error{
        ErrorCode::ValueOutOfRange, {property.id, text(*number), text(property.least), text(property.largest)}, {}, {}};
  }
  return Done{};
}

std::string materialInWords(const std::string& name) {
  const auto& all = WorkMaterials::standard().all();
  const bool isKnown = std::any_of(all.begin(), all.end(), [&](const WorkMaterial& each) { return each.name == name; });
  return isKnown ? QCoreApplication::translate("Property", name.c_str()).toStdString() : name;
}

std::string materialOfWords(const std::string& words) {
  for (const WorkMaterial& each : WorkMaterials::standard().all())
    if (materialInWords(each.name) == words) return each.name;
  return words;
}

bool isOfTheBar(WorkpieceField field) {
  return field == WorkpieceField::Diameter || field == WorkpieceField::Length;
}

bool isOfAnExercise(WorkpieceField field) {
  return field != WorkpieceField::Chord;
}

WorkpieceSnapshot withValue(WorkpieceSnapshot workpiece, WorkpieceField field, const PropertyValue& value) {
  switch (field) {
    case WorkpieceField::Diameter:
      workpiece.stock.diameter = std::get<double>(value);
      break;
    case WorkpieceField::Length:
      workpiece.stock.length = std::get<double>(value);
      break;
    case WorkpieceField::Position:
      workpiece.stock.position = std::get<double>(value);
      break;
    case WorkpieceField::Chord:
      workpiece.chord = std::get<double>(value);
      break;
    case WorkpieceField::Material:
      workpiece.material = std::get<std::string>(value);
      break;
  }
  if (workpiece.part && field == WorkpieceField::Chord) {
    const TurnedPart& part = *workpiece.part;
    TurnedPart meshed = TurnedPart::of(part.profile, part.passes, workpiece.chord);
    meshed.finish = part.finish;
    workpiece.part = std::make_shared<const TurnedPart>(std::move(meshed));
  }
  if (!workpiece.mesh->isOf(workpiece.stock, workpiece.chord)) {
    workpiece.mesh = std::make_shared<const StockMesh>(workpiece.stock, workpiece.chord);
  }
  return workpiece;
}

std::vector<Property> workpieceProperties(const WorkpieceSnapshot& workpiece) {
  std::vector<Property> all;
  for (WorkpieceField field : kWorkpieceFields) {
    all.push_back(propertyOf(workpiece, field));
    all.back().editable = !workpiece.part || !isOfTheBar(field);
  }
  if (workpiece.target)
    for (Property& each : positionProperties(workpiece.target->profile, workpiece.stock))
      all.push_back(std::move(each));
  // The window does not wait for the section of a pass by hand.
  const bool isKnown = workpiece.part && workpiece.part->profile.section()->isKnown();
  const double volume = isKnown          ? workpiece.part->volume()
                        : workpiece.part ? workpiece.part->volumeOfSamples()
                                         : workpiece.stock.volume();
  const double area = workpiece.part ? workpiece.part->profile.area() : workpiece.stock.area();
  const auto pieces = isKnown ? workpiece.part->section().pieces() : std::vector<TurnedSection>();
  if (pieces.size() > 1) {
    const TurnedPart& part = *workpiece.part;
    all.push_back(computed("volume", QT_TRANSLATE_NOOP("Property", "Volume that stays in the chuck (mm³)"),
                           part.volumeOf(pieces.front())));
    all.push_back(computed("parted_volume", QT_TRANSLATE_NOOP("Property", "Volume parted off (mm³)"),
                           part.volumeOf(pieces.back())));
    all.push_back(computed("parted_length", QT_TRANSLATE_NOOP("Property", "Length parted off (mm)"),
                           pieces.back().box().sizes().y()));
  } else {
    all.push_back(computed("volume", QT_TRANSLATE_NOOP("Property", "Volume (mm³)"), volume));
  }
  all.push_back(computed("area", QT_TRANSLATE_NOOP("Property", "Surface (mm²)"), area));
  if (workpiece.part) {
    const auto count = static_cast<double>(workpiece.part->passes.size());
    all.push_back(computed("passes", QT_TRANSLATE_NOOP("Property", "Passes"), count));
  }
  return all;
}

}  // namespace handwheel
