// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/ForceOperations.h"

#include <QtGlobal>
#include <numbers>

namespace handwheel {

namespace {

// A number with a default.
Parameter numberParameter(const char* id, const char* word, double value, double least, double largest,
                          std::string meaning, Quantity quantity = Quantity::Number) {
  return {.property = {.id = id,
                       .group = {},
                       .label = {},
                       .value = value,
                       .quantity = quantity,
                       .least = least,
                       .largest = largest},
          .meaning = std::move(meaning),
          .word = word};
}

// A number that means something else where it is not given.
Parameter openParameter(const char* id, const char* word, double least, double largest, std::string meaning,
                        Quantity quantity = Quantity::Number) {
  Parameter parameter = numberParameter(id, word, 0.0, least, largest, std::move(meaning), quantity);
  parameter.hasDefault = false;
  return parameter;
}

Parameter wholeParameter(const char* id, const char* word, double value, double least, double largest,
                         std::string meaning) {
  Parameter parameter = numberParameter(id, word, value, least, largest, std::move(meaning));
  parameter.isWhole = true;
  return parameter;
}

Parameter textParameter(const char* id, const char* word, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = word,
          .hasDefault = false};
}

Parameter trainerParameter() {
  return {
      .property = {.id = "trainer",
                   .group = {},
                   .label = QT_TRANSLATE_NOOP("Property", "Trainer"),
                   .value = 0.0,
                   .choices = {QT_TRANSLATE_NOOP("Property", "Levenberg-Marquardt"),
                               QT_TRANSLATE_NOOP("Property", "BFGS"),
                               QT_TRANSLATE_NOOP("Property", "Scaled conjugate gradient"),
                               QT_TRANSLATE_NOOP("Property", "Gradient descent with momentum"),
                               QT_TRANSLATE_NOOP("Property", "Gradient descent")}},  // in the order of NetworkTrainer
      .meaning = "How the network is trained",
      .word = "NAME",
      .words = {"lm", "bfgs", "scg", "gdm", "gd"}};
}

Parameter thrustParameter() {
  return {.property = {.id = "thrust",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Feed and radial force"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "By depth and nose"),
                                   QT_TRANSLATE_NOOP("Property", "Constant share"),
                                   QT_TRANSLATE_NOOP("Property", "Laws of the table")}},  // in the order of ThrustLaw
          .meaning = "Feed and radial force: by depth and nose, a constant share, or the table's own laws",
          .word = "LAW",
          .words = {"depth", "constant", "table"}};
}

Parameter toolParameter() {
  return {.property = {.id = "tool",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Tool material"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Carbide"),
                                   QT_TRANSLATE_NOOP("Property", "High-speed steel")}},  // in the order of ToolMaterial
          .meaning = "Material of the tool",
          .word = "NAME",
          .words = {"carbide", "hss"}};
}

constexpr double kRightAngle = 0.5 * std::numbers::pi;

}  // namespace

const Operation& trainOperation() {
  static const Operation operation = {
      .id = "train",
      .title = QT_TRANSLATE_NOOP("Tool", "Train a force model"),
      .meaning = "Train a model of cutting forces",
      .operands = "DATA",
      .parameters = {
          trainerParameter(),
          wholeParameter("hidden", "N", 4, 1, ForceNetwork::kMostHidden, "Neurons of the hidden layer"),
          numberParameter("goal", "MSE", 1e-3, 0.0, 1.0, "Stop at this mean squared error, in units of the range"),
          wholeParameter("seed", "N", 1, 0, 1e9, "Choose first weights and held-out cuts by this number"),
          wholeParameter("epochs", "N", 0, 0, 1e6,
                         "Stop after this number of epochs; 0: the usual number of the trainer"),
          openParameter("diameter", "MM", 1e-3, 1e5, "Diameter of the work, for tables with r/min only",
                        Quantity::Length),
      }};
  return operation;
}

TrainingOptions trainingOptionsOf(const OperationValues& values) {
  TrainingOptions options;
  options.trainer = static_cast<NetworkTrainer>(values.whole("trainer"));
  options.hidden = values.whole("hidden");
  options.goal = values.number("goal");
  options.seed = values.whole("seed");
  options.epochs = values.whole("epochs");
  return options;
}

const Operation& forceOperation() {
  static const Operation operation = {
      .id = "force",
      .title = QT_TRANSLATE_NOOP("Tool", "Cutting force"),
      .meaning = "Calculate the forces of a cut",
      .parameters = {
          textParameter("material", "M", "Work material, by its id; --list names them"),
          openParameter("depth", "MM", 0.0, kMostDepth, "Depth of cut", Quantity::Length),
          openParameter("feed", "MM", 0.0, kMostFeed, "Feed per revolution", Quantity::Length),
          openParameter("speed", "M/MIN", 0.0, kLargestSpeed, "Cutting speed, in metres per minute"),
          toolParameter(),
          openParameter("approach", "DEGREES", 5.0 * kRadiansPerDegree, 145.0 * kRadiansPerDegree,
                        "Angle between edge and feed (default: that of each table)", Quantity::Angle),
          openParameter("rake", "DEGREES", -kRightAngle, kRightAngle, "Rake angle (default: that of each table)",
                        Quantity::Angle),
          openParameter("inclination", "DEGREES", -kRightAngle, kRightAngle,
                        "Inclination of the edge (default: that of each table)", Quantity::Angle),
          openParameter("nose", "MM", 0.0, 100.0, "Nose radius (default: that of each table)", Quantity::Length),
          openParameter("strength", "MPA", 1.0, 1e4, "Tensile strength of the work, for Kosilova's law"),
          numberParameter("wear", "MM", 0.0, 0.0, CuttingFeel::kMostWear, "Flank wear of the tool", Quantity::Length),
          thrustParameter(),
          openParameter("diameter", "MM", 1e-3, 1e5, "Diameter of the work, for torque and bending", Quantity::Length),
          openParameter("length", "MM", 1e-3, 1e6, "Length of the work out of the chuck, cut at its end",
                        Quantity::Length),
          {.property = {.id = "tailstock", .group = {}, .label = {}, .value = false},
           .meaning = "A centre supports the end; the cut is in the middle"},
          numberParameter("motor", "KW", SpindleDrive().power, 1e-3, 1e4, "Power of the motor"),
          numberParameter("torque", "NM", SpindleDrive().torque, 1e-3, 1e6, "Torque at the spindle"),
          numberParameter("efficiency", "SHARE", SpindleDrive().efficiency, 0.01, 1.0, "Efficiency of the drive"),
      }};
  return operation;
}

std::string problemOfForceValues(const OperationValues& values) {
  for (const char* id : {"material", "depth", "feed", "speed"})
    if (!values.isSet(id)) return std::string("the option --") + id + " is missing";
  for (const char* id : {"length", "tailstock"})
    if (values.isSet(id) && !values.isSet("diameter"))
      return std::string("--") + id + " is only possible with --diameter";
  if (values.isSet("tailstock") && !values.isSet("length")) return "--tailstock is only possible with --length";
  return {};
}

CutConditions cutOf(const OperationValues& values) {
  return {*values.given("depth"), *values.given("feed"), *values.given("speed")};
}

CuttingEdge edgeOf(const OperationValues& values) {
  return {static_cast<ToolMaterial>(values.whole("tool")), values.given("approach"), values.given("rake"),
          values.given("inclination"), values.given("nose")};
}

ThrustSettings thrustOf(const OperationValues& values) {
  ThrustSettings settings;
  settings.law = static_cast<ThrustLaw>(values.whole("thrust"));
  return settings;
}

std::optional<SlenderWork> slenderWorkOf(const OperationValues& values) {
  if (!values.isSet("diameter") || !values.isSet("length")) return std::nullopt;
  SlenderWork work;
  work.diameter = *values.given("diameter");
  work.length = *values.given("length");
  work.hasTailstock = values.flag("tailstock");
  work.position = work.hasTailstock ? 0.5 * work.length : work.length;
  return work;
}

SpindleDrive driveOf(const OperationValues& values) {
  return {values.number("motor"), values.number("torque"), values.number("efficiency")};
}

}  // namespace handwheel
