// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../ContainerChecks.h"
#include "TestClass.h"
#include "ThreeMfText.h"
#include "document/formats/MeshFileErrors.h"
#include "mesh/structure/MeshErrors.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class ThreeMfHostileTest : public QObject {
  Q_OBJECT
 private slots:
  void cycles() {
    const QByteArray self = object(1, components({{1, ""}}));
    QCOMPARE(readModel(self, item(1)), QString("ElementMalformed(component,it contains itself) line 3"));
    const QByteArray ring = object(1, components({{2, ""}})) + object(2, components({{3, ""}})) +
                            object(3, components({{1, ""}, {4, ""}})) + object(4, kTriangleMesh);
    QCOMPARE(readModel(ring, item(1)), QString("ElementMalformed(component,it contains itself) line 5"));
    QVERIFY(readModel(ring, item(1), "", true).startsWith(kTriangle + " ! Element"));
  }

  // Forty objects that each hold the one before twice: 2^39 triangles.
  void explosions() {
    QByteArray doubling = object(1, kTriangleMesh), empty = object(1, mesh("<vertex x='0' y='0' z='0'/>", ""));
    QByteArray nothing = object(1, "<components/>");
    for (int i = 2; i <= 40; ++i) {
      const QByteArray twice = object(i, components({{i - 1, ""}, {i - 1, ""}}));
      doubling += twice;
      empty += twice;
      nothing += twice;
    }
    for (bool partial : {false, true}) {
      QVERIFY(codeOf(package(model(doubling, item(40))), partial) == ErrorCode::FileTooLarge);
      QVERIFY(codeOf(package(model(empty, item(40))), partial) == ErrorCode::FileTooLarge);
      QVERIFY(codeOf(package(model(nothing, item(40))), partial) == MeshError::NoTriangles);
    }
    QCOMPARE(readModel(nothing + object(50, kTriangleMesh), item(40) + item(50)), kTriangle + " - Groups");
  }

  // For any entry into the chain: an object known to be deep must not hide that.
  void deepNesting() {
    const auto chain = [](int length) {
      QByteArray resources = object(1, kTriangleMesh);
      for (int i = 2; i <= length; ++i) resources += object(i, components({{i - 1, ""}}));
      return resources;
    };
    QCOMPARE(readModel(chain(100), item(100)), kTriangle);
    QVERIFY(codeOf(package(model(chain(5000), item(5000)))) == ErrorCode::ElementMalformed);
    QByteArray items;
    for (int i = 50; i <= 5000; i += 50) items += item(i);
    QVERIFY(codeOf(package(model(chain(5000), items))) == ErrorCode::ElementMalformed);
  }

  void bombs() {
    const QByteArray text = model(object(1, kTriangleMesh), item(1)) + QByteArray(300 << 20, ' ');
    const QByteArray bytes = QByteArray::fromStdString(
        HandmadeZip()
            .add(HandmadeZip::stored("_rels/.rels", relationships("3D/3dmodel.model").toStdString()))
            .add(HandmadeZip::deflated("3D/3dmodel.model", text.toStdString()))
            .bytes());
    QVERIFY(bytes.size() < 1 << 20);
    for (bool partial : {false, true}) QVERIFY(codeOf(bytes, partial) == ErrorCode::FileTooLarge);
  }

  void hostileXml() {
    const QByteArray entity = "<!DOCTYPE model [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;'>]>";
    QByteArray attributes, deep;
    for (int i = 0; i < 100'000; ++i) attributes += "a" + QByteArray::number(i) + "='' ";
    for (int i = 0; i < 100'000; ++i) deep += "<a>";
    const QByteArray texts[] = {entity + model("", ""), model(object(1, kTriangleMesh), item(1), attributes),
                                model(deep, ""), model("<a>" + QByteArray(17 << 20, 'x') + "</a>", ""),
                                model("<a b='" + QByteArray(10'000, '>') + "'/>", "")};
    for (const QByteArray& text : texts)
      for (bool partial : {false, true}) QVERIFY(codeOf(package(text), partial) == ErrorCode::ElementMalformed);
    QVERIFY(codeOf(package(QByteArray("\xff\xfe<\0m\0", 6))) == MeshFileError::TextEncoding);
    QVERIFY(codeOf(package(model("", "").replace("UTF-8", "UTF-16"))) == MeshFileError::TextEncoding);
    QVERIFY(codeOf(package("<html/>")) == ErrorCode::ElementMalformed);
    QVERIFY(codeOf(package("<model><resources/></model>")) == ErrorCode::ElementMalformed);  // no namespace
    QVERIFY(codeOf(package("")) == ErrorCode::ElementMalformed);
  }
};

HANDWHEEL_TEST(ThreeMfHostileTest)
#include "ThreeMfHostileTest.moc"
