// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshDocuments.h"
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "document/mesh/MeshDocument.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "fidelity/Calibration.h"
#include "fidelity/Cases.h"
#include "mesh/measure/MeshFidelity.h"
#include "plot/PlotWidget.h"
#include "tools/mesh/MeshServices.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"

#include <QComboBox>
#include <QDockWidget>
#include <QSlider>
#include <QTranslator>
#include <filesystem>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Two squares of 4 × 4 mm, each without its middle, side by side with a gap of 1e-3 mm: 1.1e-4 of the diagonal.
std::vector<Corners> tornSheet() {
  std::vector<Corners> triangles;
  for (const float left : {0.0f, 4.001f}) {
    for (int cell = 0; cell < 16; ++cell) {
      if (cell == 5) continue;
      const auto x = left + float(cell % 4), y = float(cell / 4);
      triangles.push_back({Corner{x, y, 0}, Corner{x + 1, y, 0}, Corner{x + 1, y + 1, 0}});
      triangles.push_back({Corner{x, y, 0}, Corner{x + 1, y + 1, 0}, Corner{x, y + 1, 0}});
    }
  }
  return triangles;
}

}  // namespace

// The user's choices between speed and accuracy reach their readers, and the panel shows the effect.
class FidelityWindowTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;

  QString file(const char* name, const std::vector<Corners>& triangles) {
    const QString path = m_folder.filePath(QString::fromLatin1(name));
    writeStl(path, triangles);
    return path;
  }
  template <class Kind>
  static Kind& document(WindowDriver& driver) {
    return static_cast<Kind&>(driver.find<DocumentTabs>("tabRow")->current()->document);
  }
  static void raisePanel(WindowDriver& driver) {
    auto* dock = driver.find<QDockWidget>("fidelityDock");
    dock->show();
    dock->raise();
    driver.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver.window()));
    QTRY_VERIFY(!dock->visibleRegion().isEmpty());
  }
  static QSlider* slider(WindowDriver& driver) { return driver.find<QSlider>("fidelitySlider"); }
  static double mark(WindowDriver& driver) {  // the cost at the present point
    for (const PlotMark& each : driver.find<PlotWidget>("fidelityCurve")->plot().marks) {
      if (each.label == "now") return each.position.x();
    }
    return -1.0;
  }

 private slots:
  // A calibration that an interrupted test has left would scale the costs.
  void initTestCase() { std::filesystem::remove(defaultCalibrationFile()); }

  // The rooms that describe settings know nothing of Qt: a text that nobody marked would stay English.
  void everySettingSpeaksGerman() {
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/translations/handwheel_de")));
    const FidelityChoice choice;
    for (const auto& entry : choice.registry().entries()) {
      const FidelitySetting& setting = entry.setting;
      for (const std::string& text : {setting.label, setting.error.name, setting.cost.name}) {
        QVERIFY2(!german.translate("Fidelity", text.c_str()).isEmpty(), text.c_str());
      }
    }
  }

  void cleanup() { QSettings().remove("fidelity"); }

  // On opening, and of what a job made.
  void nearWeldHoldsWheneverDefectsAreSought() {
    const QString path = file("torn.stl", tornSheet());
    for (const auto& [chosen, pairs] : {std::pair("", 0u), std::pair("mesh.near_weld=1e-3", 5u)}) {
      QSettings().setValue("fidelity", chosen);
      WindowDriver driver;
      QVERIFY(driver.open(path));
      auto& mesh = document<MeshDocument>(driver);
      QCOMPARE(mesh.defects().nearVertices.size(), std::size_t(pairs));
      driver.clickDefect(DefectKind::Hole, 0);
      driver.click("fillHoleButton");
      QTRY_COMPARE_WITH_TIMEOUT(mesh.history()->count(), 1, kPatienceMs);
      QCOMPARE(mesh.defects().nearVertices.size(), std::size_t(pairs));
      QVERIFY(driver.settle());
    }
  }

  // The same of a change that a tool makes without a window.
  void nearWeldHoldsForToolsWithoutAWindow() {
    TriangleSoup soup;
    for (const Corners& triangle : tornSheet()) {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      for (const Corner& p : triangle) soup.points.emplace_back(p[0], p[1], p[2]);
      soup.triangles.push_back({first, first + 1, first + 2});
    }
    for (const auto& [chosen, pairs] : {std::pair(1e-5, 0u), std::pair(1e-3, 5u)}) {
      const auto mesh = meshDocument(soup);
      FidelityValues values;
      QVERIFY(values.set(nearWeldSetting(), chosen));
      mesh->setFidelity(values);
      immediateServices(*mesh).commit({"Remove", [](HalfEdgeMesh& changed, Progress progress) {
                                         changed.removeFace(2);
                                         relink(changed, progress);
                                       }});
      QCOMPARE(mesh->history()->count(), 1);
      QCOMPARE(mesh->defects().nearVertices.size(), std::size_t(pairs));
    }
  }

  void documentsHoldWhatIsChosenWhetherOpenBeforeOrAfter() {
    WindowDriver driver;
    QVERIFY(driver.open(file("before.stl", quadTorus(24, 12, {{3, 5}}))));
    raisePanel(driver);
    driver.edit("document.undo_granularity", "64");
    QCOMPARE(document<MeshDocument>(driver).fidelity().of(undoGranularitySetting()), 64.0);
    QVERIFY(driver.open(file("after.stl", quadTorus(24, 12, {{3, 5}}))));
    QCOMPARE(document<MeshDocument>(driver).fidelity().of(undoGranularitySetting()), 64.0);
  }

  // 20,000 faces: one block by default, five of 4096; for the next mesh, and in the next session.
  void blocksAreAsLargeAsChosen() {
    const auto built = [this](WindowDriver& driver, const char* name) {
      auto* view = driver.find<Viewport>("viewport");
      const int before = view->blocksBuilt();
      if (!driver.open(file(name, quadTorus(200, 50, {})))) return -1;
      view->grabImage();  // waits for them
      return view->blocksBuilt() - before;
    };
    {
      WindowDriver driver;
      QCOMPARE(built(driver, "one.stl"), 1);
      raisePanel(driver);
      driver.edit("view.block_faces", "4096");
      QCOMPARE(built(driver, "five.stl"), 5);
      QVERIFY(driver.settle());
    }
    WindowDriver driver;
    QCOMPARE(built(driver, "next.stl"), 5);
    QVERIFY(driver.settle());
  }

  void aNewWorkpieceStartsWithTheChosenChord() {
    WindowDriver driver;
    raisePanel(driver);
    driver.edit("nurbs.chord_mm", "0.25");
    driver.choose("newWorkpiece");
    QVERIFY(driver.settle());
    QCOMPARE(document<WorkpieceDocument>(driver).workpiece().chord, 0.25);
    QCOMPARE(document<WorkpieceDocument>(driver).history()->count(), 0);
    driver.edit("chord", "0.5");
    driver.edit("nurbs.chord_mm", "0.125");
    QCOMPARE(document<WorkpieceDocument>(driver).workpiece().chord, 0.5);
    const QString path = m_folder.filePath("bar.handwheel");
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", path) && driver.settle());
    WindowDriver second;
    QVERIFY(second.open(path));
    QCOMPARE(document<WorkpieceDocument>(second).workpiece().chord, 0.5);
  }

  void thePanelShowsTheSettingThatHasTheFocus() {
    WindowDriver driver;
    raisePanel(driver);
    const FidelityChoice choice;
    for (const auto& entry : choice.registry().entries()) {
      const QByteArray row = QByteArray::fromStdString("property/" + entry.setting.id);
      auto* field =
          driver.find<QWidget>(row.constData())
              ->findChild<QWidget*>(entry.setting.choices.empty() ? QString() : QStringLiteral("propertyChoice"));
      for (QWidget* each : driver.find<QWidget>(row.constData())->findChildren<QWidget*>()) {
        if (each->focusPolicy() != Qt::NoFocus && each->isVisible()) field = each;
      }
      field->setFocus();
      QTRY_COMPARE(slider(driver)->accessibleName(), QString::fromStdString(entry.setting.label));
      const auto now = choice.predicted(entry.setting.id, entry.setting.standard);
      QVERIFY(now && std::isfinite(now->error));
      QCOMPARE(mark(driver), now->cost);
      const QStringList lines = driver.text("fidelityPrediction").split('\n');
      QCOMPARE(lines.size(), 3);
      QVERIFY(lines[0].startsWith(QString::fromStdString(entry.setting.error.name)));
      QVERIFY(lines[1].endsWith(QString::fromStdString(entry.setting.cost.unit)));
      QVERIFY(lines[2].startsWith("Draft: ") && lines[2].contains("Exact: "));
    }
  }

  // The panel shows the drawing time of the drawn frames, and beside it the sum of the predictions for the settings
  // that have a part of a frame, at their present values.
  void thePanelShowsTheUseOfAFrame() {
    WindowDriver driver;
    raisePanel(driver);
    QVERIFY(driver.open(file("seen.stl", quadTorus(24, 12, {{3, 5}}))));
    auto* view = driver.find<Viewport>("viewport");
    std::vector<double> frames;
    double spent = view->timeDrawing().clock;
    connect(view, &Viewport::frameSwapped, &driver.window(), [&] {
      if (view->timeDrawing().clock > spent) frames.push_back(view->timeDrawing().clock - spent);
      spent = view->timeDrawing().clock;
    });
    for (int i = 0; i < 130; ++i) {  // more than are kept: those from before are gone
      const std::size_t before = frames.size();
      CameraState camera = view->camera();
      camera.height *= 1.01;
      view->setCamera(camera);
      QTRY_VERIFY_WITH_TIMEOUT(frames.size() > before, kPatienceMs);
    }
    QTRY_VERIFY_WITH_TIMEOUT(driver.text("frameUse").contains("of 16.7 ms"), kPatienceMs);
    QTest::qWait(1000);  // the text is made twice a second
    const auto [least, most] = std::minmax_element(frames.begin(), frames.end());
    const double shown = driver.text("frameUse").section(": ", 1).section(' ', 0, 0).toDouble();
    QVERIFY(shown >= *least - 0.05 && shown <= *most + 0.05 && shown > 0.0);
    const auto& choice = *driver.window().findChild<FidelityChoice*>();
    const auto tellsPrediction = [&] {
      double sum = 0.0;
      for (const char* id : {"nurbs.chord_mm", "turn.spacing", "document.undo_granularity", "view.block_faces"})
        sum += choice.predicted(id, choice.of(id))->cost;
      return driver.text("frameUse").section('\n', 1).contains(": " + QString::number(sum, 'f', 1) + " ms (");
    };
    QVERIFY(tellsPrediction());
    const QString before = driver.text("frameUse");
    driver.edit("view.block_faces", "262144");
    QVERIFY(tellsPrediction() && driver.text("frameUse") != before);
  }

  // While it is held it only tells; the choice is made when it is let go.
  void theSliderFollowsTheScale() {
    WindowDriver driver;
    raisePanel(driver);
    driver.edit("nurbs.chord_mm", "0.1");  // three quarters of 1e-4 … 1
    QSlider* held = slider(driver);
    QCOMPARE(held->value(), 75);
    const double before = mark(driver);
    held->setSliderDown(true);
    held->setSliderPosition(25);
    QVERIFY(mark(driver) > before);
    QCOMPARE(FidelityChoice().values().of(chordSetting()), 0.1);
    held->setSliderDown(false);
    QCOMPARE(FidelityChoice().values().of(chordSetting()), 0.001);
    QTRY_COMPARE(held->value(), 25);
  }

  void presetsAreChosenAndRecognised() {
    WindowDriver driver;
    raisePanel(driver);
    auto* box = driver.find<QWidget>("property/preset")->findChild<QComboBox*>();
    for (int i = 1; i <= 3; ++i) {
      box->setCurrentIndex(i);
      emit box->activated(i);
      QCOMPARE(FidelityChoice().values(), FidelityValues(kFidelityPresets[std::size_t(i - 1)]));
      QCOMPARE(box->currentIndex(), i);
    }
    driver.edit("view.block_faces", "5000");
    QCOMPARE(box->currentText(), QString("Custom"));
  }

  // Measured points are met, and nothing is predicted beyond its neighbours.
  void predictionsLieBetweenMeasurements() {
    const FidelityChoice choice;
    for (const auto& entry : choice.registry().entries()) {
      const FidelitySetting& setting = entry.setting;
      const auto& curve = choice.curve(setting.id);
      const bool isChoice = setting.scale == FidelityScale::Choices;
      QVERIFY(curve.size() >= (isChoice ? setting.choices.size() : std::size_t(4)));
      for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
        const CurvePoint &a = curve[i], &b = curve[i + 1];
        QVERIFY(choice.predicted(setting.id, a.value) == a);
        const double middle = isChoice ? a.value : std::sqrt(a.value * b.value);
        const auto point = choice.predicted(setting.id, middle);
        QVERIFY(point && point->cost >= std::min(a.cost, b.cost) && point->cost <= std::max(a.cost, b.cost));
        QVERIFY(point->error >= std::min(a.error, b.error) && point->error <= std::max(a.error, b.error));
      }
    }
  }
};

HANDWHEEL_WINDOW_TEST(FidelityWindowTest)
#include "FidelityWindowTest.moc"
