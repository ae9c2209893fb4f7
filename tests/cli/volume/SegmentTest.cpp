// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "MadeDicom.h"
#include "TestClass.h"

#include <QDir>
#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

// A MetaImage of two balls of 1000 in 0, with radius 8 and 3 mm, the value falling linearly over a step of samples.
void putBalls(const Fixture& fixture, const char* ending) {
  constexpr int kSize = 48;
  QByteArray samples;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double depth = std::max(8.0 - std::hypot(std::hypot(x - 15.0, y - 20.0), z - 24.0),
                                      3.0 - std::hypot(std::hypot(x - 36.0, y - 20.0), z - 24.0));
        const auto value = static_cast<std::int16_t>(500.0 * std::clamp(depth, -1.0, 1.0) + 500.0);
        samples.append(reinterpret_cast<const char*>(&value), 2);
      }
  const QByteArray head =
      "ObjectType = Image\nNDims = 3\nDimSize = 48 48 48\nElementSpacing = 1 1 1\n"
      "ElementType = MET_SHORT\nElementDataFile = ";
  if (QByteArray(ending) == "mha") {
    fixture.put("balls.mha", head + "LOCAL\n" + samples);
  } else {
    fixture.put("balls.mhd", head + "balls.raw\n");
    fixture.put("balls.raw", samples);
  }
}

constexpr double kBallVolume = 4.0 / 3.0 * M_PI;  // for radius 1

nlohmann::json figuresIn(const QByteArray& out) {
  return nlohmann::json::parse(out.toStdString());
}

// A made-up head in slices: a ball of 1000 in air, as above; the folder has the name of the patient.
void putSeries(const Fixture& fixture) {
  test::MadeSlice slice;
  slice.width = slice.height = 40;
  slice.spacing = 1.0;
  slice.syntax = gdcm::TransferSyntax::JPEGLosslessProcess14_1;
  slice.value = [](const Vec3& p) {
    return std::round(1000.0 * std::clamp(12.0 - (p - Vec3(20, 20, 0)).norm(), -1.0, 1.0));
  };
  QDir(fixture.path()).mkdir("Erika");
  for (int i = 0; i < 16; ++i) {
    if (i == 5) continue;
    slice.origin.z() = 2.0 * i - 16.0;
    const std::string bytes = test::dicomOf(slice);
    fixture.put(QString("Erika/%1").arg(i), QByteArray(bytes.data(), static_cast<int>(bytes.size())));
  }
}

}  // namespace

class SegmentTest : public QObject {
  Q_OBJECT

 private slots:
  void aMesh_data() {
    QTest::addColumn<QByteArray>("ending");
    QTest::newRow("one file") << QByteArray("mha");
    QTest::newRow("two files") << QByteArray("mhd");
  }
  void aMesh() {
    QFETCH(QByteArray, ending);
    const Fixture fixture;
    putBalls(fixture, ending.constData());
    const Ran ran =
        fixture.run({"segment", "balls." + ending, "-o", "a.stl", "--range", "500:", "--json"}, "de_DE.UTF-8");
    QCOMPARE(ran.err, QByteArray());
    QCOMPARE(ran.code, 0);
    const auto figures = figuresIn(ran.out);
    QCOMPARE(figures["components"].get<int>(), 2);
    QCOMPARE(figures["components_kept"].get<int>(), 2);
    QCOMPARE(figures["spacing_mm"].get<std::vector<double>>(), (std::vector<double>{1, 1, 1}));
    QVERIFY(figures["warnings"].empty());
    // The voxels are 1 mm³ and count entirely or not at all: those at the surface may be on either side of it.
    const double voxels = figures["voxels"].get<double>(), volume = figures["volume_mm3"].get<double>();
    QCOMPARE(voxels, std::round(voxels));
    QVERIFY2(std::abs(voxels / (kBallVolume * (512.0 + 27.0)) - 1.0) < 0.06, QByteArray::number(voxels));
    QVERIFY2(std::abs(volume / (kBallVolume * (512.0 + 27.0)) - 1.0) < 0.02, QByteArray::number(volume));
    const auto mesh = figuresIn(fixture.run({"inspect", "a.stl", "--json"}).out);
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>() && mesh["oriented"].get<bool>());
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / (kBallVolume * (512.0 + 27.0)) - 1.0) < 0.02);
  }

  void theLargest() {
    const Fixture fixture;
    putBalls(fixture, "mha");
    const Ran ran = fixture.run({"segment", "balls.mha", "-o", "a.handwheel", "--range", "500:2000", "--largest", "1",
                                 "--voxel", "0.5", "--smooth", "--json"});
    QCOMPARE(ran.code, 0);
    const auto figures = figuresIn(ran.out);
    QCOMPARE(figures["components"].get<int>(), 2);
    QCOMPARE(figures["components_kept"].get<int>(), 1);
    QVERIFY(std::abs(figures["volume_mm3"].get<double>() / (kBallVolume * 512.0) - 1.0) < 0.02);
    const auto inspected = figuresIn(fixture.run({"inspect", "a.handwheel", "--json"}).out);
    QCOMPARE(inspected["document"]["voxel"].get<double>(), 0.5);
  }

  // A segmentation of 3D Slicer: its labels keep their names and volumes, and the surface is that of one label. A ball
  // of 251 samples of the label 2 is beside others.
  void labels() {
    const Fixture fixture;
    QByteArray samples(30 * 25 * 20, '\0');
    int counts[4] = {};
    for (int i = 0; i < samples.size(); ++i) {
      const int x = i % 30, y = i / 30 % 25, z = i / 750;
      const int ball = (x - 10) * (x - 10) + (y - 12) * (y - 12) + (z - 10) * (z - 10);
      const bool isBox = x >= 5 && x < 25 && y >= 5 && y < 20 && z >= 5 && z < 15;
      samples[i] = static_cast<char>(ball <= 15 ? 2 : !isBox ? 0 : x < 15 ? 1 : 3);
      ++counts[static_cast<int>(samples[i])];
    }
    QCOMPARE(counts[2], 251);
    fixture.put("bones.seg.nrrd",
                "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 30 25 20\n"
                "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n"
                "Segment0_LabelValue:=1\nSegment0_Name:=femur\nSegment1_LabelValue:=2\nSegment1_Name:=head\n\n" +
                    samples);
    const Ran ran = fixture.run({"segment", "bones.seg.nrrd", "-o", "a.stl", "--range", "2:2", "--json"});
    QCOMPARE(ran.code, 0);
    const auto figures = figuresIn(ran.out);
    QCOMPARE(figures["volume_mm3"].get<double>(), 251.0);
    QCOMPARE(figures["labels"].size(), std::size_t{3});
    for (int k = 0; k < 3; ++k) {
      const auto& label = figures["labels"][static_cast<std::size_t>(k)];
      QCOMPARE(label["value"].get<int>(), k + 1);
      QCOMPARE(label["volume_mm3"].get<double>(), counts[k + 1]);
      QCOMPARE(label["chosen"].get<bool>(), k == 1);
      QCOMPARE(label["name"].get<std::string>(), std::string(k == 0 ? "femur" : k == 1 ? "head" : ""));
    }
    const auto mesh = figuresIn(fixture.run({"inspect", "a.stl", "--json"}).out);
    QVERIFY(mesh["closed"].get<bool>());
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / 251.0 - 1.0) < 0.05);
    const Ran all = fixture.run({"segment", "bones.seg.nrrd", "-o", "a.handwheel"});
    QVERIFY(all.out.contains("values from 1,") && all.out.contains("* label 1 femur: "));
  }

  // Through every file that holds a volume, and back to a mesh: the ball stays.
  void files_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("vdb") << "a.vdb";
    QTest::newRow("nrrd") << "a.nrrd";
  }
  void files() {
    QFETCH(QString, name);
    const Fixture fixture;
    putBalls(fixture, "mha");
    QCOMPARE(fixture.run({"segment", "balls.mha", "-o", name, "--range", "500:", "--largest", "1"}).code, 0);
    const Ran remeshed = fixture.run({"remesh", name, "-o", "b.stl"});
    QCOMPARE(remeshed.err,
             QByteArray("handwheel: The file: closed, manifold, oriented, free of self-intersections, one piece.\n"));
    QCOMPARE(remeshed.code, 0);
    const auto mesh = figuresIn(fixture.run({"inspect", "b.stl", "--json"}).out);
    QVERIFY(std::abs(mesh["volume_mm3"].get<double>() / (kBallVolume * 512.0) - 1.0) < 0.02);
    QCOMPARE(fixture.run({"voxelize", "b.stl", "-o", "c" + name.mid(1), "--voxel", "0.5"}).code, 0);
    const auto again = figuresIn(fixture.run({"inspect", "c" + name.mid(1), "--json"}).out);
    QVERIFY(std::abs(again["document"]["volume"].get<double>() / (kBallVolume * 512.0) - 1.0) < 0.02);
  }

  // A range that nobody chose is said.
  void otsu() {
    const Fixture fixture;
    putBalls(fixture, "mha");
    const Ran ran = fixture.run({"segment", "balls.mha", "-o", "a.stl", "--json"});
    QCOMPARE(ran.code, 0);
    const double least = figuresIn(ran.out)["range"][0].get<double>();
    QVERIFY(least > 100.0 && least < 900.0);
    const Ran opened = fixture.run({"remesh", "balls.mha", "-o", "b.stl"});
    QCOMPARE(opened.code, 0);
    QVERIFY(opened.err.contains("are taken as material"));
  }

  // A folder of DICOM, or one file of it; what is missing is said, and nothing of the patient is.
  void dicom() {
    const Fixture fixture;
    putSeries(fixture);
    for (const char* input : {"Erika", "Erika/7"}) {
      const Ran ran = fixture.run({"segment", input, "-o", "a.handwheel", "--range", "0:", "--json"});
      QCOMPARE(ran.code, 0);
      const auto figures = figuresIn(ran.out);
      QCOMPARE(figures["spacing_mm"].get<std::vector<double>>(), (std::vector<double>{1, 1, 2}));
      QVERIFY(std::abs(figures["volume_mm3"].get<double>() / (kBallVolume * 1728.0) - 1.0) < 0.03);
      QCOMPARE(figures["warnings"].size(), std::size_t{1});
      QVERIFY(ran.err.contains("Slices are missing (1)"));
      const QByteArray inspected = fixture.run({"inspect", "a.handwheel", "--json"}).out;
      for (const QByteArray& said : {ran.out, ran.err, fixture.content("a.handwheel"), inspected})
        QVERIFY(!said.contains("Mustermann") && !said.contains("Erika"));
    }
    for (const QStringList& command : {QStringList{"voxelize"}, QStringList{"offset", "--distance", "1"}}) {
      const Ran ran = fixture.run(command + QStringList{"Erika", "-o", "b.handwheel", "--voxel", "1"});
      QVERIFY2(ran.code == 0, ran.err);
      QVERIFY(!fixture.run({"inspect", "b.handwheel"}).out.contains("Erika"));
    }
  }

  // Reports go on to others: they name no image, as it may be called after a patient.
  void reports() {
    const Fixture fixture;
    putBalls(fixture, "mha");
    QVERIFY(QDir(fixture.path()).mkdir("Erika"));
    fixture.put("Erika/Mustermann.mha", fixture.content("balls.mha"));
    fixture.put("part.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    const Ran ran = fixture.run({"repair", "part.off", "Erika/Mustermann.mha", "-o", "fixed", "--format", "stl", "--by",
                                 "both", "--voxel", "1", "--report", "table.csv"});
    QVERIFY(ran.out.contains("Erika/Mustermann.mha"));
    const QByteArray text = fixture.content("table.csv");
    QVERIFY(text.contains("part.off") && text.contains("image 1"));
    QVERIFY2(!text.contains("Mustermann") && !text.contains("Erika"), text);
  }

  void refusals_data() {
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("no output") << QStringList{"balls.mha"} << QByteArray("The option -o OUT is missing.");
    QTest::newRow("no range") << QStringList{"balls.mha", "-o", "b.stl", "--range", "5"} << QByteArray("300:2000");
    QTest::newRow("turned") << QStringList{"balls.mha", "-o", "b.stl", "--range", "5:1"} << QByteArray("the lower one");
    QTest::newRow("nothing") << QStringList{"balls.mha", "-o", "b.stl", "--range", "5000:"}
                             << QByteArray("from 0 to 1000");
    QTest::newRow("ending") << QStringList{"balls.mha", "-o", "b.txt"} << QByteArray(".vdb");
    QTest::newRow("itself") << QStringList{"balls.mha", "-o", "balls.mha"} << QByteArray("is an input");
    QTest::newRow("no image") << QStringList{"b.off", "-o", "b.stl"} << QByteArray("b.off");
    QTest::newRow("no data") << QStringList{"lost.mhd", "-o", "b.stl"} << QByteArray("lost.raw");
    QTest::newRow("data elsewhere") << QStringList{"away.mhd", "-o", "b.stl"} << QByteArray("outside of the folder");
    QTest::newRow("empty folder") << QStringList{"empty", "-o", "b.stl"} << QByteArray("no DICOM files");
    QTest::newRow("missing") << QStringList{"none", "-o", "b.stl"} << QByteArray("none");
    // The predicted memory is refused first, and the voxels themselves if the user insists.
    QTest::newRow("memory") << QStringList{"balls.mha", "-o", "b.stl", "--voxel", "1e-4"}
                            << QByteArray("voxels of 0.0001 mm would need 1.05e+07 MB, and ");
    QTest::newRow("memory, advice") << QStringList{"balls.mha", "-o", "b.stl", "--voxel", "1e-4"}
                                    << QByteArray(" MB are available. Choose larger voxels, or close other programs.");
    QTest::newRow("too fine") << QStringList{"balls.mha", "-o", "b.stl", "--voxel", "1e-4", "--yes"}
                              << QByteArray("voxels of 1e-04 mm are too fine for a part of 48 mm");
  }
  void refusals() {
    QFETCH(QStringList, words);
    QFETCH(QByteArray, text);
    const Fixture fixture;
    putBalls(fixture, "mha");
    QDir(fixture.path()).mkdir("empty");
    fixture.put("b.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n");
    const QByteArray head =
        "ObjectType = Image\nNDims = 3\nDimSize = 1 1 1\nElementType = MET_SHORT\nElementDataFile = ";
    fixture.put("lost.mhd", head + "lost.raw\n");
    fixture.put("away.mhd", head + "../../etc/hostname\n");
    const Ran ran = fixture.run(QStringList{"segment"} + words);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains(text), ran.err.constData());
    QVERIFY(!fixture.names().contains("b.stl"));
  }
};

HANDWHEEL_TEST(SegmentTest)
#include "SegmentTest.moc"
