// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ReadDescription.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

// Small whole files of every kind, cut off at every byte and with bytes changed. Their text holds no number of two
// digits, so that a number that is cut off is never another number.
namespace {

struct Seed {
  const char* name;
  QByteArray bytes;
  bool announced;  // the file says how many triangles it has
};

const QByteArray kPlyElements =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "element face 3\nproperty list uchar int vertex_indices\n";

QByteArray plyBinary(std::endian order) {
  Bytes bytes(order);
  bytes.text(QByteArray("ply\nformat binary_") + (order == std::endian::big ? "big" : "little") + "_endian 1.0\n");
  bytes.text(kPlyElements + "end_header\n");
  for (int i = 0; i < 4; ++i) bytes.all<float>({float(i & 1), float(i >> 1), float(i)}).add<std::uint8_t>(9);
  bytes.add<std::uint8_t>(3).all<std::int32_t>({0, 1, 2});
  bytes.add<std::uint8_t>(4).all<std::int32_t>({0, 1, 3, 2});
  return bytes.add<std::uint8_t>(3).all<std::int32_t>({1, 2, 3});
}

QByteArray offBinary(std::endian order, bool colourCounts) {
  Bytes bytes(order);
  bytes.text("OFF BINARY\n").all<std::uint32_t>({4, 3, 0});
  for (int i = 0; i < 4; ++i) bytes.all<float>({float(i & 1), float(i >> 1), float(i)});
  for (std::uint32_t i = 0; i < 3; ++i) {
    bytes.all<std::uint32_t>({3, 0, 1 + i / 2, 2 + i / 2});
    if (colourCounts) bytes.add<std::uint32_t>(0);
  }
  return bytes;
}

QByteArray stlBinary() {
  Bytes bytes;
  bytes.text(QByteArray("solid part").leftJustified(80, ' ')).add<std::uint32_t>(3);
  for (int i = 0; i < 3; ++i)
    bytes.all<float>({0, 0, 1, 0, 0, float(i), 1, 0, float(i), 0, 1, float(i)}).add<std::uint16_t>(0);
  return bytes;
}

QByteArray threeMf() {
  const TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}, {2, 1, 3}}};
  return QByteArray::fromStdString(writeMesh(soup, MeshFormat::ThreeMf, NumberType::Float32));
}

std::vector<Seed> seeds() {
  const QByteArray facet =
      "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
  const QByteArray stl = "solid a\n" + facet + facet + "endsolid a\nsolid b\n" + facet + "endsolid b\n";
  const QByteArray obj =
      "# a\nmtllib x\ng y\nv 0 0 0\nv 1 0 0\nv 0 1 0 1 0 0\nvn 0 0 1\nv 1 1 0\nf 1//1 2//1 3//1\n"
      "f 1 2 \\\n 4 3\nf -1 -2 -3\nl 1 2\n";
  const QByteArray off =
      "NOFF # a\n4 3 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n1 1 0 0 0 1\n3 0 1 2\n4 0 1 3 2 1 0 0\n"
      "3 1 2 3\n";
  const QByteArray rows = "0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n3 0 1 2\n4 0 1 3 2\n3 1 2 3\n";
  const QByteArray ply = "ply\nformat ascii 1.0\n" + kPlyElements + "end_header\n" + rows;
  const QByteArray strips = "ply\nformat ascii 1.0\n" + QByteArray(kPlyElements).replace("face 3", "tristrips 1") +
                            "end_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n9 0 1 2 3 -1 1 2 3 -1\n";
  return {{"text STL", stl, false},
          {"binary STL", stlBinary(), true},
          {"OBJ", obj, false},
          {"text OFF", off, true},
          {"big-endian OFF", offBinary(std::endian::big, true), true},
          {"little-endian OFF", offBinary(std::endian::little, false), true},
          {"text PLY", ply, true},
          {"PLY strips", strips, true},
          {"little-endian PLY", plyBinary(std::endian::little), true},
          {"big-endian PLY", plyBinary(std::endian::big), true},
          {"3MF", threeMf(), true}};
}

// Checks the invariants of every result, for any bytes.
bool isSoundOrRefused(const Result<MeshFile>& file) {
  if (!file) return true;
  const auto& [points, triangles] = file->soup;
  for (const Vec3& p : points)
    if (!p.allFinite()) return false;
  for (const Triangle& t : triangles)
    for (std::uint32_t corner : t)
      if (corner >= points.size()) return false;
  return !triangles.empty() && file->damage.size() <= 1000;
}

bool isPrefix(const TriangleSoup& part, const TriangleSoup& whole) {
  if (part.triangles.size() > whole.triangles.size()) return false;
  for (std::size_t i = 0; i < 3 * part.triangles.size(); ++i)
    if (part.points[part.triangles[i / 3][i % 3]] != whole.points[whole.triangles[i / 3][i % 3]]) return false;
  return true;
}

}  // namespace

class DamagedMeshTest : public QObject {
  Q_OBJECT
 private slots:
  void cutOff_data() { addSeeds(); }

  // A truncated file is refused, or its beginning is read. Only formats that announce nothing can be truncated without
  // notice.
  void cutOff() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, announced);
    const auto whole = read(bytes, false, "a");
    QVERIFY2(whole, qPrintable(describe(whole)));
    QCOMPARE(whole->damage.size(), std::size_t{0});
    bool everPartial = false;
    for (int size = 0; size < bytes.size(); ++size) {
      for (const char* name : {"a", "a.stl", "a.obj", "a.off", "a.ply"}) {
        const auto strict = read(bytes.left(size), false, name), partial = read(bytes.left(size), true, name);
        QVERIFY2(isSoundOrRefused(strict) && isSoundOrRefused(partial), qPrintable(QString::number(size)));
        if (partial) QVERIFY2(isPrefix(partial->soup, whole->soup), qPrintable(describe(partial)));
        if (strict) QVERIFY2(partial && isPrefix(strict->soup, whole->soup), qPrintable(describe(strict)));
        if (strict && announced) QCOMPARE(strict->soup.triangles.size(), whole->soup.triangles.size());
        everPartial |= partial && partial->soup.triangles.size() < whole->soup.triangles.size();
        if (partial && announced && partial->soup.triangles.size() < whole->soup.triangles.size())
          QVERIFY(!partial->damage.empty());
      }
    }
    QVERIFY(everPartial || bytes.startsWith("ply\nformat ascii"));
  }

  void changedBytes_data() { addSeeds(); }

  void changedBytes() {
    QFETCH(QByteArray, bytes);
    std::mt19937 random(20260101);
    for (int round = 0; round < 4000; ++round) {
      QByteArray changed = bytes;
      const int changes = 1 + static_cast<int>(random() % 4);
      for (int i = 0; i < changes; ++i) {
        const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(changed.size()));
        constexpr char kNasty[] = {'\0', '\xff', '\x7f', '\n', '\r', ' ', '-', '9', '#', '\\'};
        switch (random() % 4) {
          case 0:
            changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
            break;
          case 1:
            changed[at] = kNasty[random() % sizeof kNasty];
            break;
          case 2:
            changed.remove(at, 1 + static_cast<qsizetype>(random() % 5));
            break;
          default:
            changed.insert(at,
                           changed.mid(static_cast<qsizetype>(random() % static_cast<unsigned>(changed.size())), 9));
        }
        if (changed.isEmpty()) changed = bytes;
      }
      const auto strict = read(changed), partial = read(changed, true);
      QVERIFY2(isSoundOrRefused(strict) && isSoundOrRefused(partial), changed.toHex().constData());
      // Partial reading never gives less than complete reading.
      if (strict) QVERIFY2(partial && describe(partial) == describe(strict), changed.toHex().constData());
    }
  }

  // Counts as large as they can be, in files of a few bytes: nothing may be allocated for them.
  void boastfulCounts() {
    const char* const kHuge[] = {"2147483647", "4294967295", "9223372036854775807", "18446744073709551615"};
    for (const char* count : kHuge) {
      const QByteArray n(count);
      const QByteArray inputs[] = {
          "OFF\n" + n + " 1 0\n0 0 0\n",
          "OFF\n1 " + n + " 0\n0 0 0\n",
          "OFF\n1 1 0\n0 0 0\n" + n + " 0 0 0\n",
          "ply\nformat ascii 1.0\nelement vertex " + n +
              "\nproperty float x\nproperty float y\nproperty float z\nend_header\n",
          "ply\nformat binary_little_endian 1.0\nelement vertex " + n +
              "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0123456789ab",
          "ply\nformat binary_little_endian 1.0\nelement a " + n +
              "\nproperty list int double b\nend_header\n\xff\xff\xff\x7f",
          "ply\nformat binary_little_endian 1.0\nelement a " + n + "\nelement face " + n +
              "\nproperty list uint uint b\nend_header\n\xff\xff\xff\xff",
          "v 0 0 0\nf " + n + " -" + n + " 1\n",
      };
      for (const QByteArray& input : inputs)
        for (bool partial : {false, true}) QVERIFY2(!read(input, partial), input.constData());
    }
  }

 private:
  void addSeeds() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("announced");
    for (const Seed& seed : seeds()) QTest::newRow(seed.name) << seed.bytes << seed.announced;
  }
};

HANDWHEEL_TEST(DamagedMeshTest)
#include "DamagedMeshTest.moc"
