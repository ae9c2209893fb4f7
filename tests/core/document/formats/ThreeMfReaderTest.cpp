// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "ThreeMfText.h"
#include "document/Container.h"
#include "document/DocumentErrors.h"
#include "document/container/ArchiveErrors.h"

#include <rapidcheck.h>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns the signed volume, which shows positions and orientations.
double volumeOf(const TriangleSoup& soup) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles)
    sum += soup.points[t[0]].dot(soup.points[t[1]].cross(soup.points[t[2]])) / 6.0;
  return sum;
}

}  // namespace

class ThreeMfReaderTest : public QObject {
  Q_OBJECT
 private slots:
  void oneObject() {
    const auto file = read(package(model(object(1, kMesh), item(1))));
    QCOMPARE(describe(file), kTetrahedron);
    QVERIFY(file->format == MeshFormat::ThreeMf);
    QVERIFY(file->numbers == NumberType::Float64);
  }

  // Some programs write a byte order mark, quotes of either kind, or another version of XML.
  void declarations() {
    const QByteArray plain = model(object(1, kMesh), item(1));
    const qsizetype end = plain.indexOf("?>") + 2;
    for (const char* const declaration :
         {"", "<?xml version=\"1.0\"?>", "<?xml version='1.1' encoding=\"utf-8\" standalone='no'?>",
          "\xEF\xBB\xBF<?xml version=\"1.0\" encoding='UTF-8'?>", "\xEF\xBB\xBF", "<?xml version='1e0'?>"})
      QCOMPARE(describe(read(package(declaration + plain.mid(end)))), kTetrahedron);
    const QByteArray doubled = QByteArray(plain).replace('\'', '"');
    QCOMPARE(describe(read(package(doubled))), kTetrahedron);
  }

  void units_data() {
    QTest::addColumn<double>("millimetres");
    QTest::newRow("") << 1.0;
    QTest::newRow("micron") << 0.001;
    QTest::newRow("millimeter") << 1.0;
    QTest::newRow("centimeter") << 10.0;
    QTest::newRow("inch") << 25.4;
    QTest::newRow("foot") << 304.8;
    QTest::newRow("meter") << 1000.0;
  }

  // Also the translations of transforms are in the file's unit.
  void units() {
    QFETCH(double, millimetres);
    const QByteArray unit = QTest::currentDataTag();
    const auto file = read(package(model(object(1, kMesh), item(1, "transform='1 0 0 0 1 0 0 0 1 2 0 0'"),
                                         unit.isEmpty() ? "" : "unit='" + unit + "'")));
    QVERIFY(file);
    QCOMPARE(file->soup.points[1].x(), 3.0 * millimetres);
    QCOMPARE(file->soup.points[2], Vec3(2.0 * millimetres, millimetres, 0.0));
  }

  void unknownUnit() {
    QCOMPARE(readModel(object(1, kMesh), item(1), "unit='furlong'"),
             QString("ElementMalformed(model,its unit is 'furlong') line 2"));
    QVERIFY(readModel(object(1, kMesh), item(1), "unit='furlong'", true).startsWith(kTetrahedron + " ! Element"));
  }

  // A row vector stands before the matrix: the fourth row is the translation.
  void transforms() {
    QCOMPARE(readModel(object(1, kTriangleMesh), item(1, "transform='2 0 0 0 3 0 0 0 4 10 20 30'")),
             QString("10 20 30, 12 20 30, 10 23 30 | 0 1 2"));
    // x goes to y, y to -x: a quarter turn.
    QCOMPARE(readModel(object(1, kTriangleMesh), item(1, "transform='0 1 0 -1 0 0 0 0 1 0 0 0'")),
             QString("0 0 0, 0 1 0, -1 0 0 | 0 1 2"));
  }

  void mirrorsTurnTrianglesOver() {
    QCOMPARE(readModel(object(1, kTriangleMesh), item(1, "transform='-1 0 0 0 1 0 0 0 1 0 0 0'")),
             QString("0 0 0, -1 0 0, 0 1 0 | 0 2 1"));
    QVERIFY(rc::check([] {
      QByteArray numbers;
      double determinant = 1.0;
      for (int axis = 0; axis < 3; ++axis) {
        const int factor = *rc::gen::element(-3, -2, -1, 1, 2, 3);
        determinant *= factor;
        numbers += (axis == 0   ? QByteArray::number(factor) + " 0 0 "
                    : axis == 1 ? "0 " + QByteArray::number(factor) + " 0 "
                                : "0 0 " + QByteArray::number(factor) + " ");
      }
      const auto file = read(package(model(object(1, kMesh), item(1, "transform='" + numbers + "5 6 7'"))));
      RC_ASSERT(file.hasValue());
      RC_ASSERT(std::abs(volumeOf(file->soup) - std::abs(determinant) / 6.0) <
                1e-9);  // outward, in spite of the mirror
    }));
  }

  void severalObjectsAndItems() {
    QCOMPARE(readModel(object(1, kTriangleMesh) + object(7, kTriangleMesh),
                       item(7, "transform='1 0 0 0 1 0 0 0 1 0 0 5'") + item(1) + item(1)),
             QString("0 0 5, 1 0 5, 0 1 5, 0 0 0, 1 0 0, 0 1 0, 0 0 0, 1 0 0, 0 1 0 | 0 1 2, 3 4 5, 6 7 8 - Groups"));
  }

  // Inner transforms act first.
  void nestedComponents() {
    const QByteArray resources = object(1, kTriangleMesh) +
                                 object(2, components({{1, "transform='2 0 0 0 2 0 0 0 2 0 0 0'"}})) +
                                 object(3, components({{2, "transform='1 0 0 0 1 0 0 0 1 10 0 0'"}}));
    QCOMPARE(readModel(resources, item(3, "transform='0 1 0 -1 0 0 0 0 1 0 0 0'")),
             QString("0 10 0, 0 12 0, -2 10 0 | 0 1 2"));
    // The order in which objects are defined does not matter.
    const QByteArray turned =
        object(3, components({{1, ""}, {1, "transform='1 0 0 0 1 0 0 0 1 0 0 1'"}})) + object(1, kTriangleMesh);
    QCOMPARE(readModel(turned, item(3)), QString("0 0 0, 1 0 0, 0 1 0, 0 0 1, 1 0 1, 0 1 1 | 0 1 2, 3 4 5 - Groups"));
  }

  // Only the objects that the build names, and never those of the type 'other'.
  void onlyTheBuild() {
    QCOMPARE(readModel(object(1, kTriangleMesh) + object(2, kMesh, "type='support'"), item(1)), kTriangle);
    QCOMPARE(readModel(object(1, kTriangleMesh, "type='solidsupport'"), item(1)), kTriangle);
    QCOMPARE(readModel(object(1, kTriangleMesh) + object(2, kMesh, "type='other'"), item(1) + item(2)),
             kTriangle + " ! ElementMalformed(item,its object is of the type 'other') line 6 - Groups");
    QCOMPARE(readModel(object(1, kTriangleMesh), ""), QString("NoTriangles"));
  }

  void whereTheModelStands() {
    const QByteArray text = model(object(1, kTriangleMesh), item(1));
    for (const QByteArray target : {"/3D/3dmodel.model", "3D/3dmodel.model", "/a%20b/Part.model", "/x.xml"}) {
      const QByteArray name = QByteArray::fromPercentEncoding(target.startsWith('/') ? target.mid(1) : target);
      QCOMPARE(describe(read(package({{name, text}, {"_rels/.rels", relationships(target)}}))), kTriangle);
      QCOMPARE(describe(read(package({{name.toUpper(), text}, {"_RELS/.RELS", relationships(target)}}))), kTriangle);
    }
  }

  void relationshipsThatLeadNowhere() {
    const QByteArray text = model(object(1, kTriangleMesh), item(1));
    for (const QByteArray& relations : {relationships("/gone.model"), QByteArray("<a/>"), QByteArray("no XML")}) {
      const QByteArray bytes = package({{"_rels/.rels", relations}, {"elsewhere/a.model", text}});
      QCOMPARE(describe(read(bytes)), QString("ReferenceMissing(the 3D model,_rels/.rels)"));
      QCOMPARE(describe(read(bytes, true)), kTriangle + " ! ReferenceMissing(the 3D model,_rels/.rels)");
    }
    QCOMPARE(describe(read(package({{"a", "b"}}))), QString("EntryMissing(_rels/.rels)"));
    QCOMPARE(describe(read(package({{"a", "b"}}), true)), QString("EntryMissing(3D/3dmodel.model)"));
  }

  // The production extension keeps objects in parts of their own, as many programs do.
  void otherParts() {
    const QByteArray inner = model(object(4, kTriangleMesh), "", "unit='centimeter'");
    const QByteArray outer =
        model(object(1, components({{4, "p:path='/3D/Objects/inner.model' transform='1 0 0 0 1 0 0 0 1 0 0 5'"}})),
              item(1) + item(4, "p:path='/3D/Objects/inner.model'"), "requiredextensions='p'");
    const auto file = read(package({{"_rels/.rels", relationships("/3D/3dmodel.model")},
                                    {"3D/3dmodel.model", outer},
                                    {"3D/Objects/inner.model", inner}}));
    QCOMPARE(describe(file), QString("0 0 5, 10 0 5, 0 10 5, 0 0 0, 10 0 0, 0 10 0 | 0 1 2, 3 4 5 - Groups"));
    QCOMPARE(describe(read(package(outer))), QString("ReferenceMissing(the object,/3D/Objects/inner.model#4) line 3"));
  }

  void whatIsLost() {
    const QByteArray resources =
        "<basematerials id='9'><base name='red' displaycolor='#FF0000'/></basematerials>"
        "<m:colorgroup id='8'><m:color color='#FF0000'/></m:colorgroup><m:texture2dgroup id='7' texid='6'/>" +
        object(1, QByteArray(kTriangleMesh).replace("v3='2'", "v3='2' pid='9' p1='0'"), "pid='9' pindex='0'");
    const QByteArray text =
        model(resources, item(1)).replace("<resources>", "<metadata name='Title'>A</metadata><resources>");
    QCOMPARE(describe(read(package(text))), kTriangle + " - Colour TextureCoordinates Materials Other");
    const QByteArray lattice =
        "<b:beamlattice xmlns:b='http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02'>"
        "<b:beams><b:beam v1='0' v2='1'/></b:beams></b:beamlattice></mesh>";
    QCOMPARE(readModel(object(1, QByteArray(kTriangleMesh).replace("</mesh>", lattice)), item(1)),
             kTriangle + " - Lines");
  }

  void requiredExtensions() {
    QCOMPARE(readModel(object(1, kTriangleMesh), item(1), "requiredextensions='m p'"), kTriangle);
    QCOMPARE(readModel(object(1, kTriangleMesh), item(1), "requiredextensions='s'"),
             QString("Unsupported(the 3MF extension 's') line 2"));
  }

  void numbers() {
    const QByteArray vertices =
        "<vertex x=' 1e2 ' y='+.5' z='-0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>";
    QCOMPARE(readModel(object(1, mesh(vertices, "<triangle v1='0' v2='1' v3='2'/>")), item(1)),
             QString("100 0.5 0, 1 0 0, 0 1 0 | 0 1 2"));
  }

  void damagedVertices() {
    const QByteArray good = "<vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/><vertex x='0' y='1' z='0'/>";
    const QByteArray triangles = "<triangle v1='1' v2='2' v3='3'/><triangle v1='0' v2='1' v3='2'/>";
    const std::pair<const char*, const char*> cases[] = {{"x='a' y='0' z='0'", "NumberMalformed(a)"},
                                                         {"y='0' z='0'", "NumberMalformed()"},
                                                         {"x='0' y='1,5' z='0'", "NumberMalformed(1,5)"},
                                                         {"x='0' y='0' z='nan'", "NumberNotFinite(nan)"},
                                                         {"x='0' y='0' z='1e999'", "NumberNotFinite(1e999)"}};
    for (const auto& [attributes, error] : cases) {
      const QByteArray resources = object(1, mesh("<vertex " + QByteArray(attributes) + "/>" + good, triangles));
      const QString where = " line 3";
      QVERIFY2(readModel(resources, item(1)).startsWith(error) || QString(error).contains("nan"), attributes);
      QCOMPARE(readModel(resources, item(1), "", true),
               kTriangle + " ! " + error + where + "; VertexUnreadable(0)" + where);
    }
  }

  void damagedTriangles() {
    const QByteArray text = QByteArray(kTriangleMesh).replace("<triangles>", "<triangles>%");
    const std::pair<const char*, const char*> cases[] = {
        {"v1='0' v2='1' v3='3'", "IndexOutOfRange(3,3)"},
        {"v1='0' v2='1' v3='-1'", "NumberMalformed(-1)"},
        {"v1='0' v2='1' v3='99999999999'", "NumberMalformed(99999999999)"},
        {"v1='0' v2='1'", "ElementMalformed(triangle,it has no v3)"},
        {"v1='0' v2='1.5' v3='2'", "NumberMalformed(1.5)"}};
    for (const auto& [attributes, error] : cases) {
      const QByteArray resources =
          object(1, QByteArray(text).replace("%", "<triangle " + QByteArray(attributes) + "/>"));
      QCOMPARE(readModel(resources, item(1)), QString(error) + " line 3");
      QCOMPARE(readModel(resources, item(1), "", true), kTriangle + " ! " + error + " line 3");
    }
  }

  void damagedReferences() {
    const std::pair<QByteArray, const char*> cases[] = {
        {item(5), "ReferenceMissing(the object,#5) line 4"},
        {"<item/>", "ElementMalformed(item,it has no objectid) line 4"},
        {item(1, "transform='1 0 0'"), "ElementMalformed(transform,it is not twelve numbers) line 4"},
        {item(1, "transform='1 0 0 0 1 0 0 0 1 0 0 0 0'"),
         "ElementMalformed(transform,it is not twelve numbers) line 4"},
        {item(1, "transform='1 0 0 0 1 0 0 0 1 0 0 inf'"),
         "ElementMalformed(transform,it is not twelve numbers) line 4"}};
    for (const auto& [bad, error] : cases) {
      const QByteArray build = "\n" + item(1) + bad;
      QCOMPARE(readModel(object(1, kTriangleMesh), build), QString(QString(error).replace("line 4", "line 6")));
      QVERIFY(readModel(object(1, kTriangleMesh), build, "", true).startsWith(kTriangle + " ! "));
    }
    QVERIFY(readModel(object(1, kTriangleMesh), item(1, "transform='1e308 0 0 0 1 0 0 0 1 1e308 0 0'"))
                .startsWith("NumberNotFinite"));
    QVERIFY(readModel(object(1, kTriangleMesh) + object(1, kMesh), item(1), "", true).startsWith(kTriangle + " ! "));
  }

  // The build is at the end, so a truncated text has none: objects that are no components are built.
  void cutOff() {
    const QByteArray resources = object(1, kTriangleMesh) + object(2, components({{1, ""}})) + object(3, kMesh);
    QByteArray text = model(resources, item(2));
    text.truncate(text.indexOf("<triangle v1='1' v2='2' v3='3'/>"));
    QVERIFY(codeOf(package(text)) == ErrorCode::ElementMalformed);
    const QString partial = describe(read(package(text), true));
    QVERIFY2(partial.startsWith("0 0 0, 1 0 0, 0 1 0, 0 0 0, 1 0 0, 0 1 0, 0 0 1 | 0 1 2, 3 5 4, 3 4 6 ! Element"),
             qPrintable(partial));
  }

  // A wrong byte in the packed model: the part before it is read.
  void damagedArchive() {
    QByteArray resources = "<vertices>";
    for (int i = 0; i < 30'000; ++i) resources += "<vertex x='" + QByteArray::number(i * i) + "' y='0' z='1'/>";
    resources += "</vertices><triangles>";
    for (int i = 0; i < 30'000; ++i)
      resources +=
          "<triangle v1='" + QByteArray::number(i) + "' v2='" + QByteArray::number(i * 7 % 30'000) + "' v3='0'/>";
    QByteArray bytes = package(model(object(1, "<mesh>" + resources + "</triangles></mesh>"), item(1)));
    const auto whole = read(bytes);
    QVERIFY(whole);
    bytes[static_cast<int>(bytes.size() * 0.9)] = static_cast<char>(bytes[static_cast<int>(bytes.size() * 0.9)] ^ 0x55);
    QVERIFY(codeOf(bytes) == ArchiveError::EntryDamaged);
    const auto partial = read(bytes, true);
    QVERIFY(partial);
    QVERIFY(partial->damage[0].code == ArchiveError::EntryDamaged);
    QVERIFY(partial->soup.triangles.size() > 1000 && partial->soup.triangles.size() <= 30'000);

    // Truncated with its directory.
    bytes.truncate(bytes.size() * 3 / 4);
    QVERIFY(codeOf(bytes) == ArchiveError::Malformed);
    const auto cut = read(bytes, true);
    QVERIFY(cut);
    QVERIFY(cut->soup.triangles.size() > 1000);
    for (std::size_t i = 0; i < cut->soup.triangles.size(); ++i)
      QVERIFY(cut->soup.triangles[i] == whole->soup.triangles[i]);
  }

  // Both are ZIP archives.
  void ourDocumentsAreNone() {
    const std::string container = *writeContainer(Container(), Compression::Fast);
    QVERIFY(codeOf(QByteArray::fromStdString(container)) == DocumentError::FormatUnknown);
    QCOMPARE(describe(read(package(model(object(1, kTriangleMesh), item(1))), false, "a.stl")), kTriangle);
  }

  void cancelled() {
    QByteArray triangles;
    for (int i = 0; i < 50'000; ++i) triangles += "<triangle v1='0' v2='1' v3='2'/>";
    const QByteArray bytes =
        package(model(object(1, QByteArray(kTriangleMesh).replace("<triangles>", "<triangles>" + triangles)), item(1)));
    JobState state;
    state.cancelled = true;
    const auto file = readMesh({bytes.constData(), static_cast<std::size_t>(bytes.size())}, "", {}, Progress(state));
    QCOMPARE(describe(file), QString("Cancelled"));
  }
};

HANDWHEEL_TEST(ThreeMfReaderTest)
#include "ThreeMfReaderTest.moc"
