// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshChecks.h"
#include "ReadDescription.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <QTest>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Every bit pattern that is a number, so also denormal and huge ones.
double anyNumber(NumberType type) {
  for (;;) {
    const auto raw = *rc::gen::arbitrary<std::uint64_t>();
    const double v = type == NumberType::Float64
                         ? std::bit_cast<double>(raw)
                         : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
    if (std::isfinite(v)) return v == 0.0 ? 0.0 : v;  // files do not keep the sign of zero
  }
}

TriangleSoup anySoup(NumberType type) {
  TriangleSoup soup;
  const auto points = *rc::gen::inRange<std::uint32_t>(1, 20);
  for (std::uint32_t i = 0; i < points; ++i)
    soup.points.emplace_back(anyNumber(type), anyNumber(type), anyNumber(type));
  const auto triangles = *rc::gen::inRange<std::uint32_t>(1, 20);
  const auto corner = rc::gen::inRange<std::uint32_t>(0, points);
  for (std::uint32_t i = 0; i < triangles; ++i) soup.triangles.push_back({*corner, *corner, *corner});
  return soup;
}

}  // namespace

class MeshWriterTest : public QObject {
  Q_OBJECT
 private slots:
  void readsBackTheSame_data() {
    QTest::addColumn<MeshFormat>("format");
    QTest::addColumn<NumberType>("type");
    QTest::newRow("PLY single") << MeshFormat::Ply << NumberType::Float32;
    QTest::newRow("PLY double") << MeshFormat::Ply << NumberType::Float64;
    QTest::newRow("OBJ single") << MeshFormat::Obj << NumberType::Float32;
    QTest::newRow("OBJ double") << MeshFormat::Obj << NumberType::Float64;
    QTest::newRow("OFF single") << MeshFormat::Off << NumberType::Float32;
    QTest::newRow("OFF double") << MeshFormat::Off << NumberType::Float64;
    QTest::newRow("3MF single") << MeshFormat::ThreeMf << NumberType::Float32;
    QTest::newRow("3MF double") << MeshFormat::ThreeMf << NumberType::Float64;
  }

  void readsBackTheSame() {
    QFETCH(MeshFormat, format);
    QFETCH(NumberType, type);
    QVERIFY(rc::check([&] {
      const TriangleSoup soup = anySoup(type);
      const auto file = readMesh(writeMesh(soup, format, type), "", {});
      RC_ASSERT(file.hasValue());
      RC_ASSERT(file->format == format && file->damage.empty() && file->lost.empty());
      RC_ASSERT(file->soup.triangles == soup.triangles);
      RC_ASSERT(file->soup.points.size() == soup.points.size());
      for (std::size_t i = 0; i < soup.points.size(); ++i) RC_ASSERT(sameBits(file->soup.points[i], soup.points[i]));
    }));
  }

  // STL has no shared points: every corner, in order.
  void stlReadsBackTheSame() {
    QVERIFY(rc::check([] {
      const TriangleSoup soup = anySoup(NumberType::Float32);
      const auto file = readMesh(writeMesh(soup, MeshFormat::Stl, NumberType::Float64), "", {});
      RC_ASSERT(file.hasValue());
      RC_ASSERT(file->format == MeshFormat::Stl && file->damage.empty() && file->lost.empty());
      RC_ASSERT(file->soup.triangles.size() == soup.triangles.size());
      for (std::size_t i = 0; i < 3 * soup.triangles.size(); ++i)
        RC_ASSERT(
            sameBits(file->soup.points[file->soup.triangles[i / 3][i % 3]], soup.points[soup.triangles[i / 3][i % 3]]));
    }));
  }

  void coordinatesAreRounded() {
    const TriangleSoup soup{{{0.1, 0, 0}, {1, -0.0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    for (MeshFormat format :
         {MeshFormat::Stl, MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Off, MeshFormat::ThreeMf}) {
      const auto file = readMesh(writeMesh(soup, format, NumberType::Float32), "", {});
      QVERIFY(file);
      QVERIFY(file->soup.points[0].x() == static_cast<double>(0.1f));
      QVERIFY(!std::signbit(file->soup.points[1].y()));
    }
  }

  // Built by hand from the format's description.
  void stlBytes() {
    const TriangleSoup soup{{{1, 2, 3}, {3, 2, 3}, {1, 5, 3}}, {{0, 1, 2}, {0, 1, 1}}};
    const std::string stl = writeMesh(soup, MeshFormat::Stl, NumberType::Float32);
    QVERIFY(!stl.starts_with("solid"));
    QCOMPARE(stl.size(), std::size_t{184});
    const QByteArray body = Bytes()
                                .add<std::uint32_t>(2)
                                .all<float>({0, 0, 1, 1, 2, 3, 3, 2, 3, 1, 5, 3})
                                .add<std::uint16_t>(0)
                                .all<float>({0, 0, 0, 1, 2, 3, 3, 2, 3, 3, 2, 3})
                                .add<std::uint16_t>(0);
    QCOMPARE(QByteArray::fromStdString(stl.substr(80)), body);
  }

  void plyBytes() {
    const TriangleSoup soup{{{1, 2, 3}, {3, 2, 3}, {1, 5, 3}}, {{0, 1, 2}}};
    const QByteArray header =
        "ply\nformat binary_little_endian 1.0\ncomment written by Handwheel\nelement vertex 3\nproperty double x\n"
        "property double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const QByteArray expected =
        Bytes().text(header).all<double>({1, 2, 3, 3, 2, 3, 1, 5, 3}).add<std::uint8_t>(3).all<std::int32_t>({0, 1, 2});
    QCOMPARE(QByteArray::fromStdString(writeMesh(soup, MeshFormat::Ply, NumberType::Float64)), expected);
  }

  void textBytes() {
    const TriangleSoup soup{{{0.1, -2, 1e21}, {1e-5, 0, 123456}, {0.30000000000000004, 1, 0}}, {{0, 1, 2}}};
    QCOMPARE(QString::fromStdString(writeMesh(soup, MeshFormat::Obj, NumberType::Float64)),
             QString("# written by Handwheel\nv 0.1 -2 1e+21\nv 1e-05 0 123456\nv 0.30000000000000004 1 0\nf 1 2 3\n"));
    QCOMPARE(QString::fromStdString(writeMesh(soup, MeshFormat::Off, NumberType::Float64)),
             QString("OFF\n3 1 0\n0.1 -2 1e+21\n1e-05 0 123456\n0.30000000000000004 1 0\n3 0 1 2\n"));
  }
};

HANDWHEEL_TEST(MeshWriterTest)
#include "MeshWriterTest.moc"
