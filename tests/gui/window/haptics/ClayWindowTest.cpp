// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "SimulatedHand.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeKind.h"
#include "volume/VolumeSampler.h"
#include "volume/VolumeShapes.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/tools/ToolHost.h"
#include "window/volume/VolumeUi.h"

#include <QListWidget>
#include <QSlider>
#include <QStyleOptionSlider>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The ball that new clay is, of coarser voxels.
class CoarseClayKind : public VolumeKind {
 public:
  SnapshotPointer blank() const override {
    auto ball = std::make_shared<VolumeSnapshot>();
    ball->volume = ballOfVoxels(20.0, 0.5);
    ball->surface = VolumeSurface(ball->volume, {}, pieceCells());
    return ball;
  }
};

std::vector<KindRegistration> kindsWithCoarseClay() {
  std::vector<KindRegistration> all = builtInKinds();
  for (KindRegistration& each : all) {
    if (each.entry.kind->id() != "volume") continue;
    auto kind = std::make_unique<CoarseClayKind>();
    CoarseClayKind& known = *kind;
    each.entry.window = [&known](const WindowContext& parts) { return std::make_unique<VolumeUi>(parts, known); };
    each.entry.kind = std::move(kind);
  }
  return all;
}

// A window with a new ball of clay, 40 mm across, and the tool in use. It is as small as it can be, because software
// draws each of its pixels.
struct ClayWindow {
  WindowDriver driver;
  HapticSession& session;
  Viewport* view;

  explicit ClayWindow(std::vector<KindRegistration> kinds = kindsWithCoarseClay())
      : driver(std::move(kinds)),
        session(*driver.window().findChild<HapticSession*>()),
        view(driver.find<Viewport>("viewport")) {
    driver.window().resize(800, 600);
  }
  ~ClayWindow() { session.close(); }

  bool begin() {
    driver.choose("newVolume");
    if (!driver.settle()) return false;
    view->setStandardView(StandardView::Front);
    driver.find<QAction>("clayTool")->trigger();
    return driver.settle() && QTest::qWaitFor([this] { return view->isPickingReady(); }, kPatienceMs) && rests();
  }
  // Until the camera has come to rest, the settings of the tool having taken their room.
  bool rests() {
    for (int i = 0; i < 50; ++i) {
      const ViewRay before = view->rayAt({0, 0});
      QTest::qWait(350);
      const ViewRay after = view->rayAt({0, 0});
      if (after.origin == before.origin && after.direction == before.direction) return true;
    }
    return false;
  }
  VolumeDocument& document() {
    return static_cast<VolumeDocument&>(driver.window().findChild<DocumentTabs*>()->current()->document);
  }
  const ClayLayer& layer() { return document().volume()->layers->all().front(); }
  double depthAt(const Vec3& p) { return VolumeSampler(document().volume()->volume).depthAt(p).depth; }
  void moveTo(const QPoint& at) {
    QMouseEvent move(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
  }
  void stroke(const QPoint& from, const QPoint& to) {
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    for (int i = 0; i <= 12; ++i) {
      moveTo(from + (to - from) * i / 12);
      QTest::qWait(5);
    }
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
  }
  // The circle of the brush is not to be in the picture.
  void moveAway() {
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(view, &leave);
  }
  void leadTo(const Vec3& position, std::uint32_t buttons) { leadHandTo(session, position, buttons); }
};

// Takes the handle of a slider and leads it along, by a share of the slider's length.
void slideBy(QSlider& slider, double share) {
  QStyleOptionSlider option;
  option.initFrom(&slider);
  option.subControls = QStyle::SC_All;
  option.orientation = Qt::Horizontal;
  option.state |= QStyle::State_Horizontal;
  option.minimum = slider.minimum();
  option.maximum = slider.maximum();
  option.sliderPosition = option.sliderValue = slider.value();
  const QPoint from =
      slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider).center();
  const QPoint travel(qRound(share * slider.width()), 0);
  QTest::mousePress(&slider, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 10; ++i) {
    const QPoint at = from + travel * i / 10;
    QMouseEvent move(QEvent::MouseMove, at, slider.mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&slider, &move);
    QTest::qWait(5);
  }
  QTest::mouseRelease(&slider, Qt::LeftButton, {}, from + travel);
}

}  // namespace

// Clay is shaped in the window, by the mouse and by a simulated hand with force.
class ClayWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // A stroke over the middle of the view is one undo step; saved and opened it is the same.
  void byTheMouse() {
    const QTemporaryDir folder;
    ClayWindow clay;
    QVERIFY(clay.begin());
    const double before = clay.document().volume()->volume.material();
    const QPoint middle = clay.view->rect().center();
    clay.stroke(middle - QPoint(60, 0), middle + QPoint(60, 0));
    QTRY_COMPARE_WITH_TIMEOUT(clay.document().history()->count(), 1, kPatienceMs);
    const double carved = clay.document().volume()->volume.material();
    QVERIFY(carved < before - 1.0);
    clay.driver.click("quickActions/undo");
    QCOMPARE(clay.document().volume()->volume.material(), before);
    clay.driver.click("quickActions/redo");
    const QString path = folder.filePath("clay.handwheel");
    clay.driver.click("quickActions/saveFile");
    QVERIFY(clay.driver.enterFileName("saveDialog", path));
    QVERIFY(clay.driver.settle());
    WindowDriver second;
    QVERIFY(second.open(path));
    auto& opened = static_cast<VolumeDocument&>(second.window().findChild<DocumentTabs*>()->current()->document);
    QCOMPARE(opened.volume()->volume.material(), carved);
  }

  // Masked clay is dark and is not carved; the mask is undone, kept in the file, and cleared.
  void masked() {
    const QTemporaryDir folder;
    ClayWindow clay;
    QVERIFY(clay.begin());
    const QPoint middle = clay.view->rect().center();
    const auto brightness = [&] { return clay.view->grabImage().pixelColor(middle).value(); };
    const auto steps = [&] { return clay.document().history()->index(); };
    const int free = brightness();
    QTest::keyClick(clay.view, Qt::Key_M, Qt::ShiftModifier);
    clay.stroke(middle - QPoint(30, 0), middle + QPoint(30, 0));
    QTRY_COMPARE_WITH_TIMEOUT(steps(), 1, kPatienceMs);
    QVERIFY(clay.document().volume()->mask);
    clay.moveAway();
    QTRY_VERIFY_WITH_TIMEOUT(brightness() < free - 30, kPatienceMs);
    const int covered = brightness();
    // Across it nothing is carved where it is masked, and something beside it.
    QTest::keyClick(clay.view, Qt::Key_E, Qt::ShiftModifier);
    clay.stroke(middle - QPoint(0, 60), middle + QPoint(0, 60));
    QTRY_COMPARE_WITH_TIMEOUT(steps(), 2, kPatienceMs);
    // Just below the surface of the ball of 20 mm, where the middle of the view meets it.
    const ViewRay ray = clay.view->rayAt(middle);
    const Vec3 nearest = ray.origin - ray.origin.dot(ray.direction) * ray.direction;
    const Vec3 front = nearest - std::sqrt(19.9 * 19.9 - nearest.squaredNorm()) * ray.direction;
    QVERIFY(clay.depthAt(front) > 0.0);
    const QString path = folder.filePath("masked.handwheel");
    clay.driver.click("quickActions/saveFile");
    QVERIFY(clay.driver.enterFileName("saveDialog", path));
    QVERIFY(clay.driver.settle());
    {
      WindowDriver second;
      QVERIFY(second.open(path));
      auto& opened = static_cast<VolumeDocument&>(second.window().findChild<DocumentTabs*>()->current()->document);
      QVERIFY(opened.volume()->mask);
      QCOMPARE(opened.volume()->mask->shareAt(front), 1.0);
    }
    clay.driver.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&clay.driver.window()));
    clay.view->setFocus();
    QTest::keyClick(clay.view, Qt::Key_I, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(steps(), 3, kPatienceMs);
    QCOMPARE(clay.document().volume()->mask->shareAt(front), 0.0);
    clay.moveAway();
    QTRY_VERIFY_WITH_TIMEOUT(brightness() > covered + 30, kPatienceMs);
    QTest::keyClick(clay.view, Qt::Key_D, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(steps(), 4, kPatienceMs);
    QVERIFY(!clay.document().volume()->mask);
    clay.driver.click("quickActions/undo");
    clay.driver.click("quickActions/undo");
    QCOMPARE(clay.document().volume()->mask->shareAt(front), 1.0);
  }

  // A picture is loaded as a stamp and pressed into the clay of the program; a file that is none is said, and nothing
  // changes.
  void stamped() {
    const QTemporaryDir folder;
    ClayWindow clay(builtInKinds());
    QVERIFY(clay.begin());
    QImage white(16, 16, QImage::Format_RGB32);
    white.fill(Qt::white);
    QVERIFY(white.save(folder.filePath("white.png")));
    QFile broken(folder.filePath("broken.png"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write(QByteArray::fromHex("89504e470d0a1a0a0000"));
    broken.close();
    clay.driver.find<QAction>("volumeStamp")->trigger();
    QVERIFY(clay.driver.enterFileName("stampDialog", broken.fileName()));
    QTRY_VERIFY_WITH_TIMEOUT(clay.driver.text("messageText").contains("stamp"), kPatienceMs);
    QTest::keyClick(clay.view, Qt::Key_A, Qt::ShiftModifier);
    QTest::keyClick(clay.view, Qt::Key_L, Qt::ShiftModifier);
    QVERIFY(clay.driver.enterFileName("stampDialog", folder.filePath("white.png")));
    const auto chosen = [&] {
      for (const Property& setting : clay.driver.window().findChild<ToolHost*>()->runner().tool()->settings())
        if (setting.id == "stamp") return setting.choices.at(static_cast<std::size_t>(std::get<double>(setting.value)));
      return std::string();
    };
    QTRY_COMPARE_WITH_TIMEOUT(chosen(), std::string("white.png"), kPatienceMs);
    QVERIFY(clay.driver.settle() && clay.rests());
    const QPoint middle = clay.view->rect().center();
    const ViewRay ray = clay.view->rayAt(middle);
    const auto height = [&] {
      return firstHit(clay.document().volume()->volume, ray.origin, ray.direction)->point.norm();
    };
    QTest::mouseClick(clay.view, Qt::LeftButton, {}, middle);
    QTRY_COMPARE_WITH_TIMEOUT(clay.document().history()->count(), 1, kPatienceMs);
    // A quarter of the radius, 2 mm, by the strength, one half.
    QVERIFY2(std::abs(height() - 20.25) < 0.05, qPrintable(QString::number(height())));
    clay.driver.click("quickActions/undo");
    QVERIFY(std::abs(height() - 20.0) < 0.01);
  }

  // Undo in the middle of a stroke takes that stroke.
  void undoTakesTheStroke() {
    ClayWindow clay;
    QVERIFY(clay.begin());
    const auto before = clay.document().volume();
    const QPoint middle = clay.view->rect().center();
    QTest::mousePress(clay.view, Qt::LeftButton, {}, middle);
    clay.moveTo(middle + QPoint(40, 0));
    auto* undo = clay.driver.find<QAction>("undo");
    QTRY_VERIFY(undo->isEnabled());
    undo->trigger();
    QTest::mouseRelease(clay.view, Qt::LeftButton, {}, middle + QPoint(40, 0));
    QCOMPARE(clay.document().volume(), before);
    QCOMPARE(clay.document().history()->count(), 0);
  }

  // A layer is added in its panel, sculpted on, weakened by one drag, turned off and merged; each is an undo step.
  void layers() {
    ClayWindow clay;
    QVERIFY(clay.begin());
    const auto material = [&] { return clay.document().volume()->volume.material(); };
    const auto steps = [&] { return clay.document().history()->index(); };
    const double ball = material();
    clay.driver.choose("clayLayersToggle");
    auto* const list = clay.driver.find<QListWidget>("clayLayers");
    QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), kPatienceMs);
    clay.driver.click("clayLayerAdd");
    QCOMPARE(list->count(), 1);
    QVERIFY(clay.rests());
    QTRY_VERIFY_WITH_TIMEOUT(clay.view->isPickingReady(), kPatienceMs);
    const QPoint middle = clay.view->rect().center();
    clay.stroke(middle - QPoint(40, 0), middle + QPoint(40, 0));
    QTRY_COMPARE_WITH_TIMEOUT(steps(), 2, kPatienceMs);
    const double carved = material();
    QVERIFY(carved < ball);
    auto* const strength = clay.driver.find<QSlider>("clayLayerStrength");
    strength->setSliderDown(true);
    for (const int value : {80, 60, 50}) strength->setValue(value);
    strength->setSliderDown(false);
    QTRY_COMPARE_WITH_TIMEOUT(clay.layer().strength, 0.5, kPatienceMs);
    QCOMPARE(steps(), 3);
    QVERIFY(material() > carved && material() < ball);
    list->item(0)->setCheckState(Qt::Unchecked);
    QTRY_COMPARE_WITH_TIMEOUT(steps(), 4, kPatienceMs);
    QCOMPARE(material(), ball);
    list->item(0)->setText(QStringLiteral("Groove"));
    QCOMPARE(steps(), 5);
    QCOMPARE(clay.layer().name, std::string("Groove"));
    for (int i = 0; i < 3; ++i) clay.document().history()->undo();
    QCOMPARE(material(), carved);
    QCOMPARE(strength->value(), 100);
    QCOMPARE(list->item(0)->checkState(), Qt::Checked);
    clay.driver.click("clayLayerMerge");
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 0, kPatienceMs);
    QVERIFY(!clay.document().volume()->layers);
    QCOMPARE(material(), carved);
    clay.document().history()->undo();
    QCOMPARE(list->count(), 1);
    clay.driver.click("clayLayerRemove");
    clay.document().settle();  // like saving, while the volume without the layer is being computed
    QCOMPARE(list->count(), 0);
    QCOMPARE(material(), ball);
    clay.document().history()->undo();
    QCOMPARE(material(), carved);
    clay.driver.click("clayLayerRemove");
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 0, kPatienceMs);
    QCOMPARE(material(), ball);
    clay.document().history()->undo();
    clay.driver.click("clayLayerRemove");
    clay.document().settle();
    clay.document().history()->undo();
    clay.driver.click("clayLayerMerge");  // acts on the same volume, before the result of removing it arrives
    QTRY_COMPARE_WITH_TIMEOUT(list->count(), 0, kPatienceMs);
    QCOMPARE(material(), carved);
  }

  // A layer is made, sculpted by the mouse, weakened by a drag of the slider and turned off; all is undone and done
  // again, and what is saved and opened is the same: weak, off, and at full strength.
  void layersInAFile() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("layers.handwheel");
    double ball = 0.0, carved = 0.0, weak = 0.0, strengthThen = 0.0;
    {
      ClayWindow clay;
      QVERIFY(clay.begin());
      const auto material = [&] { return clay.document().volume()->volume.material(); };
      const auto steps = [&] { return clay.document().history()->index(); };
      ball = material();
      clay.driver.choose("clayLayersToggle");
      auto* const list = clay.driver.find<QListWidget>("clayLayers");
      QTRY_VERIFY_WITH_TIMEOUT(list->isVisible(), kPatienceMs);
      clay.driver.click("clayLayerAdd");
      QVERIFY(clay.rests());
      QTRY_VERIFY_WITH_TIMEOUT(clay.view->isPickingReady(), kPatienceMs);
      const QPoint middle = clay.view->rect().center();
      clay.stroke(middle - QPoint(40, 0), middle + QPoint(40, 0));
      QTRY_COMPARE_WITH_TIMEOUT(steps(), 2, kPatienceMs);
      carved = material();
      QVERIFY(carved < ball);
      auto* const slider = clay.driver.find<QSlider>("clayLayerStrength");
      slideBy(*slider, -0.4);
      QVERIFY(slider->value() < 90 && slider->value() > 10);
      strengthThen = slider->value() / 100.0;
      QTRY_COMPARE_WITH_TIMEOUT(clay.layer().strength, strengthThen, kPatienceMs);
      QCOMPARE(steps(), 3);
      weak = material();
      QVERIFY(weak > carved && weak < ball);
      list->setCurrentRow(0);
      QTest::keyClick(list, Qt::Key_Space);
      QTRY_COMPARE_WITH_TIMEOUT(steps(), 4, kPatienceMs);
      QVERIFY(!clay.layer().isOn);
      QCOMPARE(material(), ball);
      const std::vector<double> materials{ball, ball, carved, weak, ball};
      for (int i = 4; i > 0; --i) {
        clay.driver.click("quickActions/undo");
        QCOMPARE(steps(), i - 1);
        QCOMPARE(material(), materials[static_cast<std::size_t>(i - 1)]);
      }
      QVERIFY(!clay.document().volume()->layers);
      QCOMPARE(list->count(), 0);
      for (int i = 1; i <= 4; ++i) {
        clay.driver.click("quickActions/redo");
        QCOMPARE(material(), materials[static_cast<std::size_t>(i)]);
      }
      clay.driver.click("quickActions/saveFile");
      QVERIFY(clay.driver.enterFileName("saveDialog", path));
      QVERIFY(clay.driver.settle());
    }
    WindowDriver second;
    QVERIFY(second.open(path));
    auto& opened = static_cast<VolumeDocument&>(second.window().findChild<DocumentTabs*>()->current()->document);
    QVERIFY(opened.volume()->layers);
    QCOMPARE(opened.volume()->volume.material(), ball);
    auto* const list = second.find<QListWidget>("clayLayers");
    QCOMPARE(list->count(), 1);
    QCOMPARE(list->item(0)->checkState(), Qt::Unchecked);
    auto* const slider = second.find<QSlider>("clayLayerStrength");
    QCOMPARE(slider->value(), qRound(100.0 * strengthThen));
    list->setCurrentRow(0);
    QTest::keyClick(list, Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(opened.volume()->volume.material(), weak, kPatienceMs);
    QTest::keyClick(slider, Qt::Key_End);
    QTRY_COMPARE_WITH_TIMEOUT(opened.volume()->volume.material(), carved, kPatienceMs);
  }

  // The hand feels the ball with a tool and without; pressed with the button held it carves.
  void byTheHand() {
    ClayWindow clay;
    QVERIFY(clay.begin());
    clay.session.choose("simulated", "hand");
    QVERIFY(QTest::qWaitFor([&] { return clay.session.latest() != nullptr; }, kPatienceMs) && clay.driver.settle());
    const auto felt = [&] { return clay.session.latest()->felt; };
    const auto isAt = [&](double x) { return std::abs(clay.session.latest()->tip.position.x() - x) < 1.0; };
    clay.leadTo({26.0, 0.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(isAt(26.0), kPatienceMs);
    clay.leadTo({16.0, 0.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(felt().isContact && felt().force.x() > 0.05, kPatienceMs);
    QVERIFY(std::abs(felt().proxy.norm() - 20.0) < 0.2);
    clay.leadTo({16.0, 0.0, 0.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(felt().proxy.x() < 17.0, kPatienceMs);
    clay.leadTo({26.0, 0.0, 0.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(isAt(26.0), kPatienceMs);
    clay.leadTo({26.0, 0.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(clay.document().history()->count() == 1, kPatienceMs);
    QVERIFY(clay.depthAt({19.0, 0.0, 0.0}) < 0.0);
    QVERIFY(clay.depthAt({0.0, 19.0, 0.0}) > 0.0);
    // Without the tool it is felt as it is now.
    QTest::keyClick(clay.view, Qt::Key_Escape);
    clay.driver.find<QAction>("clayTool")->setChecked(false);
    clay.leadTo({0.0, 26.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(clay.session.latest()->tip.position.y() > 25.0, kPatienceMs);
    clay.leadTo({0.0, 16.0, 0.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(felt().isContact && felt().force.y() > 0.05, kPatienceMs);
  }
};

HANDWHEEL_WINDOW_TEST(ClayWindowTest)
#include "ClayWindowTest.moc"
