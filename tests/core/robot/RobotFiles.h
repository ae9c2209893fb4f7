// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/UrdfReader.h"

#include <QFile>
#include <QString>

// Descriptions of real robots. They are not part of the sources, but lie in the folder "robots" of the directory that
// the environment variable HANDWHEEL_DATA names.
namespace handwheel::test {

inline QString robotsFolder() {
  return qEnvironmentVariable("HANDWHEEL_DATA") + "/robots";
}

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline RobotModel robotIn(const char* path) {
  Result<ImportedRobot> read = readUrdf(bytesOf(robotsFolder() + '/' + path).toStdString());
  return read ? read->robot : RobotModel{};
}

inline const char* const kIrb120 = "abb_irb120/abb_irb120_support/urdf/irb120_3_58.urdf";
inline const char* const kIrb2400 = "abb_irb2400/abb_irb2400_support/urdf/irb2400.urdf";
inline const char* const kLrMate = "fanuc_lrmate200id/fanuc_lrmate200id_support/urdf/lrmate200id.urdf";
inline const char* const kAgilus = "kuka_kr6r900_2/kuka_kr6_support/urdf/kr6r900_2.urdf";
inline const char* const kPanda = "panda/panda.urdf";
inline const char* const kUr5 = "ur5/ur_description/urdf/ur5.urdf";
inline const char* const kPuma = "puma560/puma560_description/urdf/puma560_robot.urdf";

}  // namespace handwheel::test
