// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "robot/MeshLocation.h"

#include <sys/stat.h>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;

namespace {

namespace fs = std::filesystem;

void makeFile(const fs::path& path) {
  fs::create_directories(path.parent_path());
  QFile file(path.c_str());
  QVERIFY(file.open(QIODevice::WriteOnly));
}

}  // namespace

class MeshLocationTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void packages();
  void missingPackages();
  void nearestPackageWins();
  void packagesAreNotLeft();
  void relativeNames();
  void addresses();
  void onlyFiles();

 private:
  bool finds(std::string_view name, const char* path) const {
    const auto found = locateMesh(name, m_root / "ws/arm/urdf");
    return found && fs::equivalent(*found, m_root / path);
  }
  ErrorCode codeOf(std::string_view name) const {
    const auto found = locateMesh(name, m_root / "ws/arm/urdf");
    return found ? ErrorCode::Cancelled : found.error().code;
  }

  std::unique_ptr<QTemporaryDir> m_folder;
  fs::path m_root;
};

void MeshLocationTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  m_root = m_folder->path().toStdString();
  for (const char* path : {"ws/arm/urdf/robot.urdf", "ws/arm/meshes/a.stl", "ws/hand/meshes/b.stl", "out.stl",
                           "ws/arm/urdf/here.stl", "ws/arm/with space.stl"})
    makeFile(m_root / path);
}

void MeshLocationTest::packages() {
  QVERIFY(finds("package://arm/meshes/a.stl", "ws/arm/meshes/a.stl"));    // a folder above
  QVERIFY(finds("package://hand/meshes/b.stl", "ws/hand/meshes/b.stl"));  // beside one above
  QVERIFY(finds("package://meshes/a.stl", "ws/arm/meshes/a.stl"));        // a folder as if it were a package
  QVERIFY(finds("model://arm/meshes/a.stl", "ws/arm/meshes/a.stl"));
  QVERIFY(finds("package://arm/meshes/../meshes/./a.stl", "ws/arm/meshes/a.stl"));
  QCOMPARE(codeOf("package://arm/meshes/none.stl"), ErrorCode::ReferenceMissing);
  QCOMPARE(codeOf("package://none/meshes/a.stl"), ErrorCode::ReferenceMissing);
}

// An existing package lacks a mesh; a missing one is reported with the folder at which the search began.
void MeshLocationTest::missingPackages() {
  const auto argumentsOf = [&](std::string_view name) {
    return locateMesh(name, m_root / "ws/arm/urdf").error().arguments;
  };
  QCOMPARE(argumentsOf("package://hand/meshes/none.stl"),
           (std::vector<std::string>{"the mesh", "package://hand/meshes/none.stl"}));
  const std::vector<std::string> package{"the package", "none", (m_root / "ws/arm/urdf").string()};
  QCOMPARE(argumentsOf("package://none/meshes/a.stl"), package);
  QCOMPARE(argumentsOf("model://none/b.stl"), package);
}

void MeshLocationTest::nearestPackageWins() {
  makeFile(m_root / "ws/arm/urdf/arm/meshes/a.stl");
  QVERIFY(finds("package://arm/meshes/a.stl", "ws/arm/urdf/arm/meshes/a.stl"));
}

void MeshLocationTest::packagesAreNotLeft() {
  for (const char* name : {"package://arm/../hand/meshes/b.stl", "package://../out.stl", "package://./a.stl",
                           "package:///etc/hostname", "package://arm//etc/hostname", "package://"})
    QCOMPARE(codeOf(name), ErrorCode::Unsupported);
}

void MeshLocationTest::relativeNames() {
  QVERIFY(finds("here.stl", "ws/arm/urdf/here.stl"));
  QVERIFY(finds("../meshes/a.stl", "ws/arm/meshes/a.stl"));
  QVERIFY(finds("../../../out.stl", "out.stl"));
  QCOMPARE(codeOf("../../../../../out.stl"), ErrorCode::Unsupported);
  QCOMPARE(codeOf("a/../../../../../../out.stl"), ErrorCode::Unsupported);
  QCOMPARE(codeOf("none.stl"), ErrorCode::ReferenceMissing);
  // The folder's name may be relative, or end in a slash.
  const fs::path before = fs::current_path();
  fs::current_path(m_root / "ws/arm");
  const bool relative = locateMesh("package://hand/meshes/b.stl", "urdf/").hasValue();
  fs::current_path(before);
  QVERIFY(relative);
}

void MeshLocationTest::addresses() {
  const std::string root = m_root.string();
  QVERIFY(finds("file://" + root + "/out.stl", "out.stl"));
  QVERIFY(finds("file://" + root + "/ws/arm/with%20space.stl", "ws/arm/with space.stl"));
  QVERIFY(finds(root + "/out.stl", "out.stl"));
  QCOMPARE(codeOf("file://" + root + "/none%zz%2"), ErrorCode::ReferenceMissing);
  QCOMPARE(codeOf("file://host/out.stl"), ErrorCode::Unsupported);
  QCOMPARE(codeOf("http://host/out.stl"), ErrorCode::Unsupported);
}

void MeshLocationTest::onlyFiles() {
  QCOMPARE(codeOf("../meshes"), ErrorCode::ReferenceMissing);
  QCOMPARE(codeOf(""), ErrorCode::ReferenceMissing);
  QCOMPARE(codeOf(std::string_view("a\0b.stl", 7)), ErrorCode::ReferenceMissing);
  QCOMPARE(::mkfifo((m_root / "ws/arm/urdf/pipe.stl").c_str(), 0600), 0);  // reading it would never end
  QCOMPARE(codeOf("pipe.stl"), ErrorCode::ReferenceMissing);
}

HANDWHEEL_TEST(MeshLocationTest)
#include "MeshLocationTest.moc"
