// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CancelPoints.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshBlobs.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

// Runs the work, which says whether it came to its end, and then cancels it at each of its cancel points. Some may lie
// behind the last look; where it came to its end in spite of them, it has done all of it.
void cancelEverywhere(const std::function<bool(Progress)>& work, const std::function<bool(bool isDone)>& isRight) {
  std::size_t allocations = 0, cancelled = 0;
  {
    test::CancelPoint never;
    const bool isDone = work(never.progress());
    allocations = never.allocations();
    QVERIFY(isDone && never.isMonotone());
  }
  QVERIFY(isRight(true));
  const std::vector<std::size_t> points = test::cancelPoints(allocations);
  for (std::size_t n : points) {
    bool isDone = false, isMonotone = false;
    {
      test::CancelPoint point(n);
      isDone = work(point.progress());
      isMonotone = point.isMonotone();
    }
    cancelled += !isDone;
    QVERIFY(isMonotone);
    QVERIFY2(isRight(isDone), qPrintable(QString("at allocation %1 of %2").arg(n).arg(allocations)));
  }
  QVERIFY2(2 * cancelled >= points.size(), qPrintable(QString("%1 of %2").arg(cancelled).arg(points.size())));
}

template <class Value>
bool isDoneOrCancelled(const Result<Value>& result) {
  return result || result.error().code == ErrorCode::Cancelled;
}

}  // namespace

class MeshCancellingTest : public QObject {
  Q_OBJECT

  const TriangleSoup m_soup = test::torus(190, 180);  // 34,200 points and 68,400 triangles: looks within the loops
  const HalfEdgeMesh m_mesh = buildMesh(m_soup).mesh;

  void formats() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "a.3mf"}) QTest::newRow(name) << name;
  }

 private slots:
  void writing_data() { formats(); }
  void writing() {
    QFETCH(QString, name);
    const MeshFormat format = *formatForName(name.toStdString());
    const std::string whole = writeMesh(m_soup, format, NumberType::Float64);
    std::string bytes;
    const auto write = [&](Progress progress) {
      bytes = writeMesh(m_soup, format, NumberType::Float64, progress);
      return !bytes.empty();
    };
    cancelEverywhere(write, [&](bool isDone) { return bytes == (isDone ? whole : std::string()); });
  }

  void reading_data() { formats(); }
  void reading() {
    QFETCH(QString, name);
    const std::string bytes = writeMesh(m_soup, *formatForName(name.toStdString()), NumberType::Float64);
    Result<MeshFile> file = Error{};
    const auto read = [&](Progress progress) {
      file = readMesh(bytes, name.toStdString(), {}, progress);
      return file.hasValue();
    };
    cancelEverywhere(read, [&](bool isDone) {
      return isDoneOrCancelled(file) && (!isDone || file->soup.triangles.size() == m_soup.triangles.size());
    });
  }

  void saving_data() { formats(); }
  void saving() {
    QFETCH(QString, name);
    const QTemporaryDir folder;
    const QString path = folder.filePath(name);
    Result<ExportReport> report = Error{};
    const auto save = [&](Progress progress) {
      QFile::remove(path);
      report = exportMesh(m_mesh, NumberType::Float64, path.toStdString(), progress);
      return report.hasValue();
    };
    cancelEverywhere(save, [&](bool isDone) { return isDoneOrCancelled(report) && QFile::exists(path) == isDone; });
  }

  void loadingBlobs() {
    Container container;
    writeMeshBlobs(m_mesh, container);
    const nlohmann::json document = (*container.manifest)["document"];
    Container damaged = container;
    damaged.blobs.erase("mesh/faces/0000");
    for (const Container& from : {container, damaged}) {
      Result<LoadedMesh> loaded = Error{};
      const auto load = [&](Progress progress) {
        std::vector<Error> damage;
        loaded = readMeshBlobs(document, from, damage, progress);
        return loaded.hasValue();
      };
      const bool isWhole = from.blobs.size() == container.blobs.size();
      cancelEverywhere(load, [&](bool isDone) {
        return isDoneOrCancelled(loaded) &&
               (!isDone || (isWhole ? test::sameMesh(loaded->mesh, m_mesh) : loaded->mesh.faceSlots() > 0));
      });
    }
  }
};

HANDWHEEL_TEST(MeshCancellingTest)
#include "MeshCancellingTest.moc"
