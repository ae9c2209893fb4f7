// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/repair/RepairJobs.h"

#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "HoleShapes.h"
#include "MeshDocuments.h"
#include "mesh/defects/Defects.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "panels/defects/RepairSummary.h"
#include "tools/mesh/repair/DefectFixes.h"
#include "tools/mesh/repair/HoleFixes.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/kinds/KindUi.h"
#include "window/mesh/HolePreview.h"
#include "window/mesh/MeshTab.h"

#include <QRegularExpression>
#include <QSemaphore>
#include <QThreadPool>
#include <QtTest>
#include <new>

using namespace handwheel;

namespace {

// A document kind that shows nothing.
class HiddenUi : public KindUi {
 public:
  std::unique_ptr<DocumentTab> open(std::unique_ptr<Document> document) override {
    return std::make_unique<MeshTab>(std::move(document), *this);
  }
  void setDocument(DocumentTab*) override {}
  void refreshVisibility() override {}
  QString panelTitle() const override { return {}; }
  QString panelIcon() const override { return {}; }
  QWidget* panel() override { return nullptr; }
  QString menuTitle() const override { return {}; }
  QList<QAction*> menu() override { return {}; }
  QList<QAction*> toolBar() override { return {}; }
  QString openedText(const DocumentTab&) const override { return {}; }
};

}  // namespace

// The messages of failed jobs on a mesh.
class RepairJobsTest : public QObject {
  Q_OBJECT

 private slots:
  // Reports the change, the reason, and the remedy; the document is unchanged. A job that the user cancelled is not
  // reported.
  void aFailureIsReported() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QList<Message> messages;
    connect(&jobs, &RepairJobs::message, this, [&](const Message& message) { messages << message; });
    tabs.add(ui.open(test::meshDocument(test::icosphere(1))));
    auto* document = static_cast<MeshTab*>(tabs.current());
    const auto fail = [&](const char* text, std::function<void()> raise) {
      jobs.change(document, {text, [raise](HalfEdgeMesh&, Progress) { raise(); }});
      QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    };
    fail("Swell", [] { throw std::bad_alloc(); });
    QCOMPARE(messages.size(), 1);
    QCOMPARE(messages[0].weight, Message::Weight::Error);
    QVERIFY2(messages[0].title.contains("Swell"), qPrintable(messages[0].title));
    QVERIFY2(messages[0].detail.contains("memory"), qPrintable(messages[0].detail));
    QVERIFY2(messages[0].advice.contains("as it was before"), qPrintable(messages[0].advice));
    fail("Shrink", [] { throw std::logic_error("a mishap"); });
    QCOMPARE(messages.size(), 2);
    QVERIFY2(messages[1].detail.contains("a mishap"), qPrintable(messages[1].detail));
    QVERIFY(!document->document.isModified());

    jobs.change(document, {"Wait", [](HalfEdgeMesh&, Progress progress) {
                             while (!progress.cancelled()) QThread::msleep(1);
                           }});
    runner.cancelAll();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(messages.size(), 2);
  }

  // While methods are compared, a worker uses the filler of the preview: the fill gets the patch, and another filler.
  void aFillWhileMethodsAreCompared() {
    WindowServices services;
    QThreadPool pool;
    pool.setMaxThreadCount(1);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    HolePreview preview(pool, services, fidelity);
    RepairJobs jobs(tabs, runner, log, fidelity);
    TriangleSoup soup = test::cube();
    soup.triangles.pop_back();
    tabs.add(ui.open(test::meshDocument(soup)));
    auto* document = static_cast<MeshTab*>(tabs.current());
    const int hole = document->defectList.holes().at(0);
    const Vertex key = document->defectList.keyOf(hole);
    const auto isReady = [&] { return preview.state().kind == PreviewState::Kind::Ready; };
    preview.request(document, hole);
    QTRY_VERIFY_WITH_TIMEOUT(isReady(), test::kPatienceMs);
    QVERIFY(preview.take(key).cache != nullptr);  // nobody uses it

    preview.request(document, hole);
    QTRY_VERIFY_WITH_TIMEOUT(isReady(), test::kPatienceMs);
    QSemaphore gate;
    pool.start([&gate] { gate.acquire(); });
    preview.compare();
    PreparedFill taken = preview.take(key);
    gate.release();
    QVERIFY(!taken.cache);
    QVERIFY(taken.attempt && !taken.attempt->patch.triangles.empty());
    jobs.fill(document, hole, std::move(taken));
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QVERIFY(document->defectList.holes().empty());
  }

  // A long change of one document neither delays those of another nor forbids them; a second one of its own waits.
  void documentsAreChangedBesideEachOther() {
    QSemaphore release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(2); });  // also if the test fails
    pool.setMaxThreadCount(kJobThreads);
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QStringList begun;
    QMutex mutex;
    const auto openOne = [&] {
      tabs.add(ui.open(test::meshDocument(test::cube())));
      return static_cast<MeshTab*>(tabs.current());
    };
    MeshTab *const slow = openOne(), *const quick = openOne();
    const auto change = [&](MeshTab* document, const char* name, bool isLong) {
      jobs.change(document, {name, [&, name, isLong](HalfEdgeMesh& mesh, Progress) {
                               {
                                 const QMutexLocker lock(&mutex);
                                 begun << QString::fromLatin1(name);
                               }
                               if (isLong) release.acquire();
                               mesh.removeFace(0);
                             }});
    };
    change(slow, "first", true);
    change(slow, "second", false);
    QVERIFY(!jobs.obstacle(slow).isEmpty());
    QVERIFY(jobs.obstacle(quick).isEmpty());
    change(quick, "instant", false);
    QTRY_VERIFY_WITH_TIMEOUT(quick->document.isModified(), test::kPatienceMs);
    QVERIFY(!slow->document.isModified() && jobs.isWorkingOn(slow));
    release.release();
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QVERIFY(begun.indexOf("first") < begun.indexOf("second"));
    QVERIFY(slow->document.isModified());
    QCOMPARE(begun.count("instant"), 1);
  }

  // A change that comes too late is made once more; if it comes too late again, the user hears of it.
  void aLateResultIsReported() {
    QSemaphore begun, release;
    QThreadPool pool;
    const auto atEnd = qScopeGuard([&] { release.release(2); });  // also if the test fails
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QList<Message> messages;
    connect(&jobs, &RepairJobs::message, this, [&](const Message& message) { messages << message; });
    tabs.add(ui.open(test::meshDocument(test::cube())));
    auto* document = static_cast<MeshTab*>(tabs.current());
    jobs.change(document, {"Dent", [&](HalfEdgeMesh& mesh, Progress) {
                             begun.release();
                             release.acquire();
                             mesh.removeFace(0);
                           }});
    for (const Face face : {Face(1), Face(2)}) {
      QVERIFY(begun.tryAcquire(1, test::kPatienceMs));
      HalfEdgeMesh cut = document->document.mesh();
      cut.removeFace(face);
      QVERIFY(document->document.commit("cut", inspected(std::move(cut))));
      QVERIFY(messages.isEmpty());
      release.release();
      QTRY_VERIFY_WITH_TIMEOUT(begun.available() > 0 || runner.isIdle(), test::kPatienceMs);
    }
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(document->document.mesh().liveFaceCount(), std::size_t{10});
    QCOMPARE(messages.size(), 1);
    QVERIFY2(messages[0].title.contains("Dent"), qPrintable(messages[0].title));
    QVERIFY2(messages[0].detail.contains("changed meanwhile"), qPrintable(messages[0].detail));
  }

  // Message, log and list have the same figures of a fix, and log and list those of a repair.
  void oneAccountOfAFix() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QList<Message> messages;
    connect(&jobs, &RepairJobs::message, this, [&](const Message& message) { messages << message; });
    TriangleSoup soup = test::cube();
    test::append(soup, test::cube(1.0, {0.40625, 0.28125, 0.34375}));
    soup.triangles.pop_back();
    tabs.add(ui.open(test::meshDocument(soup)));
    auto* document = static_cast<MeshTab*>(tabs.current());
    DefectList& defectList = document->defectList;
    const auto pairs = findSelfIntersections(document->document.mesh());
    QVERIFY(pairs && !pairs->empty());
    defectList.setSelfIntersections(document->document.revision(), *pairs);
    const auto isLogged = [&](const QString& text) {
      for (int row = 0; row < log.rowCount({}); ++row)
        if (log.index(row, 1).data().toString().contains(text)) return true;
      return false;
    };

    jobs.change(document, intersectionFix(document->document.fileNumbers(), *pairs));
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(defectList.count(DefectKind::SelfIntersection), std::size_t{0});
    QCOMPARE(*defectList.countBefore(DefectKind::SelfIntersection), pairs->size());
    const QString summary = defectSummary(defectList).join(", ");
    QVERIFY2(summary.contains(QString("%1 of %1").arg(pairs->size())), qPrintable(summary));
    QCOMPARE(messages.size(), 1);
    QVERIFY2(messages[0].detail.contains(summary), qPrintable(messages[0].detail));
    QVERIFY(isLogged(summary));

    jobs.repairAll(document);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(defectList.count(DefectKind::Hole), std::size_t{0});
    const QString repaired = defectSummary(defectList).join(", ");
    QVERIFY2(repaired.startsWith("1 of 1"), qPrintable(repaired));
    QVERIFY(isLogged(repaired));

    // Once more there is nothing to do: the summary of the repair before is not that of this one.
    const int lines = log.rowCount({});
    jobs.repairAll(document);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QVERIFY(defectSummary(defectList).isEmpty());
    QCOMPARE(log.rowCount({}), lines + 1);
    int said = 0;
    for (int row = 0; row < log.rowCount({}); ++row) said += log.index(row, 1).data().toString().contains(repaired);
    QCOMPARE(said, 1);
    QVERIFY(isLogged("nothing was changed"));
  }

  // The thickness, and how many edges of sheets were closed.
  void aThickeningHasItsAccount() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    tabs.add(ui.open(test::meshDocument(test::disc(12, 3))));
    auto* document = static_cast<MeshTab*>(tabs.current());
    jobs.change(document, thickenFix({document->defectList.keyOf(0)}, {}, 0.125));
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    const QString summary = defectSummary(document->defectList).join(", ");
    QVERIFY(summary.contains("1 of 1"));
    const QString logged = log.index(0, 1).data().toString();
    QVERIFY2(logged.contains("0.125 mm") && logged.contains(summary), qPrintable(logged));
  }

  // A flap that stood out of a cube by 0.75 mm is gone: banner and log say so, and the banner undoes it.
  void whatWasRemovedIsReported() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QList<Message> messages;
    connect(&jobs, &RepairJobs::message, this, [&](const Message& message) { messages << message; });
    TriangleSoup soup = test::cube();
    test::append(soup,
                 {{{0.375, 0.5, 1}, {0.625, 0.5, 1}, {0.625, 0.5, 1.75}, {0.375, 0.5, 1.75}}, {{0, 1, 2}, {0, 2, 3}}});
    tabs.add(ui.open(test::meshDocument(soup)));
    auto* document = static_cast<MeshTab*>(tabs.current());
    jobs.change(document, volumeRepairChange({.voxel = 0.0625}, document->document.fileNumbers()));
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QVERIFY(document->isJustRepaired());
    const auto warnings = [&] {
      QList<Message> those;
      for (const Message& each : messages)
        if (each.title.contains("check what was removed")) those << each;
      return those;
    };
    QCOMPARE(warnings().size(), 1);
    const Message banner = warnings().front();
    QCOMPARE(banner.weight, Message::Weight::Warning);
    // The surface made anew lies within half a voxel of the cube.
    const QRegularExpressionMatch stood =
        QRegularExpression("stood out by 0\\.7\\d* mm.* Z 1\\.75 mm").match(banner.detail);
    QVERIFY2(stood.hasMatch(), qPrintable(banner.detail));
    int lines = 0;
    for (int row = 0; row < log.rowCount({}); ++row) lines += log.index(row, 1).data().toString() == banner.detail;
    QCOMPARE(lines, 1);
    QVERIFY(!banner.isOver());
    banner.action();
    QVERIFY(banner.isOver());
    QVERIFY(!document->isJustRepaired());
    QCOMPARE(document->document.mesh().liveFaceCount(), soup.triangles.size());

    // A ball loses nothing that stands out: the chords of what is sampled lie within h²/8 + (√3/2 h)²/2 < 0.008 of it,
    // a quarter of what is reported of a part of this size, and there are fewer of them than it has triangles.
    messages.clear();
    tabs.add(ui.open(test::meshDocument(test::icosphere(5))));
    jobs.change(static_cast<MeshTab*>(tabs.current()), volumeRepairChange({.voxel = 0.125}, NumberType::Float64));
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QVERIFY(warnings().isEmpty());
  }

  // A remaining defect has its reason in its row.
  void reasonsForWhatStays() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QStringList why;
    connect(&jobs, &RepairJobs::changedNothing, this,
            [&](const MeshTab*, const QString&, const QString& text) { why << text; });
    TriangleSoup soup = test::cube();
    test::append(soup, test::moved(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, {3, 0, 0}));
    tabs.add(ui.open(test::meshDocument(soup)));
    auto* document = static_cast<MeshTab*>(tabs.current());
    jobs.repairAll(document);
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(why.size(), 1);
    QVERIFY2(document->defectList.reason(DefectKind::Duplicate, 0).contains("two sides of a plate"),
             qPrintable(document->defectList.reason(DefectKind::Duplicate, 0)));
    QVERIFY(document->defectList.reason(DefectKind::NonManifoldEdge, 0).isEmpty());
  }

  // Merging near vertices closes one hole and splits the other: there are two before and two after.
  void holesAreCountedByOutcome() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    QList<Message> reported;
    connect(&jobs, &RepairJobs::message, this, [&](const Message& message) { reported << message; });
    tabs.add(ui.open(test::meshDocument(test::torusWithSlits(1e-5), "/scans/part.stl", NumberType::Float64)));
    auto* document = static_cast<MeshTab*>(tabs.current());
    DefectList& defectList = document->defectList;
    QCOMPARE(defectList.count(DefectKind::Hole), std::size_t{2});
    QCOMPARE(defectList.count(DefectKind::NearVertex), std::size_t{3});
    jobs.change(document, nearVertexFix(tolerance::kNearWeld), DefectRow{DefectKind::NearVertex, -1});
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(defectList.count(DefectKind::Hole), std::size_t{2});
    const QString summary = defectSummary(defectList).join(", ");
    QCOMPARE(summary, QString("1 of 2 holes filled, 3 of 3 pairs of near vertices removed"));
    QCOMPARE(reported.size(), 1);
    QCOMPARE(reported[0].detail, summary + '.');
    QVERIFY(log.index(0, 1).data().toString().contains(summary));
  }

  // A fix that can do nothing for its row leaves the reason there, and only there.
  void aRowKeepsItsReason() {
    QThreadPool pool;
    JobRunner runner(JobRunner::Policy::Queue, pool);
    DocumentTabs tabs;
    LogModel log;
    FidelityChoice fidelity;
    HiddenUi ui;
    RepairJobs jobs(tabs, runner, log, fidelity);
    TriangleSoup soup = test::cube();
    soup.triangles.push_back(soup.triangles[3]);
    test::append(soup, test::moved(TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}, {3, 0, 0}));
    tabs.add(ui.open(test::meshDocument(soup)));
    auto* document = static_cast<MeshTab*>(tabs.current());
    const DefectList& defectList = document->defectList;
    const std::vector<Face> faces = document->document.defects().duplicateFaces;
    QCOMPARE(faces.size(), std::size_t{2});
    QSignalSpy noted(&defectList, &DefectList::reasonsChanged);
    jobs.change(document, duplicateFix({faces[1]}), DefectRow{DefectKind::Duplicate, 1});
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(noted.size(), 1);
    QVERIFY(defectList.reason(DefectKind::Duplicate, 1).contains("two sides of a plate"));
    QVERIFY(defectList.reason(DefectKind::Duplicate, 0).isEmpty());
    // The other one goes, and with it the row.
    jobs.change(document, duplicateFix({faces[0]}), DefectRow{DefectKind::Duplicate, 0});
    QTRY_VERIFY_WITH_TIMEOUT(runner.isIdle() && !jobs.isWorking(), test::kPatienceMs);
    QCOMPARE(defectList.count(DefectKind::Duplicate), std::size_t{1});
    QVERIFY(defectList.reason(DefectKind::Duplicate, 0).isEmpty());
  }
};

HANDWHEEL_WINDOW_TEST(RepairJobsTest)
#include "RepairJobsTest.moc"
