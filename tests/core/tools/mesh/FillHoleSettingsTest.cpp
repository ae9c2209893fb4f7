// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FillServices.h"
#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "ToolEvents.h"

#include <QTest>

using namespace handwheel;
using test::Kind;

// Tests the user's settings for filling a hole: the method with its options, and bridges.
class FillHoleSettingsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { start(test::sphereWithHoles(3, 4, 0.3)); }
  void methodIsASetting();
  void bridges();
  void weightsOfEarCutting();
  void continuityOfFairPatches();

 private:
  void start(const TriangleSoup& soup);

  std::unique_ptr<MeshDocument> m_document;
  FillHoleTool* m_answering = nullptr;
  std::unique_ptr<FillHoleTool> m_tool;
};

using State = FillHoleTool::State;

void FillHoleSettingsTest::start(const TriangleSoup& soup) {
  m_answering = nullptr;
  m_document = test::meshDocument(soup);
  m_tool = std::make_unique<FillHoleTool>(*m_document, test::fillServices(*m_document, m_answering));
  m_answering = m_tool.get();
  connect(m_document.get(), &Document::changed, this, [this] { m_tool->documentChanged(); });
}

void FillHoleSettingsTest::methodIsASetting() {
  m_tool->perform("next");
  const std::size_t edges = m_tool->loop()->halfEdges.size();
  const auto triangles = [&] { return std::get<double>(test::propertyNamed(m_tool->settings(), "triangles")->value); };
  QVERIFY(triangles() > double(edges - 2));
  for (const double method : {2.0, 3.0, 4.0, 5.0}) {  // those that add no vertices
    m_tool->setSetting("fill", method);
    QCOMPARE(std::get<double>(test::propertyNamed(m_tool->settings(), "fill")->value), method);
    QCOMPARE(triangles(), double(edges - 2));
  }
  for (const PropertyValue& value : {PropertyValue(8.0), PropertyValue(-1.0), PropertyValue(std::nan("")),
                                     PropertyValue(true), PropertyValue("Fair")})
    m_tool->setSetting("fill", value);
  m_tool->setSetting("unknown", 0.0);
  QCOMPARE(std::get<double>(test::propertyNamed(m_tool->settings(), "fill")->value), 5.0);
}

// Drawn across the hole: the patch keeps to it, and drawing it once more takes it away.
void FillHoleSettingsTest::bridges() {
  start(test::sphereWithoutCap(3));
  m_tool->setSetting("fill", static_cast<double>(FillMethod::Ear));
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  m_tool->pointer(test::above(Kind::Release, 0, 0));
  const std::vector<Vec3> points = loopPoints(m_document->mesh(), *m_tool->loop());
  const Vec3 a = points[1], b = points[1 + points.size() / 2];
  const auto drawn = [&] {
    QCOMPARE(m_tool->pointer(test::above(Kind::Press, a.x(), a.y())), ToolReply::Used);
    QCOMPARE(m_tool->pointer(test::above(Kind::Drag, b.x(), b.y())), ToolReply::Used);
    QCOMPARE(m_tool->preview().lines.back(), std::vector<Vec3>({a, b}));
    QCOMPARE(m_tool->pointer(test::above(Kind::Release, b.x(), b.y())), ToolReply::Used);
  };
  QVERIFY(!test::isEnabled(*m_tool, "automatic"));
  drawn();
  QVERIFY(m_tool->state() == State::Ready);
  QCOMPARE(m_tool->attempt().patch.bridges.size(), std::size_t(1));
  const Patch& patch = m_tool->attempt().patch;
  const auto joins = [&](const Triangle& t) {
    int ends = 0;
    for (const std::uint32_t v : t) ends += patch.points[v] == a || patch.points[v] == b;
    return ends == 2;
  };
  QCOMPARE(std::count_if(patch.triangles.begin(), patch.triangles.end(), joins), 2);
  QVERIFY(test::isEnabled(*m_tool, "automatic"));
  drawn();
  QVERIFY(m_tool->attempt().patch.bridges.empty());
  drawn();
  m_tool->perform("automatic");
  QVERIFY(m_tool->attempt().patch.bridges.empty());
  m_tool->perform("commit");
  QVERIFY(test::countEdges(m_document->mesh()).sound());
}

// They are offered with the method that they are for, brought between their limits, and change its patch.
void FillHoleSettingsTest::weightsOfEarCutting() {
  start(test::sphereWithoutCap(3));
  const auto ids = [&] {
    std::vector<std::string> all;
    for (const Property& property : m_tool->settings()) all.push_back(property.id);
    return all;
  };
  QCOMPARE(ids(), std::vector<std::string>({"fill", "continuity", "triangles"}));
  m_tool->setSetting("fill", static_cast<double>(FillMethod::Ear));
  QCOMPARE(ids(), std::vector<std::string>({"fill", "ears_length", "ears_angles", "ears_normal", "triangles"}));
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  const std::vector<Triangle> usual = m_tool->attempt().patch.triangles;
  m_tool->setSetting("ears_length", 0.0);
  m_tool->setSetting("ears_angles", 99.0);
  m_tool->setSetting("ears_normal", std::string("much"));
  QCOMPARE(std::get<double>(m_tool->settings()[1].value), 0.0);
  QCOMPARE(std::get<double>(m_tool->settings()[2].value), 5.0);
  QCOMPARE(std::get<double>(m_tool->settings()[3].value), 1.0);
  QVERIFY(m_tool->state() == State::Ready);
  QVERIFY(m_tool->attempt().patch.triangles != usual);
}

// The top of a sphere: a membrane is flat, tangents lift it, curvature lifts it to where the sphere was.
void FillHoleSettingsTest::continuityOfFairPatches() {
  start(test::sphereWithoutCap(4));
  m_tool->pointer(test::above(Kind::Press, 0, 0));
  const auto missing = [&](double continuity) {
    m_tool->setSetting("continuity", continuity);
    double top = 0.0;
    for (const Vec3& p : m_tool->attempt().patch.points) top = std::max(top, p.z());
    return std::abs(1.0 - top);
  };
  const double position = missing(0.0), tangent = missing(1.0), curvature = missing(2.0);
  QVERIFY(tangent < 0.5 * position && curvature < 0.5 * tangent);
  QCOMPARE(missing(3.0), curvature);  // not offered
  m_tool->setSetting("fill", static_cast<double>(FillMethod::Refined));
  for (const Property& property : m_tool->settings()) QVERIFY(property.id != "continuity");
}

HANDWHEEL_TEST(FillHoleSettingsTest)
#include "FillHoleSettingsTest.moc"
