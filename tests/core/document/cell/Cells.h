// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/cell/CellImport.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/RobotCellKind.h"
#include "document/formats/MeshFormat.h"
#include "robot/ShapeSurfaces.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <memory>
#include <stdexcept>

namespace handwheel::test {

inline void write(const QString& path, const std::string& bytes) {
  QDir().mkpath(QFileInfo(path).path());
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), qint64(bytes.size())) != qint64(bytes.size()))
    throw std::runtime_error("not written");
}

// The URDF of a small test arm. A slide moves along x (0 to 1 m) and carries an arm that turns about z (±2 rad). A claw
// follows the arm, and the tool is 0.5 m from the axis of the arm. The foot is a box; the arm is a mesh of 0.5 m × 0.1
// m × 0.1 m from a file.
inline const std::string kArmUrdf = R"(<robot name='arm'>
  <link name='foot'><visual><geometry><box size='0.2 0.2 0.1'/></geometry></visual></link>
  <link name='sledge'/>
  <link name='upper'><visual><origin xyz='0.25 0 0'/><geometry><mesh filename='package://arm/meshes/upper.stl'/></geometry>
    <material name='m'><color rgba='1 0 0 1'/></material></visual>
    <collision><geometry><mesh filename='package://arm/meshes/upper.stl'/></geometry></collision></link>
  <link name='claw'/><link name='tool0'/>
  <joint name='slide' type='prismatic'><parent link='foot'/><child link='sledge'/><axis xyz='1 0 0'/>
    <limit lower='0' upper='1' velocity='0.5' effort='100'/></joint>
  <joint name='turn' type='revolute'><parent link='sledge'/><child link='upper'/><axis xyz='0 0 1'/>
    <limit lower='-2' upper='2' velocity='1' effort='0'/></joint>
  <joint name='close' type='revolute'><parent link='upper'/><child link='claw'/><axis xyz='0 0 1'/>
    <limit lower='-2' upper='2' velocity='1' effort='1'/><mimic joint='turn' multiplier='0.5'/></joint>
  <joint name='end' type='fixed'><parent link='upper'/><child link='tool0'/><origin xyz='0.5 0 0'/></joint>
</robot>)";

// A package of files on disk with the test arm and its mesh.
class ArmPackage {
 public:
  ArmPackage() {
    write(urdf(), kArmUrdf);
    write(mesh(), writeMesh(surfaceOf(BoxShape{{0.5, 0.1, 0.1}}), MeshFormat::Stl, NumberType::Float32));
  }
  QString urdf() const { return m_folder.path() + "/arm/urdf/arm.urdf"; }
  QString mesh() const { return m_folder.path() + "/arm/meshes/upper.stl"; }
  QString path(const QString& name) const { return m_folder.path() + '/' + name; }

 private:
  QTemporaryDir m_folder;
};

inline const RobotCellKind kKind;

inline OpenedFile importOrThrow(const QString& path) {
  Result<OpenedFile> opened = kKind.import(path.toStdString(), {}, {});
  if (!opened) throw std::runtime_error("not opened: error " + std::string(opened.error().code->id));
  return std::move(opened).value();
}

inline const RobotCellSnapshot& cellIn(const OpenedFile& opened) {
  return static_cast<const RobotCellSnapshot&>(*opened.content);
}

inline JointValues values(std::initializer_list<double> list) {
  JointValues v(Eigen::Index(list.size()));
  std::copy(list.begin(), list.end(), v.begin());
  return v;
}

inline std::shared_ptr<RobotCellSnapshot> withJoints(const RobotCellSnapshot& cell, const JointValues& joints) {
  auto moved = std::make_shared<RobotCellSnapshot>(cell);
  moved->joints = joints;
  return moved;
}

inline Container saved(const Snapshot& content) {
  Container container;
  kKind.save(content, container);
  return container;
}

inline std::shared_ptr<const RobotCellSnapshot> loaded(const Container& container, std::vector<Error>& damage) {
  Result<SnapshotPointer> content = kKind.load(container, damage, {});
  return content ? std::static_pointer_cast<const RobotCellSnapshot>(*content) : nullptr;
}

inline Box boxOf(const TriangleSoup& soup) {
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  return box;
}

// Returns true if each corner of the box is nearer to the given one than the tolerance (mm).
inline bool isNear(const Box& box, const Vec3& min, const Vec3& max, double tolerance = 1e-4) {
  return (box.min() - min).norm() < tolerance && (box.max() - max).norm() < tolerance;
}

}  // namespace handwheel::test
